package particles.view;

import java.util.List;
import java.util.stream.IntStream;
import particles.law.Plane;
import particles.law.Sphere;
import particles.law.Vector3;

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

    /**
     * A surface spanned by particles, to be drawn shaded.
     *
     * @param triangles indices of particles, three a triangle, counter-clockwise seen from the front
     * @param ofSprings whether springs along the edges hold it together: a triangle with fewer than two of them left is
     *                  torn and not drawn
     */
    public record Surface(int[] triangles, boolean ofSprings) {
        /** @return a convex polygon as triangles around its first corner */
        public static IntStream triangles(int[] corners) {
            return IntStream.range(2, corners.length).flatMap(k -> IntStream.of(corners[0], corners[k - 1],
                    corners[k]));
        }
    }

    /** A curve in space, as needed for drawing. */
    public interface CurveView {
        /**
         * @param u the curve's parameter, a length along the curve or along a straight line beside it (m); any number
         * @return the point (m)
         */
        Vector3 at(double u);

        /** @return the u at which a closed curve is back at its beginning (m); infinity for an open one */
        double length();
    }
}
