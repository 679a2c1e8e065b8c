/**
 * What acts between steps, never inside the derivative: bounces and the changes of what touches, slides and sticks;
 * birth, death and tearing; constraints that are put right. The given motions of anchors are here too.
 */
package particles.rules;
