package particles.view;

import java.util.OptionalInt;

/**
 * How one particle is drawn otherwise than all the others.
 *
 * @param particle its id
 * @param colour   its colour and that of its trail, 0xRRGGBB, if it has one of its own
 * @param radius   the radius of its ball (m); 0 for that of all others
 * @param label    what is written beside it; empty for nothing
 */
public record ParticleMark(String particle, OptionalInt colour, double radius, String label) {
}
