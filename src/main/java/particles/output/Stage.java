package particles.output;

import particles.Camera;
import particles.Look;
import particles.Scenery;

/**
 * What a picture shows beside the moving particles and their springs.
 *
 * @param camera   from where
 * @param look     what is drawn in which colours
 * @param scenery  what there is beside particles and springs
 * @param title    the scene's title, at the top; may be empty
 * @param caption  what stands below the time, such as the solver and its deltaT; may be empty
 */
public record Stage(Camera camera, Look look, Scenery scenery, String title, String caption) {
}
