package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.Supplier;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.Formula;
import particles.teaching.contract.SolverContract;
import particles.teaching.sources.NonlinearOscillators;
import particles.teaching.sources.Probe;
import particles.teaching.sources.Springs;
import particles.teaching.sources.StiffDecay;
import particles.teaching.sources.WindyOscillators;

/** Looks for mistakes of methods without fixed coefficients, in their evaluations and in the time that they reach. */
final class UnreadMethod {
    private static final double H = 1.0 / 16;
    /** Where nothing is symmetric in time (s). */
    private static final double START = 0.5;
    private static final double LONG = 4;
    private static final int SHORT_STEPS = 16;
    /** The motion is 1.5 wide. */
    private static final double FAR = 10;
    private static final double LITTLE = 1e-3;
    private static final double MUCH = 100;
    private static final double SWING = 0.5;
    private static final double ALIKE = 1e-6;
    private static final int SIZE = 12;
    private static final int MOST = 4 * SIZE;
    /** A stiff decay may be damped little or not at all, but not grow. */
    private static final double GROWS = 1.5;
    /** Times that are tried, in parts of deltaT: all tenths, eighths and twelfths are among them. */
    private static final int PARTS = 120;
    private static final double NEARLY = 0.03;
    private static final double MUCH_BETTER = 0.05;

    private final Supplier<DESolver> maker;

    UnreadMethod(Supplier<DESolver> maker) {
        this.maker = maker;
    }

    /** @return the mistake if the derivative is evaluated while the state is being written; empty if it is not */
    Optional<Finding> entryByEntry() {
        double[] start = new double[SIZE];
        Random random = new Random(7);
        Probe probe = new Probe(start, 0, (evaluation, dSdt) -> {
            for (int k = 0; k < SIZE; k++) {
                dSdt[k] = 1 + random.nextDouble();
            }
        }, MOST);
        try {
            maker.get().stepState(probe, H);
        } catch (RuntimeException e) {
            return Optional.empty();                    // it wants another source, or evaluates without end
        }
        List<Probe.Evaluation> made = probe.recorded();
        boolean[] moved = new boolean[SIZE];
        for (int j = 1; j < made.size(); j++) {
            int changed = 0;
            for (int k = 0; k < SIZE; k++) {
                if (made.get(j).state()[k] != made.get(j - 1).state()[k]) {
                    if (moved[k]) {
                        return Optional.empty();        // a stage, or an iteration
                    }
                    moved[k] = true;
                    changed++;
                }
            }
            if (changed == 0) {
                return Optional.empty();
            }
        }
        return made.size() < 3 ? Optional.empty() : Optional.of(new Finding(Kind.STATE, "getStateDerivative is called "
                + made.size() + " times in a step, between setting parts of the state: later entries move along the"
                + " derivative of a state that is half new. All entries have to be computed from one derivative;"
                + " setState belongs behind the loop"));
    }

    /** @return the mistake of a method that solves with a matrix and is not stable; empty if it is stable */
    Optional<Finding> unstable() {
        try {
            if (!solvesWithMatrix()) {
                return Optional.empty();
            }
            for (double deltaT : new double[] {1, 0.5 / StiffDecay.RATE}) {
                StiffDecay decay = new StiffDecay();
                maker.get().stepState(decay, deltaT);
                if (!(decay.size() <= GROWS)) {
                    return Optional.of(new Finding(Kind.METHOD, "it evaluates the derivative once more for each entry,"
                            + " as methods that solve with a matrix do, and is not stable as they are: a step of "
                            + deltaT + " s multiplies y in y' = -" + Formula.number(StiffDecay.RATE) + " y by "
                            + Formula.number(decay.size()) + ". Check the signs in the matrix, such as I - deltaT J"));
                }
            }
            return Optional.empty();
        } catch (RuntimeException e) {
            return Optional.empty();                    // it refuses, which is no mistake
        }
    }

