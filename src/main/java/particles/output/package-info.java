/**
 * Results as files: numbers, charts, frames, animations. The only package that draws, and it reads what the simulation
 * observers hand it; nothing here changes a trajectory.
 *
 * <p>An {@link particles.output.OutputFolder} is opened first. Observers of a run take it:
 * {@link particles.output.TrajectoryWriter} streams the states. After the run
 * {@link particles.output.ChartWriter} draws the chart data that recorders collected, and
 * {@link particles.output.RunSummaryWriter} writes what the run was. Observers that hold a file open are closed also when a run ends
 * early; they then keep what they have as a whole file:
 * <pre>
 *     try (OutputFolder folder = OutputFolder.open(path, TrajectoryWriter.FILE, RunSummaryWriter.FILE);
 *             TrajectoryWriter trajectory = new TrajectoryWriter(folder, 1)) {
 *         simulation.addObserver(trajectory);
 *         simulation.run();
 *         RunSummaryWriter.write(folder, summary);
 *     }
 * </pre>
 * Whatever cannot be written ends in an {@link particles.output.OutputException}, whose message is one line for people.
 */
package particles.output;
