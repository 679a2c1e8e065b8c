/** Laws that act between steps: bounces, and the changes of what touches, slides and sticks. */
package particles.rules;
