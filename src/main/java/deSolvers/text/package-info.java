/** Numbers as people read them. */
package deSolvers.text;
