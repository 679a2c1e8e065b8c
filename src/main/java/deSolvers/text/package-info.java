/** Numbers as people read them, and the name that was probably meant. */
package deSolvers.text;
