package particles;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolver;
import deSolvers.DESolverException;
import deSolvers.DEStateSource;
import deSolvers.EulerSolver;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import particles.law.Vector3;

/** Steps with very many events: those that end are made, and those that would not are given up early. */
class EventStepsTest {
    /** Events at times that a sequence gives. */
    private static class Sequence implements EventRule {
        private final IntToDoubleFunction gap;
        private double next;
        private int events;

        /** @param gap the time from event number n to the next (s); infinite after the last */
        Sequence(IntToDoubleFunction gap) {
            this.gap = gap;
        }

        @Override
        public String getName() {
            return "events";
        }

        @Override
        public void start(ParticleSystem system) {
            next = gap.applyAsDouble(0);
        }

        @Override
        public boolean afterStep(ParticleSystem system, double deltaT) {
            return false;
        }

        @Override
        public void findEvents(Motion motion, List<Event> found) {
            if (motion.getEndTime() <= next) {
                return;
            }
            found.add(new Event(Math.max(next, motion.getStartTime()), false,
                    () -> next - motion.getSystem().getTime(), () -> {
                        events++;
                        next += gap.applyAsDouble(events);
                    }));
        }
    }

    private static ParticleSystem run(Sequence sequence) {
        return run(sequence, EulerSolver::new);
    }

    private static ParticleSystem run(Sequence sequence, Supplier<DESolver> solver) {
        ParticleSystem system = Systems.oneParticle(Vector3.ZERO, new Vector3(1, 0, 0));
        Simulation simulation = new Simulation(system, solver, 0.1, 0.2);
        simulation.addRule(sequence);
        simulation.run();
        return system;
    }

    /** Twice 105 events for one particle, where 100,000 are allowed. */
    @Test
    void eventsThatGoOnAsTheyDidAreGivenUpSoon() {
        Sequence sequence = new Sequence(n -> 1e-8);
        SimulationException e = assertThrows(SimulationException.class, () -> run(sequence));
        assertEquals(210, sequence.events);
        assertEquals(210e-8, e.getTime(), 1e-12);
        assertEquals("contacts make no headway: the last 105 impacts or changes of contact cover 1.05e-6 s, and"
                + " 0.1 s of the step are left", e.getMessage());
    }

    /** The bounces of a ball with restitution 0.998 take 0.05 s; the last ones are 1e-11 s apart. */
    @Test
    void everSmallerBouncesAreAllMade() {
        Sequence sequence = new Sequence(n -> n < 8_000 ? 1e-4 * StrictMath.pow(0.998, n) : Double.POSITIVE_INFINITY);
        assertEquals(0.2, run(sequence).getOwnState()[0], 1e-12);
        assertEquals(8_000, sequence.events);
    }

    /** At regular times, one step of 0.1 s may have 50 times 105 events; here it has 4,545. */
    @Test
    void regularEventsThatTheStepHoldsAreMade() {
        Sequence sequence = new Sequence(n -> 2.2e-5);
        assertEquals(0.2, run(sequence).getTime(), 1e-15);
        assertTrue(sequence.events == 9_090, sequence.events + " events");
    }

    /** Makes a laborious solver for the run, then an ordinary one that locates events. */
    private static Supplier<DESolver> laborious() {
        return List.<DESolver>of(new Laborious(), new EulerSolver()).iterator()::next;
    }

    /** Each step of the solver costs 400,000 evaluations, as where a particle creeps; the third is over the limit. */
    @Test
    void aStepOfTooManyEvaluationsIsGivenUpOnlyWhereItMayHaveManyParts() {
        assertEquals(0.2, run(new Parts(0.1), laborious()).getOwnState()[0], 1e-12);
        assertEquals(0.2, run(new Parts(0.1 / 64), laborious()).getOwnState()[0], 1e-12, "at most 64 parts");
        SimulationException e = assertThrows(SimulationException.class, () -> run(new Parts(0), laborious()));
        assertEquals("contacts make no headway: this step took 1200006 evaluations, and 0.07 s of the step are left",
                e.getMessage());
    }

    private static final class Parts extends Sequence {
        private final double shortest;

        Parts(double shortest) {
            super(n -> 0.01);
            this.shortest = shortest;
        }

        @Override
        public boolean mayDivide(double length, double deltaT) {
            return length > shortest;
        }
    }

    /**
     * A solver that fails at steps over 0.03 s makes those of 0.1 s in four parts, of which the first has an event, and
     * the rule acts after each.
     */
    @Test
    void aStepAtWhichTheSolverFailsIsDividedWhereARuleAllowsIt() {
        List<Double> acts = new ArrayList<>();
        Sequence contact = new Sequence(n -> n == 0 ? 0.01 : Double.POSITIVE_INFINITY) {
            @Override
            public boolean mayDivide(double length, double deltaT) {
                return true;
            }

            @Override
            public boolean afterStep(ParticleSystem system, double deltaT) {
                acts.add(system.getTime());
                return false;
            }
        };
        assertEquals(0.2, run(contact, () -> new ShortSteps(0.03)).getOwnState()[0], 1e-15);
        double[] ends = {0.025, 0.05, 0.075, 0.1, 0.125, 0.15, 0.175, 0.2};
        assertArrayEquals(ends, acts.stream().mapToDouble(t -> t).toArray(), 1e-15);
    }

    /** At most into 64 parts; and not at all without such a rule. */
    @Test
    void aStepIsNotDividedForEver() {
        Sequence contact = new Sequence(n -> Double.POSITIVE_INFINITY) {
            @Override
            public boolean mayDivide(double length, double deltaT) {
                return length > deltaT / 64;
            }
        };
        assertEquals(0.2, run(contact, () -> new ShortSteps(0.1 / 63)).getOwnState()[0], 1e-14);
        assertThrows(SimulationException.class, () -> run(contact, () -> new ShortSteps(0.1 / 65)));
        assertThrows(SimulationException.class,
                () -> run(new Sequence(n -> Double.POSITIVE_INFINITY), () -> new ShortSteps(0.09)));
    }

    /** At t = 1000 s the clock has no time within 1.1e-13 s. */
    @Test
    void aStepIsNotDividedWhereTheClockHasNoMiddle() {
        ParticleSystem system = Systems.oneParticle(Vector3.ZERO, new Vector3(1, 0, 0));
        system.incTime(1000);
        Simulation simulation = new Simulation(system, () -> new ShortSteps(0), 0.1, 0.2);
        simulation.addRule(new Parts(0));
        assertEquals(1000, assertThrows(SimulationException.class, simulation::run).getTime());
    }

    /** Euler's method, but it fails at steps longer than it likes. */
    private static final class ShortSteps extends DESolver {
        private final EulerSolver euler = new EulerSolver();
        private final double longest;

        ShortSteps(double longest) {
            this.longest = longest;
        }

        @Override
        public void stepState(DEStateSource source, double deltaT) {
            if (deltaT > longest) {
                throw new DESolverException(ShortSteps.class, source.getTime(), deltaT, -1, "too long", "");
            }
            euler.stepState(source, deltaT);
        }
    }

    private static final class Laborious extends DESolver {
        private final EulerSolver euler = new EulerSolver();

        @Override
        public void stepState(DEStateSource source, double deltaT) {
            double[] dSdt = new double[source.getStateSize()];
            for (int i = 0; i < 400_000; i++) {
                source.getStateDerivative(dSdt);
            }
            euler.stepState(source, deltaT);
        }
    }
}
