package particles.app.experiments;

import java.util.Set;
import particles.experiments.runs.ProgressListener;
import particles.output.files.OutputFolder;
import particles.output.report.ResultPage;

/** The experiments as data; {@link DeclaredCommand} serves all. A plan's code is loaded when it is called. */
enum Experiment {
    LECTURE_FIGURES("lectureFigures", "Draws the figures of the lecture: Euler, midpoint and RK4 over the vector"
            + " field.", Set.of(), "", "all", asked -> StateSpaceExperiments.lectureFigures(asked)),
    PHASE_PLOTS("phasePlots", "Draws phase portraits of a scene: several solvers over a reference solution.",
            Set.of("--scene", "--set", "--solvers"), "euler-spiral", "euler,symplectic-euler,rk4",
            asked -> StateSpaceExperiments.phasePlots(asked)),
    ENERGY_DRIFT("energyDrift", "Compares how well solvers keep the energy of a scene.",
            Set.of("--scene", "--set", "--solvers"), "undamped-net", "all", asked -> Experiments.energyDrift(asked)),
    RACE("race", "Runs solvers with equal work on a scene, side by side in one animation.",
            Set.of("--scene", "--set", "--solvers"), "soft-chain", Experiment.FIVE,
            asked -> RaceExperiment.plan(asked)),
    WORK_PRECISION("workPrecision", "Plots the error of solvers against their cost, on several problems.",
            Set.of("--problem", "--solvers"), "", "all", asked -> Experiments.workPrecision(asked)),
    STIFF_GALLERY("stiffGallery", "Measures what each solver costs as a spring gets stiffer.", Set.of("--solvers"), "",
            "all", asked -> Experiments.stiffGallery(asked)),
    STABILITY("stability", "Measures the longest stable step of each solver.", Set.of("--scene", "--set", "--solvers"),
            "", "all", asked -> StabilityExperiment.plan(asked)),
    EFFECT_COST("effectCost", "Measures what each effect adds to the time of a step.", Set.of(), "", "all",
            asked -> Experiments.effectCost(asked)),
    STIFF_CLOTH("stiffCloth", "Times a frame of ever stiffer cloth: RK4 against backward Euler with one step a frame.",
            Set.of(), "", "all", asked -> Experiments.stiffCloth(asked));

    /** Five solvers: all would take long on large scenes. */
    static final String FIVE = "euler,midpoint,rk4,symplectic-euler,verlet";

    final String command;
    final String about;
    /** Those of the options of {@link DeclaredCommand} that it has. */
    final Set<String> options;
    /** The scene without {@code --scene}; empty for none. */
    final String scene;
    /** The solvers without {@code --solvers}. */
    final String solvers;
    final Plan plan;

    Experiment(String command, String about, Set<String> options, String scene, String solvers, Plan plan) {
        this.command = command;
        this.about = about;
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
