/**
 * Rules that act between steps, never inside the derivative: impacts, contact, sliding and sticking; birth, death and
 * tearing; projection onto constraints. The prescribed motions of moving anchors are here too.
 */
package particles.rules;
