package particles.output.painters;

import java.util.List;
import java.util.stream.IntStream;
import particles.law.Vector3;
import particles.output.raster.CameraProjection.Place;
import particles.output.raster.Colours;
import particles.output.raster.Direction;
import particles.output.raster.Lighting;
import particles.output.raster.RoundShapes;

/** Draws particles as a smooth wet surface, with a sharp highlight and a reflection of the sky at its rim. */
public final class BlobPainter {
    private static final int SKY_IN_IT = 0xf3f7fb;
    /** The smallest useful cell (pixels). */
    private static final double FINEST = 2.5;

    private final int rgb;
    private final BlobField field = new BlobField();
    private final BlobSurface surface = new BlobSurface();

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
        field.clear(radius, balls.size(), FINEST * pixel);
        balls.forEach(ball -> field.add(ball.x(), ball.y(), ball.z()));
        surface.build(field);
    }

    /** Draws the surface as a camera sees it. */
    void paint(RoundShapes shapes) {
        Place[] places = shapes.view().places(surface.places, surface.vertices);
        int[] colours = new int[surface.vertices];
        for (int i = 0, x = 0; i < surface.vertices; i++, x += 3) {
            Vector3 normal = new Vector3(surface.normals[x], surface.normals[x + 1], surface.normals[x + 2]);
            colours[i] = colour(shapes.view().turned(normal), shapes.lighting());
        }
        for (int k = 0; k < surface.cornerCount; k += 3) {
            shapes.raster().triangle(surface.corners, k, places, colours);
        }
    }

    private int colour(Direction normal, Lighting lighting) {
        float grazing = 1 - Math.max(0, normal.back());
        int wet = Colours.mix(rgb, SKY_IN_IT,
                0.45 * grazing * grazing * grazing * Math.max(0, 0.6f + 0.4f * normal.up()));
        return lighting.shade(wet, normal, 1.6f);
    }
}
