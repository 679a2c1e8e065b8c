package particles.output.painters;

import java.util.List;
import java.util.Optional;
import particles.law.Sphere;
import particles.output.raster.CameraProjection;
import particles.output.raster.RoundShapes;
import particles.output.raster.ShadowMap;

/**
 * Draws the shadows of a frame: what the lamp sees is in the light, and hides from it what lies behind.
 *
 * @param map     receives the shadows
 * @param shapes  draws as the lamp sees it
 * @param spheres the scene's spheres
 */
public record ShadowPainter(ShadowMap map, OpaquePainter shapes, List<Sphere> spheres) {

    /** Draws a frame. */
    public void paint(FrameState state, Optional<BlobPainter> blobs) {
        map.clear();
        shapes.paint(state, blobs);
        RoundShapes lamp = map.getShapes();
        for (Sphere sphere : spheres) {
            if (!sphere.hollow()) {
                CameraProjection.Place place = lamp.view().place(sphere.centre());
                lamp.ball(place, place.scale() * sphere.radius(), sphere.radius(), 0);
            }
        }
        map.blur();
    }
}
