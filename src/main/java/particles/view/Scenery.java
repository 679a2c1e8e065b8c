package particles.view;

import java.util.List;
import particles.law.Plane;
import particles.law.Sphere;

/**
 * What a scene has to be drawn beside its particles and springs.
 *
 * @param surfaces surfaces that particles span
 * @param planes   the ground and other planes that particles meet
 * @param spheres  the balls and hollows that they meet
 * @param wires    the curves along which they slide
 */
public record Scenery(List<Surface> surfaces, List<Plane> planes, List<Sphere> spheres, List<CurveView> wires) {
    /** Nothing but particles and springs. */
    public static final Scenery NONE = new Scenery(List.of(), List.of(), List.of(), List.of());

    /** Copies the lists. */
    public Scenery {
        surfaces = List.copyOf(surfaces);
        planes = List.copyOf(planes);
        spheres = List.copyOf(spheres);
        wires = List.copyOf(wires);
    }
}
