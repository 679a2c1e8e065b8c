package particles.teaching.solvers;

import static particles.teaching.solvers.PlantedSolvers.plus;
import static particles.teaching.solvers.PlantedSolvers.slope;
import static particles.teaching.solvers.PlantedSolvers.slopeAt;
import static particles.teaching.solvers.PlantedSolvers.state;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import deSolvers.RK4Solver;
import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;
import particles.teaching.declared.Step;
import particles.teaching.measured.Phrase;

/**
 * Kinds of solvers as students and public code write them, each with the verdict that a teacher would give: one or two
 * for each verdict, and right ones that are not among the methods known by their steps.
 */
final class Kinds {
    private Kinds() {
    }

    /**
     * A solver.
     *
     * @param verdict what is wrong with it; nothing with a right one
     * @param name    what its class is called
     * @param about   what it is
     * @param maker   makes a new one
     */
    record Kind(List<Phrase> verdict, String name, String about, Supplier<DESolver> maker) {
    }

    /** What may be wrong with sub-steps. */
    private enum Habit {
        RIGHT, KEEPS_REJECTED, LOOKS_AT_ONE, WAITS_FOR_NAN
    }

    /** A step from s. */
    private interface Body {
        void run(DEStateSource source, double h, double[] s);
    }

    private static Step from(Body body) {
        return (source, h) -> body.run(source, h, state(source));
    }

    private static Kind right(String name, String about, Body body) {
        return new Kind(List.of(), name, about, from(body)::solver);
    }

    private static Kind wrong(Phrase verdict, String name, String about, Body body) {
        return new Kind(List.of(verdict), name, about, from(body)::solver);
    }

    /** A wrong solver whose steps end where a formula says. */
    private static Kind euler(Phrase verdict, String about, Formula formula) {
        return wrong(verdict, "EulerSolver", about, (source, h, s) -> {
            source.setState(formula.end(s, slope(source), h));
            source.incTime(h);
        });
    }

    /** The end of a step from s, with its derivative f. */
    private interface Formula {
        double[] end(double[] s, double[] f, double h);
    }

    /** Of all positions: x += h v + half h^2 a; of all velocities: v += kick h a. */
    private static double[] move(double[] s, double h, double drift, double[] a, double half, double kick) {
        double[] next = s.clone();
        for (int p = 0; p < s.length; p += 6) {
            for (int i = p; i < p + 3; i++) {
                next[i] += drift * h * s[i + 3] + half * h * h * a[i + 3];
                next[i + 3] += kick * h * a[i + 3];
            }
        }
        return next;
    }

    private static Body verlet(double kick) {
        return (source, h, s) -> {
            double[] a = slope(source);
            double[] next = move(s, h, 1, a, 0.5, kick);
            source.incTime(h);
            double[] b = slopeAt(source, next);
            source.setState(move(next, h, 0, b, 0, kick));
        };
    }

    /** Adams-Bashforth of order 2 that begins with Heun's method; it may forget in reset(). */
    private static final class Adams extends DESolver {
        private final boolean forgets;
        private double[] last;

        Adams(boolean forgets) {
            this.forgets = forgets;
        }

        @Override
        public void stepState(DEStateSource source, double h) {
            double[] s = state(source);
            double[] f = slope(source);
            source.incTime(h);
            source.setState(last == null ? plus(s, h / 2, f, h / 2, slopeAt(source, plus(s, h, f)))
                    : plus(s, 1.5 * h, f, -0.5 * h, last));
            last = f;
        }

        @Override
        public void reset() {
            last = forgets ? null : last;
        }
    }

    /** Verlet with the positions before: 2 x - x before + h^2 a. */
    private static final class Stoermer extends DESolver {
        private final double start;
        private final double half;
        private double[] before;

        /**
         * @param start the weight of v in the positions before the first
         * @param half  that of a
         */
        Stoermer(double start, double half) {
            this.start = start;
            this.half = half;
        }

        @Override
        public void stepState(DEStateSource source, double h) {
            double[] s = state(source);
            double[] a = slope(source);
            double[] old = before == null ? move(s, -h, start, a, half, 0) : before;
            double[] next = s.clone();
            for (int i = 0; i < s.length; i += i % 6 == 2 ? 4 : 1) {
                next[i] = 2 * s[i] - old[i] + h * h * a[i + 3];
                next[i + 3] = (next[i] - s[i]) / h;
            }
            source.incTime(h);
            source.setState(move(next, h, 0, slopeAt(source, next), 0, 0.5));
            before = s;
        }

        @Override
        public void reset() {
            before = null;
        }
    }

    /** Backward Euler by so many rounds of a simple iteration. */
    private static Body backward(int rounds) {
        return (source, h, s) -> {
            double[] y = s;
            source.incTime(h);
            for (int round = 0; round < rounds; round++) {
                y = plus(s, h, slopeAt(source, y));
            }
            source.setState(y);
        };
    }

