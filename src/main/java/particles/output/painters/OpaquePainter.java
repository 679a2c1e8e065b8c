package particles.output.painters;

import java.util.List;
import java.util.Optional;
import particles.law.Vector3;
import particles.output.raster.CameraProjection.Place;
import particles.output.raster.RoundShapes;
import particles.view.RenderOptions;
import particles.view.Scenery;

/**
 * Draws all that is opaque in a frame, as one camera sees it: the camera of the picture or, for shadows, the lamp.
 *
 * @param shapes    draws onto the camera's raster
 * @param shown     the filter of the things drawn
 * @param surfaces  the painter of surfaces
 * @param springs   the painter of springs and rods
 * @param wires     the painter of wires
 * @param particles the painter of balls and points
 */
public record OpaquePainter(RoundShapes shapes, VisibilityFilter shown, SurfacePainter surfaces, SpringPainter springs,
        WirePainter wires, ParticlePainter particles) {

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
        return new OpaquePainter(shapes, shown, new SurfacePainter(shapes, look, surfaces),
                new SpringPainter(shapes, look, sizes),
                WirePainter.of(shapes, scenery.wires(), target, sizes.railing()),
                new ParticlePainter(shapes, look, shown, sizes));
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
        particles.paint(state, places);
        blobs.ifPresent(painter -> painter.paint(shapes));
        return strained;
    }
}
