package particles.output.painters;

import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import particles.law.Vector3;
import particles.output.raster.CameraProjection;
import particles.output.raster.CameraProjection.Place;
import particles.output.raster.RoundShapes;
import particles.view.Scenery.CurveView;

/**
 * Draws curves in space as wires; infinite ones are cut off outside the picture.
 *
 * @param shapes draws onto the camera's raster
 * @param radius the radius of the wires (m)
 * @param wires  each wire's points
 */
public record WirePainter(RoundShapes shapes, double radius, List<Place[]> wires) {
    static final int COLOUR = 0x75808d;
    /** Pieces per height of the picture. */
    private static final int PIECES = 120;
    private static final int FEWEST = 96;
    private static final int MOST = 20_000;
    /**
     * The distance (in picture heights) over which an infinite curve is searched for its point nearest to the centre of
     * the picture.
     */
    private static final int SEARCH = 60;

    /**
     * @param target the middle of the picture (m)
     * @param radius the radius of the wires (m)
     */
    static WirePainter of(RoundShapes shapes, List<CurveView> curves, Vector3 target, double radius) {
        CameraProjection view = shapes.view();
        return new WirePainter(shapes, radius, curves.stream().map(curve -> points(curve, view, target))
                .toList());
    }

    private static Place[] points(CurveView curve, CameraProjection view, Vector3 target) {
        double from = 0;
        double to = curve.length();
        if (to == Double.POSITIVE_INFINITY) {
            double nearest = IntStream.rangeClosed(-2 * SEARCH, 2 * SEARCH).mapToObj(k -> k * view.viewHeight / 2)
                    .min(Comparator.comparingDouble(u -> curve.at(u).minus(target).length())).orElseThrow();
            double reach = 2 * view.viewHeight * Math.max(1, (double) view.width / view.height);
            from = nearest - reach;
            to = nearest + reach;
        }
        int pieces = (int) Math.max(FEWEST, Math.min(MOST, Math.ceil(PIECES * (to - from) / view.viewHeight)));
        double start = from;
        double range = to - from;
        return IntStream.rangeClosed(0, pieces).mapToObj(k -> view.place(curve.at(start + range * k / pieces)))
                .toArray(Place[]::new);
    }

    /** Draws all wires. */
    void paint() {
        wires.forEach(wire -> shapes.tubes(wire, radius, COLOUR));
    }
}