    /** y = s + deltaT f by a simple iteration, with f between s and y, and the clock at t + clock deltaT. */
    static Step implicit(double place, double clock) {
        return from((source, h, s) -> {
            double[] y = s;
            source.incTime(clock * h);
            for (int round = 0; round < 60; round++) {
                y = plus(s, h, slopeAt(source, plus(s, place, y, -place, s)));
            }
            source.setState(y);
            source.incTime(h - clock * h);
        });
    }

    /** Heun's method with sub-steps, forwards only. */
    private static Body adaptive(Habit habit) {
        return (source, deltaT, s) -> {
            double t = source.getTime();
            double end = t + deltaT;
            double h = deltaT;
            double[] now = s;
            while (t < end) {
                h = Math.min(h, end - t);
                source.incTime(t - source.getTime());
                double[] k1 = slopeAt(source, now);
                source.incTime(h);
                double[] next = plus(now, h / 2, k1, h / 2, slopeAt(source, plus(now, h, k1)));
                double error = 0;
                for (int i = 0; i < (habit == Habit.LOOKS_AT_ONE ? 6 : s.length); i++) {
                    error = Math.max(error, Math.abs(next[i] - now[i] - h * k1[i]));
                }
                boolean good = habit == Habit.WAITS_FOR_NAN ? error <= 1e-5 : !(error > 1e-5);
                now = good || habit == Habit.KEEPS_REJECTED ? next : now;
                t = !good ? t : h == end - t ? end : t + h;
                h *= Math.min(4, Math.max(0.2, 0.9 * Math.sqrt(1e-5 / (error + 1e-16))));
            }
            source.setState(now);
            source.incTime(end - source.getTime());
        };
    }

    /** A method of order 2 with a trial step of this part of deltaT, evaluated at t + clock deltaT. */
    private static Body second(double part, double clock) {
        return (source, h, s) -> {
            double[] k = slope(source);
            source.incTime(clock * h);
            double[] l = slopeAt(source, plus(s, part * h, k));
            source.setState(plus(s, h - h / (2 * part), k, h / (2 * part), l));
            source.incTime(h - clock * h);
        };
    }

    static List<Kind> right() {
        return List.of(right("LeapfrogIntegrator", "particles, i += 6", verlet(0.5)),
                right("AdaptiveHeun", "nothing backwards", adaptive(Habit.RIGHT)),
                right("RK2Solver", "with 0.6", second(0.6, 0.6)),
                new Kind(List.of(), "AB2Solver", "if (last == null), reset", () -> new Adams(true)),
                new Kind(List.of(), "StoermerVerlet", "positions before", () -> new Stoermer(1, 0.5)),
                right("BackwardEulerSolver", "NaN in stiff springs", backward(40)));
    }

