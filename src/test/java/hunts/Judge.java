package hunts;

import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import deSolvers.catalog.SolverInfo.Family;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.SceneReader;
import particles.scene.format.SceneDescription;
import particles.scene.format.SolverDescription;
import particles.scene.format.SolverDescription.Tolerances;
import particles.spec.messages.InvalidInputException;

/**
 * Judges one execution. A text has to be refused with clear lines, or run for some steps. A drawn scene also has to
 * obey the laws of physics, to be nearer to the exact motion with half the deltaT, and to say why if it stops.
 */
final class Judge {
    private static final long SLOW_NANOS = TimeUnit.SECONDS.toNanos(2);
    private static final int FEW_EVALUATIONS = 30;
    private static final int MOST_EVALUATIONS = 5000;
    /** What no message may show, unless the text has it. */
    private static final Pattern ALIEN = Pattern.compile("NaN|Infinity|Exception|92233720368");
    /** Laws that change with time: where the clock is wrong within a step, their scenes lose the order. */
    private static final Pattern TIMED = Pattern.compile("\\b(wind|turbulence|glide|shake)\\b");
    /** In a run that resolves the motion, half the deltaT moves the end by less than this, and so is its ledger off. */
    private static final double RESOLVED = 0.05;
    /** Errors below this shrink in the order of the method, and those above the next are no round-off. */
    private static final double CLOSED = 0.01;
    private static final double ROUND_OFF = 1e-6;
    /** An error that shrinks does so by this factor at least, even where its sign changes. */
    private static final double NEARER = 0.9;
    /** A rod or contact that is off by more ends a run: it says so. */
    private static final double WRONG = 0.1;
    /** The kind of drawn scenes with late impacts, by all solvers: each comes late by a random part of deltaT. */
    static final String CLAMP = "clamp";
    /** The tolerances of the finer run of an adaptive solver: a hundredth of its own. */
    private static final Optional<Tolerances> FINER = Optional.of(new Tolerances(1e-8, 1e-11));
    private static final int MOST_LINES_OF_A_STOP = 3;
    /** Relative and absolute tolerance of the reference; its error is below a hundredth of what is compared with it. */
    private static final SolverDescription REFERENCE =
            new SolverDescription("dormand-prince", Optional.of(new Tolerances(1e-10, 1e-11)));

    /**
     * What became of an execution.
     *
     * @param find     what is wrong; empty if nothing is
     * @param kind     how it ended, in words without numbers
     * @param compared whether the run was whole, and compared with a reference
     * @param order    the measured order of a solver whose error is small but not round-off; otherwise NaN
     */
    record Verdict(String find, String kind, boolean compared, double order) {
        Verdict(String find, String kind) {
            this(find, kind, false, Double.NaN);
        }
    }

    private Judge() {
    }

    /** Reads, builds and runs a text; only reading and building must be fast. */
    static Verdict ofText(byte[] text) {
        try {
            long begin = threadTime();
            SceneDescription scene = SceneReader.read("x.yaml", text);
            Scene built = SceneBuilder.build(scene);
            long time = threadTime() - begin;
            if (time > SLOW_NANOS) {
                return new Verdict("it took " + time / 1e9 + " s of computing to read and build it", "slow");
            }
            Trial trial = new Trial(built, FEW_EVALUATIONS);
            return new Verdict(trial.stopped().map(Judge::ofStop).orElse(""), trial.stopped().isEmpty() ? "built"
                    : "stopped");
        } catch (InvalidInputException e) {
            String shown = new String(text, StandardCharsets.UTF_8);
            String bad = e.getLines().stream().filter(line -> !line.matches("x\\.yaml(:\\d+:\\d+)?: \\P{Cntrl}{1,1100}")
                    || ALIEN.matcher(line).results().anyMatch(alien -> !shown.contains(alien.group())))
                    .findFirst().orElse("");
            String words = e.getLines().get(0).replaceAll("'[^']*'?|[0-9.e+-]+", "?");
            return new Verdict(bad, "refused: " + words.substring(0, Math.min(40, words.length())));
        } catch (RuntimeException | Error e) {
            return ofError(e);
        }
    }

    private static Verdict ofError(Throwable e) {
        return new Verdict(e + (e.getStackTrace().length > 0 ? " at " + e.getStackTrace()[0] : ""), "error");
    }

