/**
 * Results as files: numbers, charts, frames, animations. The only package that draws, and it reads what simulation and
 * recorders hand it; nothing here changes a trajectory.
 *
 * <p>An {@link particles.output.files.OutputFolder} is opened first. Observers of a run take it:
 * {@link particles.output.files.TrajectoryWriter} streams the states, and a
 * {@link particles.output.frames.FrameObserver} has frames drawn at regular times by a
 * {@link particles.output.frames.FrameRenderer}, on another thread, for {@link particles.output.frames.PngFrames} and a
 * {@link particles.output.animation.GifAnimation}. After the run {@link particles.output.charts.ChartWriter} draws the
 * chart data that recorders collected, and {@link particles.output.files.RunSummaryWriter} writes what the run was.
 * Observers that hold files open are closed also when a run ends early; they then keep what they have, as whole files:
 * <pre>
 *     Stage stage = new Stage(CameraFraming.around(system, planes, 16 / 9.0), Look.STANDARD, scenery,
 *             "A cloth", "rk4, deltaT = 0.01 s");
 *     FrameRenderer renderer = new FrameRenderer(stage, 1280, 720, 2);
 *     try (OutputFolder folder = OutputFolder.open(path, OutputFolder.FRAMES, GifAnimation.FILE,
 *             TrajectoryWriter.FILE);
 *             TrajectoryWriter trajectory = new TrajectoryWriter(folder, 1);
 *             FrameObserver frames = new FrameObserver(renderer, 25, List.of(
 *                     new PngFrames(folder, 1280, 720), new GifAnimation(folder, renderer, 640, 25)))) {
 *         simulation.addObserver(trajectory);
 *         simulation.addObserver(frames);
 *         simulation.run();
 *         RunSummaryWriter.write(folder, summary);
 *     }
 * </pre>
 * Whatever cannot be written ends in an {@link particles.output.files.OutputException}, whose message is one line for
 * people. A program that is being stopped calls {@link particles.output.files.OutputFolder#close} from its shutdown
 * hook: unfinished files then disappear, complete ones stay.
 */
package particles.output;
