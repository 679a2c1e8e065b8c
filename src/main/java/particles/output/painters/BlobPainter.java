package particles.output.painters;

import particles.law.Vector3;
import particles.output.raster.CameraProjection;
import particles.output.raster.Colours;
import particles.output.raster.Direction;
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

    /** Creates a painter that draws onto this raster. */
    public BlobPainter(Raster raster, CameraProjection view, Lighting lighting) {
        this.raster = raster;
        this.view = view;
        this.lighting = lighting;
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
        ProjectedParticles projected = new ProjectedParticles(view, surface.places, surface.vertices);
        int[] colours = new int[surface.vertices];
        for (int i = 0, x = 0; i < surface.vertices; i++, x += 3) {
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
        Direction normal = view.turned(new Vector3(x, y, z));
        float grazing = 1 - Math.max(0, normal.back());
        int wet = Colours.mix(rgb, SKY_IN_IT,
                0.45 * grazing * grazing * grazing * Math.max(0, 0.6f + 0.4f * normal.up()));
        return lighting.shade(wet, normal, 1.6f);
    }
}
