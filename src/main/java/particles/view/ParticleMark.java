package particles.view;

import java.util.OptionalInt;

/**
 * The drawing style of one particle that differs from all others.
 *
 * @param particle its id
 * @param colour   its colour and that of its trail, 0xRRGGBB, if it has one of its own
 * @param radius   the radius of its ball (m); 0 for that of all others
 * @param label    the text beside it; empty for none
 */
public record ParticleMark(String particle, OptionalInt colour, double radius, String label) {
}