    static List<Kind> wrong() {
        double[][] last = new double[1][];
        return List.of(wrong(Phrase.OTHER_ORDER, "Gravity", "one body after another", (source, h, s) -> {
            double t = source.getTime();
            double[] end = s.clone();
            for (int body = 0; body < s.length; body += 6) {
                source.incTime(t - source.getTime());
                source.setState(end);
                new RK4Solver().stepState(source, h);
                System.arraycopy(state(source), body, end, body, 6);
            }
            source.setState(end);
        }), wrong(Phrase.STEP, "MidpointSolver", "new velocity", (source, h, s) -> {
            double[] k = slope(source);
            source.incTime(h / 2);
            double[] end = plus(s, h, slopeAt(source, plus(s, h / 2, k)));
            for (int i = 0; i < s.length; i += i % 6 == 2 ? 4 : 1) {
                end[i] = s[i] + h * end[i + 3];
            }
            source.setState(end);
            source.incTime(h / 2);
        }), wrong(Phrase.UNITS, "VelocityVerlet", "d[i] for d[i+3], with drag", (source, h, s) -> {
            double[] a = slope(source);
            double[] trial = move(s, h, 1, a, 0.5, 0);
            for (int i = 3; i < s.length; i += i % 6 == 5 ? 4 : 1) {
                trial[i] += h * a[i - 3];
            }
            source.incTime(h);
            double[] b = slopeAt(source, trial);
            source.setState(move(move(s, h, 1, a, 0.5, 0.5), h, 0, b, 0, 0.5));
        }), wrong(Phrase.ROW, "VerletSolver", "half missing", verlet(1)),
                wrong(Phrase.ROW, "Mine", "midpoint, the clock at the end", second(0.5, 0)),
                wrong(Phrase.OTHER_TIME, "Mine", "with 0.6, the clock at the end", second(0.6, 0)),
                new Kind(List.of(Phrase.FLIGHT), "VerletSolver", "begins without v", () -> new Stoermer(0, 0.5)),
                new Kind(List.of(Phrase.FALL), "VerletSolver", "begins without a", () -> new Stoermer(1, 0)),
                new Kind(List.of(Phrase.KEPT), "AB2Solver", "no reset", () -> new Adams(false)),
                wrong(Phrase.EXPLICIT, "BackwardEulerSolver", "two rounds", backward(2)),
                wrong(Phrase.FLIGHT, "AdaptiveHeun", "keeps what it rejects", adaptive(Habit.KEEPS_REJECTED)),
                wrong(Phrase.NO_CONTROL, "AdaptiveHeun", "error of one particle", adaptive(Habit.LOOKS_AT_ONE)),
                wrong(Phrase.NAN, "AdaptiveHeun", "an endless loop at NaN", adaptive(Habit.WAITS_FOR_NAN)),
                wrong(Phrase.ASTRAY, "AdaptiveHeun", "moves the clock though it rejects", (source, h, s) -> {
                    double[] k = slope(source);
                    source.incTime(h);
                    double[] l = slopeAt(source, plus(s, h, k));
                    source.setState(Math.abs(h * (l[0] - k[0])) < 1e-9 ? plus(s, h / 2, k, h / 2, l) : s);
                }),
                wrong(Phrase.NO_CONTROL, "AdaptiveEuler", "one step size", (source, h, s) -> {
                    source.setState(plus(s, h, slope(source)));
                    source.incTime(h);
                }),
                wrong(Phrase.CLOCK, "EulerSolver", "no clock", (source, h, s) ->
                        source.setState(plus(s, h, slope(source)))),
                wrong(Phrase.CLOCK, "EulerSolver", "no clock where nothing moves", (source, h, s) -> {
                    double[] end = plus(s, h, slope(source));
                    source.setState(end);
                    source.incTime(Arrays.equals(s, end) ? 0 : h);
                }),
                wrong(Phrase.NEVER_SET, "EulerSolver", "never set", (source, h, s) -> {
                    slope(source);
                    source.incTime(h);
                }),
                wrong(Phrase.SWALLOWS, "EulerSolver", "swallows exceptions", (source, h, s) -> {
                    try {
                        source.setState(plus(s, h, slope(source)));
                    } catch (IllegalStateException e) {
                        source.setState(s);
                    }
                    source.incTime(h);
                }),
                wrong(Phrase.NOT_REPEATABLE, "AB2Solver", "a static array", (source, h, s) -> {
                    double[] f = slope(source);
                    double[] before = last[0] == null || last[0].length != f.length ? f : last[0];
                    source.setState(plus(s, 1.5 * h, f, -0.5 * h, before));
                    source.incTime(h);
                    last[0] = f;
                }),
                new Kind(List.of(Phrase.KEPT), "EulerSolver", "keeps its array", PlantedSolvers.KeptArray::new),
                new Kind(List.of(Phrase.KEPT), "EulerSolver", "caches the size", PlantedSolvers.CachedSize::new),
                new Kind(List.of(Phrase.NO_CONVERGENCE), "Mine", "a derivative once",
                        PlantedSolvers.StaleDerivative::new),
                new Kind(List.of(Phrase.KEPT), "EulerSolver", "keeps the first direction", () -> {
                    double[] first = {0};
                    return from((source, h, s) -> {
                        first[0] = first[0] == 0 ? h : first[0];
                        source.setState(plus(s, Math.copySign(h, first[0]), slope(source)));
                        source.incTime(h);
                    }).solver();
                }),
                euler(Phrase.FLIGHT, "0.01 s", (s, f, h) -> plus(s, 0.01, f)),
                euler(Phrase.CONTRADICTS, "the new velocity", (s, f, h) -> {
                    double[] kicked = move(s, h, 0, f, 0, 1);
                    return move(kicked, h, 1, kicked, 0, 0);
                }),
                euler(Phrase.SEVEN_DIGITS, "float", (s, f, h) -> Arrays.stream(plus(s, h, f)).map(x -> (float) x)
                        .toArray()),
                euler(Phrase.ALIKE, "to n - 1", (s, f, h) -> {
                    double[] end = plus(s, h, f);
                    end[s.length - 1] = s[s.length - 1];
                    return end;
                }),
                euler(Phrase.ADDS, "gravity of its own", (s, f, h) -> {
                    double[] end = plus(s, h, f);
                    end[4] -= 9.81 * h;
                    return end;
                }),
                euler(Phrase.FLIGHT, "a limit of the speed", (s, f, h) -> {
                    double[] end = plus(s, h, f);
                    for (int i = 3; i < s.length; i += i % 6 == 5 ? 4 : 1) {
                        end[i] = Math.max(-100, Math.min(100, end[i]));
                    }
                    return end;
                }),
                euler(Phrase.NAN, "NaN taken for 0", (s, f, h) -> plus(s, h, Arrays.stream(f)
                        .map(x -> Double.isNaN(x) ? 0 : x).toArray())));
    }
}
