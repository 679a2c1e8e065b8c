package particles.output.painters;

import java.util.Optional;
import particles.output.raster.CameraProjection;
import particles.output.raster.Raster;
import particles.output.raster.RoundShapes;
import particles.view.ParticleStyle;
import particles.view.RenderOptions;

/**
 * Draws particles as balls, points or blobs, fixed ones always as balls; glow and trails are drawn later, over
 * everything else.
 */
public record ParticlePainter(RoundShapes shapes, Optional<BlobPainter> blobs, CameraProjection view,
        RenderOptions look, VisibilityFilter shown, DrawnSizes sizes) {
    /** The radius of a point, relative to the picture's height. */
    private static final double POINT = 0.0026;

    private ParticleStyle.Kind kind() {
        return look.style().kind();
    }

    /** @return the distance by which a particle at rest on a plane extends below its centre (m) */
    public double reach(FrameState state) {
        boolean large = false;
        for (int i = 0; i < state.particles && !large; i++) {
            large = shown.particle(i);
        }
        boolean thick = kind() == ParticleStyle.Kind.BALLS || kind() == ParticleStyle.Kind.BLOBS;
        return large && thick ? sizes.ball() : 0.003 * view.viewHeight;
    }

    /** @return whether particle i is a ball */
    boolean isBall(FrameState state, int i) {
        return shown.particle(i) && (state.fixed[i] || kind() == ParticleStyle.Kind.BALLS);
    }

    /** @return the radius of particle i's ball (m) */
    double ball(FrameState state, int i) {
        return state.radius(i, kind() == ParticleStyle.Kind.GLOW ? sizes.core() : sizes.ball());
    }

    /** @return whether particle i is a point */
    boolean isPoint(FrameState state, int i) {
        return shown.particle(i) && !state.fixed[i] && kind() == ParticleStyle.Kind.POINTS;
    }

    /** @return the radius of a point (m), in the plane through the middle of the picture */
    double point() {
        return POINT * view.viewHeight;
    }

    /** Draws all particles of a frame except glowing ones. */
    public void paint(FrameState state, ProjectedParticles projected) {
        int count = 0;
        double[] inBlobs = new double[blobs.isPresent() ? 3 * state.particles : 0];
        for (int i = 0; i < state.particles; i++) {
            if (isBall(state, i) && projected.visible[i]) {
                double radius = ball(state, i);
                shapes.ball(projected.x[i], projected.y[i], radius * projected.scale[i], projected.depth[i], radius,
                        state.colour(i, state.fixed[i] ? look.colours().fixed() : look.colours().particle()));
            } else if (isPoint(state, i) && projected.visible[i]) {
                shapes.ball(projected.x[i], projected.y[i], Raster.SAMPLES * POINT * view.height, projected.depth[i], 0,
                        state.colour(i, look.colours().particle()));
            } else if (blobs.isPresent() && !state.fixed[i] && shown.particle(i)) {
                System.arraycopy(state.positions, 3 * i, inBlobs, 3 * count++, 3);
            }
        }
        if (blobs.isPresent()) {
            blobs.get().paint(inBlobs, count, sizes.ball(), look.colours().particle());
        }
    }
}
