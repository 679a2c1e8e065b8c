package particles.output.painters;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import particles.law.Vector3;
import particles.output.painters.SurfacePainter.IntactTriangles;
import particles.output.raster.CameraProjection.Place;
import particles.output.raster.RoundShapes;
import particles.view.ParticleStyle;
import particles.view.RenderOptions;
import particles.view.Scenery;

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
 * @param wires    the painter of wires
 */
public record OpaquePainter(RoundShapes shapes, RenderOptions look, DrawnSizes sizes, VisibilityFilter shown,
        SurfacePainter surfaces, SpringPainter springs, WirePainter wires) {

    /**
     * @param look    the render options
     * @param scenery the things besides particles and springs
     * @param target  the middle of the picture (m)
     * @return draws all of that
     */
    public static OpaquePainter of(RoundShapes shapes, RenderOptions look, Scenery scenery, Vector3 target,
            DrawnSizes sizes) {
        VisibilityFilter shown = new VisibilityFilter(look, scenery.surfaces());
        List<IntactTriangles> surfaces = scenery.surfaces().stream().map(IntactTriangles::new).toList();
        return new OpaquePainter(shapes, look, sizes, shown, new SurfacePainter(shapes, look, surfaces),
                new SpringPainter(shapes, look, sizes),
                WirePainter.of(shapes, scenery.wires(), target, sizes.railing()));
    }

    /**
     * @param blobs the surface around particles, if they are blobs
     * @return whether a spring is visible whose colour shows its strain
     */
    public boolean paint(FrameState state, Optional<BlobPainter> blobs) {
        Place[] places = state.places(shapes.view());
        surfaces.paint(state, places);
        boolean strained = springs.paint(state, places, shown);
        wires.paint();
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
}
