package particles.app.experiments;

import java.util.List;
import java.util.Set;
import particles.experiments.runs.ProgressListener;
import particles.output.files.OutputFolder;
import particles.output.report.ResultPage;

/**
 * An experiment as data; {@link DeclaredCommand} serves all.
 *
 * @param command the name of its command
 * @param about   what the command does, in a sentence
 * @param teaches what it teaches, in a sentence or two
 * @param options the options of {@link DeclaredCommand} that it has
 * @param scene   the scene without {@code --scene}; empty for none
 * @param solvers the solvers without {@code --solvers}
 * @param plan    what it does; its code is loaded when it is called
 */
record Experiment(String command, String about, String teaches, Set<String> options, String scene, String solvers,
        Plan plan) {
    /** Five solvers: all would take long on large scenes. */
    static final String FIVE = "euler,midpoint,rk4,symplectic-euler,verlet";

    /** The options of an experiment on a scene. */
    private static final Set<String> ON_SCENE = Set.of("--scene", "--set", "--solvers");

    /** All experiments, in the order of the report. */
    static final List<Experiment> ALL = List.of(
            new Experiment("lectureFigures", "Draws the figures of the lecture: Euler, midpoint and RK4 over the vector"
                    + " field.", """
                    N steps of h on x'' = -x multiply the amplitude by |R(ih)|^N and run ahead of the exact phase by N \
                    (arg R - h), where R is the method's stability function.""",
                    Set.of(), "", "all", asked -> StateSpaceExperiments.lectureFigures(asked)),
            new Experiment("phasePlots", "Draws phase portraits of a scene: several solvers over a reference solution.",
                    """
                    A path in state space shows what a plot over time hides: a closed curve keeps its energy, a spiral \
                    outwards gains it, and a spiral inwards loses it.""",
                    ON_SCENE, "euler-spiral", "euler,symplectic-euler,rk4",
                    asked -> StateSpaceExperiments.phasePlots(asked)),
            new Experiment("energyDrift", "Compares how well solvers keep the energy of a scene.", """
                    The energy error is the change of the total energy minus the work of drag, damping, wind, contacts \
                    and collisions: the solver's own error. It is divided by the largest kinetic plus stored energy of \
                    an accurate run.""",
                    ON_SCENE, "undamped-net", "all", asked -> Experiments.energyDrift(asked)),
            new Experiment("race", "Runs solvers with equal work on a scene, side by side in one animation.", """
                    Equal work: every solver gets as many evaluations of the derivative as rk4 needs at the scene's \
                    step, or as many as the solver that needs most, to within one step or 1 %.""",
                    ON_SCENE, "soft-chain", FIVE, asked -> RaceExperiment.plan(asked)),
            new Experiment("workPrecision", "Plots the error of solvers against their cost, on several problems.", """
                    Each line is a solver, each point a run with half the step, or a tenth of the tolerance, of the \
                    one before; the slope of a line is the order.""",
                    Set.of("--problem", "--solvers"), "", "all", asked -> Experiments.workPrecision(asked)),
            new Experiment("stiffGallery", "Measures what each solver costs as a spring gets stiffer.", """
                    Two masses swing together on soft springs while the spring between them gets stiffer: the cost of \
                    an explicit solver grows as the root of the stiffness, though the swing stays the same, and \
                    implicit ones pay with the energy of the stiff vibration.""",
                    Set.of("--solvers"), "", "all", asked -> Experiments.stiffGallery(asked)),
            new Experiment("stability", "Measures the longest stable step of each solver.", """
                    Every limit is measured on the solver's code, by bisection: on the test equation y' = lambda y or, \
                    for symplectic solvers and your own, on a damped spring with eigenvalue lambda. A spring without \
                    damping lies on the imaginary axis, pure decay on the negative real axis. One sub-step of an \
                    adaptive solver is measured.""",
                    ON_SCENE, "", "all", asked -> StabilityExperiment.plan(asked)),
            new Experiment("effectCost", "Measures what each effect adds to the time of a step.", """
                    A scene pays only for what it names: a cloth is timed with rk4, first with springs alone, then \
                    with one more effect or rule at a time.""",
                    Set.of(), "", "all", asked -> Experiments.effectCost(asked)),
            new Experiment("stiffCloth", "Times a frame of ever stiffer cloth: RK4 against backward Euler with one"
                    + " step a frame.", """
                    The stiffer the springs, the more steps of rk4 a frame needs to be stable, as many as the root of \
                    the stiffness; backward Euler takes one step whatever the stiffness, and pays with numerical \
                    damping.""",
                    Set.of(), "", "all", asked -> Experiments.stiffCloth(asked)));

    /** @return whether it looks at a scene, which may be another one */
    boolean looksAtScene() {
        return options.contains("--scene");
    }

    /** Looks at the options before anything runs. */
    interface Plan {
        /**
         * @param asked the options, as typed
         * @return what is left to do
         * @throws particles.spec.messages.InvalidInputException if an option is wrong
         */
        Run of(DeclaredCommand asked);
    }

    /** Measures. */
    interface Run {
        /**
         * @param folder   the folder for results that are written during the experiment, such as an animation
         * @param progress receives the progress
         * @return the results
         */
        ResultPage measure(OutputFolder folder, ProgressListener progress);
    }
}
