/** Checks a force law: how it writes its forces, and whether it keeps what it claims. */
package particles.teaching.effects;