    /**
     * @return the mistake of a method that makes sub-steps, more of them in a longer step, and is far less accurate in
     *         one long step than in several short ones
     */
    Optional<Finding> uncontrolled() {
        try {
            WindyOscillators once = new WindyOscillators(1);
            WindyOscillators often = new WindyOscillators(1);
            once.startAt(START);
            often.startAt(START);
            maker.get().stepState(once, LONG);
            int moves = once.timeMoves();
            DESolver solver = maker.get();
            for (int step = 0; step < SHORT_STEPS; step++) {
                solver.stepState(often, LONG / SHORT_STEPS);
            }
            boolean subSteps = moves > often.timeMoves() / 2;
            double error = once.error();
            boolean far = error > FAR || error > LITTLE && error > MUCH * often.error();
            return !subSteps || !far ? Optional.empty()
                    : Optional.of(new Finding(Kind.METHOD, "sub-steps are made, and the error is still "
                    + Formula.number(error) + " after a step of " + LONG + " s, and " + Formula.number(
                    often.error()) + " after " + SHORT_STEPS + " steps over the same time: a sub-step with too large an"
                    + " error has to be made again from the state before it, with a shorter length"));
        } catch (RuntimeException e) {
            return Optional.empty();                    // too long a step for it
        }
    }

    /**
     * @return the mistake of a method that makes a spring swing otherwise in another entry of the state, or from the
     *         other side
     */
    Optional<Finding> asymmetric() {
        try {
            double[] first = swing(0, 1);
            double other = SolverContract.distance(first, swing(2, 1));
            double mirrored = SolverContract.distance(first, swing(0, -1));
            return other > ALIKE ? Optional.of(new Finding(Kind.METHOD, "two springs swing alike, one as the first"
                    + " coordinate of a particle and one as the last, and after a step of " + SWING + " s they are "
                    + Formula.number(other) + " apart: the error of a sub-step has to be the largest of all entries"))
                    : mirrored > ALIKE ? Optional.of(new Finding(Kind.METHOD, "two springs start at 1 and at -1, and"
                    + " after a step of " + SWING + " s one is not the mirror image of the other, but "
                    + Formula.number(mirrored) + " off: an error may be negative, and its size counts, Math.abs"))
                    : Optional.empty();
        } catch (RuntimeException e) {
            return Optional.empty();                    // too long a step for it
        }
    }

    /** @return position and velocity of a spring after a step, times the sign of its start */
    private double[] swing(int coordinate, double start) {
        Springs springs = new Springs();
        double[] state = new double[springs.getStateSize()];
        state[coordinate] = start;
        springs.setState(state);
        maker.get().stepState(springs, SWING);
        double[] after = springs.state();
        return new double[] {start * after[coordinate], start * after[coordinate + 3]};
    }

    private long evaluations(int particles) {
        NonlinearOscillators source = new NonlinearOscillators(particles);
        maker.get().stepState(source, H);
        return source.evaluations();
    }

    /** @return a sentence about the time at which the state is after a step, if it is not t + deltaT */
    Optional<String> elsewhere() {
        WindyOscillators source = new WindyOscillators(1);
        try {
            maker.get().stepState(source, H);
        } catch (RuntimeException e) {
            return Optional.empty();
        }
        double here = error(source, PARTS);
        int best = PARTS;
        for (int part = 0; part <= 2 * PARTS; part++) {
            best = error(source, part) < error(source, best) ? part : best;
        }
        double place = (double) best / PARTS;
        double simple = Math.rint(2 * place) / 2;
        place = Math.abs(simple - place) < NEARLY ? simple : place;     // the method's own error moves it
        return error(source, best) > MUCH_BETTER * here ? Optional.empty() : Optional.of("after a step of " + H
                + " s the state is that of " + Formula.time(place) + ": either the weights add up to "
                + Formula.number(place) + " and not to 1, or " + (best < PARTS ? "a part of the step is missing"
                : solvesWithMatrix() ? "deltaT stands where deltaT/2 is meant"
                : "a sub-step too many is made (count them with an int, as sums of fractions are rounded)"));
    }

    /** Whether the derivative is evaluated once more for each entry, as for a matrix of differences. */
    private boolean solvesWithMatrix() {
        return evaluations(2) >= evaluations(1) + SIZE / 2;
    }

    private static double error(WindyOscillators source, int part) {
        source.incTime(H * part / PARTS - source.getTime());
        return source.error();
    }
}
