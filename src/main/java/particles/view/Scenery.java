package particles.view;

import java.util.List;
import particles.law.Plane;
import particles.law.Sphere;

/**
 * Things to draw beside particles and springs: surfaces, planes, spheres and wires.
 *
 * @param surfaces surfaces that particles span
 * @param planes   the ground and other planes that particles meet
 * @param spheres  the balls and hollows that they meet
 * @param wires    the curves along which they slide
 */
public record Scenery(List<Surface> surfaces, List<Plane> planes, List<Sphere> spheres, List<CurveView> wires) {
    /** No scenery. */
    public static final Scenery NONE = new Scenery(List.of(), List.of(), List.of(), List.of());

    /** Copies the lists. */
    public Scenery {
        surfaces = List.copyOf(surfaces);
        planes = List.copyOf(planes);
        spheres = List.copyOf(spheres);
        wires = List.copyOf(wires);
    }
}
