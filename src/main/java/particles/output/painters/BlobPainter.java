package particles.output.painters;

import particles.output.raster.CameraProjection;
import particles.output.raster.Colours;
import particles.output.raster.Lighting;
import particles.output.raster.Raster;

/** Draws particles as a smooth wet surface, with a sharp highlight and a reflection of the sky at its rim. */
public final class BlobPainter {
    private static final int SKY_IN_IT = 0xf3f7fb;
    /** The smallest useful cell (pixels). */
    private static final double FINEST = 2.5;

    private final Raster raster;
    private final CameraProjection view;
    private final Lighting lighting;
    private final BlobField field = new BlobField();
    private final BlobSurface surface = new BlobSurface();
    private final ProjectedParticles projected;
    private int[] colours = {};

    /** Creates a painter that draws onto this raster. */
    public BlobPainter(Raster raster, CameraProjection view, Lighting lighting) {
        this.raster = raster;
        this.view = view;
        this.lighting = lighting;
        projected = new ProjectedParticles(view);
    }

    /** @return the surface that was drawn last */
    public BlobSurface getSurface() {
        return surface;
    }

    /**
     * @param places the balls' middles, three coordinates each (m)
     * @param count  the number of balls
     * @param radius the radius of a single ball (m)
     */
    void paint(double[] places, int count, double radius, int rgb) {
        field.clear(radius, count, FINEST * view.viewHeight / view.height);
        for (int i = 0; i < 3 * count; i += 3) {
            field.add(places[i], places[i + 1], places[i + 2]);
        }
        surface.build(field);
        projected.reserve(surface.vertices);
        if (colours.length < surface.vertices) {
            colours = new int[projected.x.length];
        }
        for (int i = 0, x = 0; i < surface.vertices; i++, x += 3) {
            projected.put(i, surface.places[x], surface.places[x + 1], surface.places[x + 2]);
            colours[i] = colour(surface.normals[x], surface.normals[x + 1], surface.normals[x + 2], rgb);
        }
        int[] t = surface.corners;
        for (int k = 0; k < surface.cornerCount; k += 3) {
            if (projected.visible[t[k]] && projected.visible[t[k + 1]] && projected.visible[t[k + 2]]) {
                raster.triangle(t, k, projected.x, projected.y, projected.near, colours);
            }
        }
    }

    private int colour(float x, float y, float z, int rgb) {
        float nx = (float) (x * view.right.x() + y * view.right.y() + z * view.right.z());
        float ny = (float) (x * view.up.x() + y * view.up.y() + z * view.up.z());
        float nz = (float) (x * view.back.x() + y * view.back.y() + z * view.back.z());
        float grazing = 1 - Math.max(0, nz);
        int wet = Colours.mix(rgb, SKY_IN_IT, 0.45 * grazing * grazing * grazing * Math.max(0, 0.6f + 0.4f * ny));
        return Colours.lit(wet, lighting.light(nx, ny, nz), 1.6f * lighting.highlight(nx, ny, nz));
    }
}
