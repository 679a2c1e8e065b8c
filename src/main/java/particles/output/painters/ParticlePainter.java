package particles.output.painters;

import particles.output.raster.CameraProjection.Place;
import particles.output.raster.RoundShapes;
import particles.view.ParticleStyle;
import particles.view.RenderOptions;

/**
 * Draws particles as balls or points, fixed ones always as balls; blobs are drawn together, glow and trails later, over
 * everything else.
 */
public record ParticlePainter(RoundShapes shapes, RenderOptions look, VisibilityFilter shown, DrawnSizes sizes) {

    /** Draws the balls and points of a frame. */
    void paint(FrameState state, Place[] places) {
        ParticleStyle.Kind kind = look.style().kind();
        double point = sizes.point() * shapes.view().height / shapes.view().viewHeight;     // points are all alike
        for (int i = 0; i < state.particles(); i++) {
            if (!shown.particle(i)) {
                continue;
            }
            int rgb = state.structure().colour(i,
                    state.isFixed(i) ? look.colours().fixed() : look.colours().particle());
            if (state.isFixed(i) || kind == ParticleStyle.Kind.BALLS) {
                double radius = state.structure().radius(i,
                        kind == ParticleStyle.Kind.GLOW ? sizes.core() : sizes.ball());
                shapes.ball(places[i], radius * places[i].scale(), radius, rgb);
            } else if (kind == ParticleStyle.Kind.POINTS) {
                shapes.ball(places[i], point, 0, rgb);
            }
        }
    }
}
