package particles.output.frames;

import particles.view.Camera;
import particles.view.RenderOptions;
import particles.view.Scenery;

/**
 * The fixed settings of all frames of a run: everything but the moving particles and springs.
 *
 * @param camera   the camera
 * @param look     the render options
 * @param scenery  the things besides particles and springs
 * @param title    the scene's title, at the top; may be empty
 * @param caption  the text below the time, such as the solver and its deltaT; may be empty
 */
public record FrameSetup(Camera camera, RenderOptions look, Scenery scenery, String title, String caption) {
}
