package particles.experiments.work;

import static particles.view.DataTable.column;

import deSolvers.DESolver;
import deSolvers.RK4Solver;
import deSolvers.implicit.LinearisedEulerSolver;
import deSolvers.text.Digits;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import particles.ParticleSystem;
import particles.experiments.runs.CpuClock;
import particles.experiments.runs.ProgressListener;
import particles.experiments.runs.SceneRun;
import particles.experiments.runs.SolverChoice;
import particles.experiments.stability.Spectrum;
import particles.law.Particles;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.DataTable;
import particles.view.Panel;
import particles.view.Series;
import particles.view.Series.Mark;

/**
 * Compares an implicit with an explicit solver on one frame (1/60 s) of a cloth of 64 x 64 particles with ever stiffer
 * springs. RK4 has to take steps of 2.8284/omega, where omega is the fastest vibration of the cloth, from its spectrum;
 * backward Euler takes one step.
 */
public final class StiffCloth {
    static final double FRAME = 1.0 / 60;
    /** The numbers of RK4 steps for which stiffnesses are chosen. */
    public static final List<Long> SWEEP = List.of(1L, 3L, 10L, 30L, 100L, 300L, 1000L, 5000L);
    private static final List<Long> WARM_UP = List.of(2L, 100L);
    /** Measured: the part of the time before the sweep, most of it for the spectrum of the cloth. */
    private static final double WARM = 0.45;
    private static final int EDGE = 64;
    /** Springs join neighbours, cross the squares, and join second neighbours against bending. */
    private static final String CLOTH = """
            title: A stiff cloth
            teaches: What stiffness costs.
            solver: rk4
            deltaT: %1$s
            duration: 1
            shapes:
              - cloth: {corner: [0, 0, 0], across: [3.15, 0, 0], down: [0, -3.15, 0], columns: 64, rows: 64, mass: 0.01,
                        fixed: [top-left, top-right], structural: {stiffness: %2$s}, shear: {stiffness: %2$s},
                        bend: {stiffness: %2$s}}
            effects: [gravity]
            """;
    static final double RK4_LIMIT = 2.8284;
    /** The number of RK4 steps that are timed; all cost the same, some 1 ms. */
    private static final int TIMED = 400;
    /** The number of implicit steps that are timed; the fastest counts. */
    private static final int STEPS = 3;

    /**
     * The cost of a frame in CPU time.
     *
     * @param stiffness  the stiffness of every spring (N/m)
     * @param rk4Steps   the number of steps that RK4 needs to be stable
     * @param rk4        the time of these steps (s)
     * @param linearised the time of a step of backward Euler with one linear solve, after a first one for the symbolic
     *                   factorisation (s)
     */
    public record Row(double stiffness, long rk4Steps, double rk4, double linearised) {
    }

    private StiffCloth() {
    }

    /** Computed when it is first asked for, which takes many seconds. */
    private static final class Soft {
        /** omega of the fastest vibration with springs of 1 N/m (1/s). */
        static final double FASTEST = fastest(1);
    }

    /** A cloth that hangs from two corners, slightly crumpled. */
    static ParticleSystem cloth(double stiffness) {
        ParticleSystem system = SceneRun.of("stiff cloth",
                Digits.format(CLOTH, FRAME, stiffness)).system();
        for (int n = 0; n < EDGE * EDGE; n++) {
            system.getOwnState()[Particles.STRIDE * n + 2] = 0.01 * ((7 * (n / EDGE) + 13 * (n % EDGE)) % 5);
        }
        return system;
    }

    /** The stiffness for which RK4 needs that many steps: the fastest vibration grows with its root. */
    static double stiffnessFor(long steps) {
        double ratio = (steps - 0.01) * RK4_LIMIT / FRAME / Soft.FASTEST;
        return ratio * ratio;
    }

    /** omega of the fastest vibration (1/s). */
    static double fastest(double stiffness) {
        return Spectrum.of(cloth(stiffness)).modes().get(0).size();
    }

    private static double seconds(DESolver solver, ParticleSystem system, double deltaT, int steps) {
        double before = CpuClock.seconds();
        for (int i = 0; i < steps; i++) {
            solver.stepState(system, deltaT);
        }
        return CpuClock.seconds() - before;
    }

    private static Row measure(long steps) {
        double stiffness = stiffnessFor(steps);
        double rk4 = seconds(new RK4Solver(), cloth(stiffness), FRAME / steps, TIMED) / TIMED * steps;
        LinearisedEulerSolver linearised = new LinearisedEulerSolver();
        return new Row(stiffness, steps, rk4, IntStream.rangeClosed(0, STEPS).mapToDouble(i ->
                seconds(linearised, cloth(stiffness), FRAME, 1)).min().orElseThrow());
    }

    /**
     * @param sweep    the number of steps that RK4 needs for each cloth, the softest first
     * @param progress receives the progress
     * @return the costs of each
     */
    public static List<Row> measure(List<Long> sweep, ProgressListener progress) {
        progress.reached(0, "warm-up");
        WARM_UP.forEach(StiffCloth::measure);
        return progress.part(WARM, 1).each(sweep, steps -> "rk4 with " + steps + " steps", StiffCloth::measure);
    }

    /**
     * @param rows the costs, the softest cloth first
     * @return the time of a frame against the number of steps that RK4 needs, and the ratio of the times
     */
    public static Panel panel(List<Row> rows) {
        Axis seconds = Axis.log("CPU time of a frame", "s");
        return Panel.of("One frame of stiff cloth", List.of(new Chart(Axis.log("steps of rk4 that a frame needs", ""),
                seconds, List.of(line(SolverChoice.RK4, rows, Row::rk4).ending(seconds),
                line(SolverChoice.of("linearised-euler"), rows, Row::linearised).ending(seconds)))));
    }

    private static Series line(SolverChoice solver, List<Row> rows, ToDoubleFunction<Row> time) {
        return Series.of(solver.look(), solver.label(), Mark.LINE_AND_POINTS, rows, Row::rk4Steps, time);
    }

    /**
     * @param rows the costs
     * @return a row for each
     */
    public static DataTable table(List<Row> rows) {
        return DataTable.of("stiffCloth", "CPU time of a frame of 1/60 s of a cloth of " + EDGE + " x " + EDGE
                + " particles", rows, column("stiffness (N/m)", 3, Row::stiffness),
                column("steps of rk4", Row::rk4Steps), column("rk4 (s)", 3, Row::rk4),
                column("linearised-euler (s)", 3, Row::linearised),
                column("rk4 / linearised-euler", 3, row -> row.rk4() / row.linearised()));
    }
}
