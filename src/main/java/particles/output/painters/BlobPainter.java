package particles.output.painters;

import java.util.List;
import java.util.stream.IntStream;
import particles.law.Vector3;
import particles.output.raster.CameraProjection.Direction;
import particles.output.raster.CameraProjection.Place;
import particles.output.raster.Colours;
import particles.output.raster.Lighting;
import particles.output.raster.RoundShapes;

/** Draws particles as a smooth wet surface, with a sharp highlight and a reflection of the sky at its rim. */
public final class BlobPainter {
    private static final int SKY_IN_IT = 0xf3f7fb;
    /** The smallest useful cell (pixels). */
    private static final double FINEST = 2.5;

    private final int rgb;
    private BlobSurface surface;

    /** @param rgb the colour of the particles */
    public BlobPainter(int rgb) {
        this.rgb = rgb;
    }

    /**
     * Makes the surface of a frame.
     *
     * @param radius the radius of a single ball (m)
     * @param pixel  the width of a pixel in the middle of the picture (m)
     */
    public void build(FrameState state, VisibilityFilter shown, double radius, double pixel) {
        List<Vector3> balls = IntStream.range(0, state.particles())
                .filter(i -> !state.isFixed(i) && shown.particle(i)).mapToObj(state::place).toList();
        surface = new BlobSurface(new BlobField(radius, balls, FINEST * pixel));
    }

    /** Draws the surface as a camera sees it. */
    void paint(RoundShapes shapes) {
        Place[] places = surface.vertices.stream().map(shapes.view()::place).toArray(Place[]::new);
        int[] colours = surface.normals.stream()
                .mapToInt(normal -> colour(shapes.view().turned(normal), shapes.lighting())).toArray();
        for (int k = 0; k < surface.corners.size(); k += 3) {
            shapes.raster().triangle(surface.corners.buffer, k, places, colours);
        }
    }

    private int colour(Direction normal, Lighting lighting) {
        float grazing = 1 - Math.max(0, normal.back());
        int wet = Colours.mix(rgb, SKY_IN_IT,
                0.45 * grazing * grazing * grazing * Math.max(0, 0.6f + 0.4f * normal.up()));
        return lighting.shade(wet, normal, 1.6f);
    }
}
