/** Checks of a student's force law: how it writes its forces, and whether its declared properties hold. */
package particles.teaching.effects;
