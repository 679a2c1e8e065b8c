package particles.output.painters;

import particles.output.raster.Raster;
import particles.output.raster.RoundShapes;
import particles.view.ParticleStyle;
import particles.view.RenderOptions;

/**
 * Draws particles as balls or points, fixed ones always as balls; blobs are drawn together, glow and trails later, over
 * everything else.
 */
public record ParticlePainter(RoundShapes shapes, RenderOptions look, VisibilityFilter shown, DrawnSizes sizes) {

    /** Draws the balls and points of a frame. */
    void paint(FrameState state, ProjectedParticles projected) {
        ParticleStyle.Kind kind = look.style().kind();
        double scale = Raster.SAMPLES * shapes.view().height / shapes.view().viewHeight;    // points are all alike
        for (int i = 0; i < state.particles; i++) {
            if (!shown.particle(i) || !projected.visible[i]) {
                continue;
            }
            if (state.fixed[i] || kind == ParticleStyle.Kind.BALLS) {
                double radius = state.radius(i, kind == ParticleStyle.Kind.GLOW ? sizes.core() : sizes.ball());
                paint(state, projected, i, radius * projected.scale[i], radius);
            } else if (kind == ParticleStyle.Kind.POINTS) {
                paint(state, projected, i, sizes.point() * scale, 0);
            }
        }
    }

    /**
     * @param radius    in samples
     * @param thickness how far it stands out towards the camera (m)
     */
    private void paint(FrameState state, ProjectedParticles projected, int i, double radius, double thickness) {
        int rgb = state.colour(i, state.fixed[i] ? look.colours().fixed() : look.colours().particle());
        shapes.ball(projected.x[i], projected.y[i], radius, projected.depth[i], thickness, rgb);
    }
}
