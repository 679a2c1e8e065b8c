package particles.output;

import java.util.List;
import particles.Camera;
import particles.Look;
import particles.Plane;
import particles.Surface;

/**
 * What a picture shows beside the moving particles and their springs.
 *
 * @param camera   from where
 * @param look     what is drawn in which colours
 * @param surfaces surfaces that particles span
 * @param planes   the ground and other planes
 * @param title    the scene's title, at the top; may be empty
 * @param caption  what stands below the time, such as the solver and its deltaT; may be empty
 */
public record Stage(Camera camera, Look look, List<Surface> surfaces, List<Plane> planes, String title, String caption) {
    /** Copies the lists. */
    public Stage {
        surfaces = List.copyOf(surfaces);
        planes = List.copyOf(planes);
    }
}