    private static long threadTime() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    }

    /** Judges the lines with which a run ends early. */
    private static String ofStop(String lines) {
        return ALIEN.matcher(lines).find() || lines.lines().count() > MOST_LINES_OF_A_STOP
                ? "not a clear message: " + lines : "";
    }

    /** Judges a drawn scene; it must be valid. */
    static Verdict ofScene(String text) {
        try {
            Verdict verdict = judged(read(text), read(text.replace("impact: clamp", "impact: exact")));
            // yoshida4 evaluates before its step, where a glide that begins there does not move yet: order 2
            if (verdict.kind.startsWith("yoshida4") && text.contains("glide")) {
                return new Verdict(verdict.find, verdict.kind, verdict.compared, Double.NaN);
            }
            boolean timed = !Double.isNaN(verdict.order) && !verdict.kind.equals(CLAMP) && TIMED.matcher(text).find();
            return timed ? new Verdict(verdict.find, verdict.kind + ", timed", true, verdict.order) : verdict;
        } catch (InvalidInputException e) {
            return e.getMessage().contains("are at the same place") ? new Verdict("", "refused: at the same place")
                    : ofError(e);
        } catch (RuntimeException | Error e) {
            return ofError(e);
        }
    }

    private static SceneDescription read(String text) {
        return SceneReader.read("x.yaml", text.getBytes(StandardCharsets.UTF_8));
    }

    private static Trial run(SceneDescription scene) {
        return new Trial(SceneBuilder.build(scene), MOST_EVALUATIONS);
    }

    private static Verdict judged(SceneDescription scene, SceneDescription exactly) {
        SolverInfo solver = SolverCatalog.info(scene.solver());
        double h = scene.deltaT();
        Trial whole = run(scene);
        if (!whole.isWhole()) {
            return new Verdict(whole.stopped().map(Judge::ofStop).orElse(""), whole.stopped().isPresent() ? "stopped"
                    : "cut");
        }
        // a clamped impact is late by a part of deltaT, whatever the tolerance
        SceneDescription shorter = solver.adaptive() && scene.exactImpacts() ? scene : scene.withDeltaT(h / 2);
        SceneDescription finer = solver.adaptive() ? shorter.withSolver(new SolverDescription(solver.name(), FINER))
                : shorter;
        Trial half = run(finer);
        String find = ofLaws(whole) + ofLaws(half);
        if (!find.isEmpty() || !half.isWhole() || whole.distance(half) > RESOLVED || whole.skips()) {
            return new Verdict(find, "not resolved");
        }
        Trial exact = run(exactly.withDeltaT(h / 4).withSolver(REFERENCE));
        if (!exact.isWhole()) {
            return new Verdict(exact.stopped().filter(why -> !exact.mayJam() || why.contains("no headway"))
                    .map(why -> "the reference stops: " + why).orElse(""), "no reference");
        }
        boolean struck = exact.struck() || whole.struck() || half.struck();
        boolean clamped = !scene.exactImpacts() && whole.hasSurfaces();
        double far = whole.distance(exact);
        double near = half.distance(exact);
        boolean resolved = half.ledger() < RESOLVED;
        boolean compared = far > ROUND_OFF && far < CLOSED;
        // the three steps after an impact are RK4's, with smaller errors: in so short a run their share counts
        boolean ordered = compared && near > 0 && !solver.adaptive()
                && !(struck && solver.family() == Family.MULTISTEP);
        find = exact.depth() > ROUND_OFF ? "the reference is below a surface by " + exact.depth() : ofLaws(exact);
        boolean gains = whole.gain() > whole.ledger() + (clamped ? WRONG : far + ROUND_OFF)
                && half.gain() > whole.gain() / 2;      // a late impact lifts by an error that shrinks with deltaT
        if (exact.gain() > ROUND_OFF || gains) {
            find = "surfaces and damping add energy: " + exact.gain() + ", " + whole.gain();
        } else if (!clamped && resolved && near > NEARER * far && (compared || solver.adaptive() && far > CLOSED)) {
            Trial fine = run(finer.withDeltaT(h / 16));
            boolean asymptotic = fine.isWhole() && fine.events() == exact.events();
            find = asymptotic && fine.distance(exact) > NEARER * Math.max(far, near)
                    ? "finer steps are not nearer: " + far + ", " + near + ", " + fine.distance(exact) : find;
        } else if (whole.ledger() < CLOSED && exact.ledger() > Math.max(ROUND_OFF, NEARER * whole.ledger())) {
            Trial fine = run(exactly.withDeltaT(h / 64).withSolver(REFERENCE));
            find = fine.isWhole() && fine.ledger() > Math.max(ROUND_OFF, NEARER * whole.ledger())
                    ? "the ledger does not close: " + whole.ledger() + ", " + exact.ledger() + ", " + fine.ledger()
                    : find;
        }
        return new Verdict(find, struck && clamped ? CLAMP : solver.name() + (struck ? ", exact" : ""), true,
                ordered ? Math.log(far / near) / Math.log(2) : Double.NaN);
    }

    private static String ofLaws(Trial trial) {
        if (!trial.isWhole()) {
            return "";
        }
        return !(trial.distance(trial) == 0 && trial.ledger() < Double.POSITIVE_INFINITY) ? "not finite"
                : trial.rods() > WRONG ? "a rod is longer or shorter by " + trial.rods()
                : trial.depth() > WRONG ? "below a surface by " + trial.depth()
                : trial.momentum() > momentum(trial.scene().description().solver()) ? "momentum changed by "
                + trial.momentum() : "";
    }

    /**
     * Measured: 1e-15, 7e-11 for implicit solvers, and for the one that solves only one linear system 1.5e-9 with
     * springs and 5.5e-8 with rods, whose derivatives are differences.
     */
    private static double momentum(String solver) {
        return solver.equals("linearised-euler") ? 2e-7 : SolverCatalog.info(solver).implicit() ? 1e-9
                : 1e-14;
    }
}
