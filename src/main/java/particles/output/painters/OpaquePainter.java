package particles.output.painters;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import particles.law.Vector3;
import particles.output.painters.SurfacePainter.IntactTriangles;
import particles.output.raster.CameraProjection;
import particles.output.raster.CameraProjection.Place;
import particles.output.raster.RoundShapes;
import particles.view.ParticleStyle;
import particles.view.RenderOptions;
import particles.view.Scenery;
import particles.view.Scenery.CurveView;

/**
 * Draws all that is opaque in a frame, as one camera sees it: the camera of the picture or, for shadows, the lamp.
 * Particles are balls or points, fixed ones always balls; glow and trails are drawn later, over everything else.
 *
 * @param shapes   draws onto the camera's raster
 * @param look     the render options
 * @param sizes    the sizes of balls and points
 * @param shown    the filter of the things drawn
 * @param surfaces the painter of surfaces
 * @param springs  the painter of springs and rods
 * @param wires    each wire's points; infinite ones are cut off outside the picture
 */
public record OpaquePainter(RoundShapes shapes, RenderOptions look, DrawnSizes sizes, VisibilityFilter shown,
        SurfacePainter surfaces, SpringPainter springs, List<Place[]> wires) {
    private static final int WIRE = 0x75808d;
    /** The pieces of a wire per height of the picture. */
    private static final int PIECES = 120;
    private static final int FEWEST = 96;
    private static final int MOST = 20_000;
    /**
     * The distance (in picture heights) over which an infinite curve is searched for its point nearest to the centre of
     * the picture.
     */
    private static final int SEARCH = 60;

    /**
     * @param look    the render options
     * @param scenery the things besides particles and springs
     * @param target  the middle of the picture (m)
     * @return draws all of that
     */
    public static OpaquePainter of(RoundShapes shapes, RenderOptions look, Scenery scenery, Vector3 target,
            DrawnSizes sizes, VisibilityFilter shown) {
        List<IntactTriangles> surfaces = scenery.surfaces().stream().map(IntactTriangles::new).toList();
        return new OpaquePainter(shapes, look, sizes, shown, new SurfacePainter(shapes, look, surfaces),
                new SpringPainter(shapes, look, sizes),
                scenery.wires().stream().map(curve -> points(curve, shapes.view(), target)).toList());
    }

    /**
     * @param blobs the surface around particles, if they are blobs
     * @return whether a spring is visible whose colour shows its strain
     */
    public boolean paint(FrameState state, Optional<BlobPainter> blobs) {
        Place[] places = state.places(shapes.view());
        surfaces.paint(state, places);
        boolean strained = springs.paint(state, places, shown);
        wires.forEach(wire -> shapes.tubes(wire, sizes.railing(), WIRE));
        IntStream.range(0, places.length).filter(shown::particle).forEach(i -> paint(state, i, places[i]));
        blobs.ifPresent(painter -> painter.paint(shapes));
        return strained;
    }

    private void paint(FrameState state, int i, Place at) {
        ParticleStyle.Kind kind = look.style().kind();
        boolean fixed = state.isFixed(i);
        int rgb = state.structure().colour(i, fixed ? look.colours().fixed() : look.colours().particle());
        if (fixed || kind == ParticleStyle.Kind.BALLS) {
            double radius = state.structure().radius(i,
                    kind == ParticleStyle.Kind.GLOW ? sizes.core() : sizes.ball());
            shapes.ball(at, radius * at.scale(), radius, rgb);
        } else if (kind == ParticleStyle.Kind.POINTS) {
            double point = sizes.point() * shapes.view().height / shapes.view().viewHeight;     // points are all alike
            shapes.ball(at, point, 0, rgb);
        }
    }

    /** The points of a curve, or of the part of an infinite one that is near the target. */
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
}
