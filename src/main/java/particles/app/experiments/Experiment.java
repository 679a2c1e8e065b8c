package particles.app.experiments;

import java.util.Set;
import particles.experiments.runs.ProgressListener;
import particles.output.files.OutputFolder;
import particles.output.report.ResultPage;

/** The experiments as data; {@link DeclaredCommand} serves all. A plan's code is loaded when it is called. */
enum Experiment {
    LECTURE_FIGURES("lectureFigures", "Draws the figures of the lecture: Euler, midpoint and RK4 over the vector"
            + " field.", """
            N steps of h on x'' = -x multiply the amplitude by |R(ih)|^N and run ahead of the exact phase by \
            N (arg R - h), where R is the method's stability function.""",
            Set.of(), "", "all", asked -> StateSpaceExperiments.lectureFigures(asked)),
    PHASE_PLOTS("phasePlots", "Draws phase portraits of a scene: several solvers over a reference solution.", """
            A path in state space shows what a plot over time hides: a closed curve keeps its energy, a spiral \
            outwards gains it, and a spiral inwards loses it.""",
            Set.of("--scene", "--set", "--solvers"), "euler-spiral", "euler,symplectic-euler,rk4",
            asked -> StateSpaceExperiments.phasePlots(asked)),
    ENERGY_DRIFT("energyDrift", "Compares how well solvers keep the energy of a scene.", """
            The energy error is the change of the total energy minus the work of drag, damping, wind, contacts and \
            collisions: the solver's own error. It is divided by the largest kinetic plus stored energy of an \
            accurate run.""",
            Set.of("--scene", "--set", "--solvers"), "undamped-net", "all", asked -> Experiments.energyDrift(asked)),
    RACE("race", "Runs solvers with equal work on a scene, side by side in one animation.", """
            Equal work: every solver gets as many evaluations of the derivative as rk4 needs at the scene's step, or \
            as many as the solver that needs most, to within one step or 1 %.""",
            Set.of("--scene", "--set", "--solvers"), "soft-chain", Experiment.FIVE,
            asked -> RaceExperiment.plan(asked)),
    WORK_PRECISION("workPrecision", "Plots the error of solvers against their cost, on several problems.", """
            Each line is a solver, each point a run with half the step, or a tenth of the tolerance, of the one \
            before; the slope of a line is the order.""",
            Set.of("--problem", "--solvers"), "", "all", asked -> Experiments.workPrecision(asked)),
    STIFF_GALLERY("stiffGallery", "Measures what each solver costs as a spring gets stiffer.", """
            Two masses swing together on soft springs while the spring between them gets stiffer: the cost of an \
            explicit solver grows as the root of the stiffness, though the swing stays the same, and implicit ones \
            pay with the energy of the stiff vibration.""",
            Set.of("--solvers"), "", "all", asked -> Experiments.stiffGallery(asked)),
    STABILITY("stability", "Measures the longest stable step of each solver.", """
            Every limit is measured on the solver's code, by bisection: on the test equation y' = lambda y or, for \
            symplectic solvers and your own, on a damped spring with eigenvalue lambda. A spring without damping lies \
            on the imaginary axis, pure decay on the negative real axis. One sub-step of an adaptive solver is \
            measured.""",
            Set.of("--scene", "--set", "--solvers"), "", "all", asked -> StabilityExperiment.plan(asked)),
    EFFECT_COST("effectCost", "Measures what each effect adds to the time of a step.", """
            A scene pays only for what it names: a cloth is timed with rk4, first with springs alone, then with one \
            more effect or rule at a time.""",
            Set.of(), "", "all", asked -> Experiments.effectCost(asked)),
    STIFF_CLOTH("stiffCloth", "Times a frame of ever stiffer cloth: RK4 against backward Euler with one step a frame.",
            """
            The stiffer the springs, the more steps of rk4 a frame needs to be stable, as many as the root of the \
            stiffness; backward Euler takes one step whatever the stiffness, and pays with numerical damping.""",
            Set.of(), "", "all", asked -> Experiments.stiffCloth(asked));

    /** Five solvers: all would take long on large scenes. */
    static final String FIVE = "euler,midpoint,rk4,symplectic-euler,verlet";

    final String command;
    final String about;
    /** What it teaches, in a sentence or two. */
    final String teaches;
    /** Those of the options of {@link DeclaredCommand} that it has. */
    final Set<String> options;
    /** The scene without {@code --scene}; empty for none. */
    final String scene;
    /** The solvers without {@code --solvers}. */
    final String solvers;
    final Plan plan;

    Experiment(String command, String about, String teaches, Set<String> options, String scene, String solvers,
            Plan plan) {
        this.command = command;
        this.about = about;
        this.teaches = teaches;
        this.options = options;
        this.scene = scene;
        this.solvers = solvers;
        this.plan = plan;
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
