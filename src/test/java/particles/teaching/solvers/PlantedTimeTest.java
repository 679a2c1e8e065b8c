package particles.teaching.solvers;

import static particles.teaching.solvers.PlantedSolvers.PLACES;
import static particles.teaching.solvers.PlantedSolvers.WEIGHTS;
import static particles.teaching.solvers.PlantedSolvers.assertFound;
import static particles.teaching.solvers.PlantedSolvers.euler;
import static particles.teaching.solvers.PlantedSolvers.midpoint;
import static particles.teaching.solvers.PlantedSolvers.rk4;
import static particles.teaching.solvers.PlantedSolvers.slope;
import static particles.teaching.solvers.PlantedSolvers.slopeAt;
import static particles.teaching.solvers.PlantedSolvers.solver;
import static particles.teaching.solvers.PlantedSolvers.state;
import static particles.teaching.solvers.PlantedSolvers.with;

import org.junit.jupiter.api.Test;

/** Mistakes with the clock and with deltaT. Every planted one is named, and nothing else is. */
class PlantedTimeTest {
    @Test
    void k4AtTheWrongTime() {
        assertFound("Mine", () -> rk4(PLACES, new double[] {0.5, 0, 0, 0.5}, WEIGHTS),
                "time: k4 is evaluated at t + deltaT/2; the slide says t + deltaT");
    }

    @Test
    void clockMovedOnlyAtTheEnd() {
        assertFound("Mine", () -> rk4(PLACES, new double[] {0, 0, 0, 1}, WEIGHTS),
                "time: k2 is evaluated at t; the slide says t + deltaT/2: the clock has to be moved with");
    }

    @Test
    void noIncTime() {
        assertFound("Mine", () -> solver((source, deltaT) -> {
            double[] dSdt = slope(source);
            source.setState(with(state(source), i -> deltaT * dSdt[i]));
        }), "time: the clock never moves: incTime(deltaT) is missing");
        assertFound("Mine", () -> solver((source, deltaT) -> {
            double[] state = state(source);
            double[] dSdt = slope(source);
            double[] gMid = slopeAt(source, with(state, i -> deltaT / 2 * dSdt[i]));
            source.setState(with(state, i -> deltaT * gMid[i]));
        }), "time: the clock never moves: incTime(deltaT) is missing");
    }

    @Test
    void incTimeTwice() {
        assertFound("Mine", () -> solver((source, deltaT) -> {
            double[] dSdt = slope(source);
            source.setState(with(state(source), i -> deltaT * dSdt[i]));
            source.incTime(deltaT);
            source.incTime(deltaT);
        }), "time: the clock ends at t + 2 deltaT after a step");
    }

    @Test
    void theHalfStepOfTheClockStaysOn() {
        assertFound("Mine", () -> midpoint(0.5, 0.5, 1),
                "time: the clock ends at t + 3/2 deltaT after a step of deltaT = 1/32 s and has to end at t + deltaT");
    }

    @Test
    void deltaTIgnored() {
        assertFound("Mine", () -> euler((dSdt, deltaT) -> dSdt),
                "method: the new state is s + 4 k1, which does not follow deltaT: deltaT is ignored");
    }

    @Test
    void deltaTHardCoded() {
        assertFound("Mine", () -> euler((dSdt, deltaT) -> 0.01 * dSdt),
                "method: the new state is s + k1/25, which does not follow deltaT:"
                        + " a time step of 0.01000 s is hard-coded, and deltaT is ignored");
    }

    @Test
    void clockHardCoded() {
        assertFound("Mine", () -> solver((source, deltaT) -> {
            double[] dSdt = slope(source);
            source.setState(with(state(source), i -> deltaT * dSdt[i]));
            source.incTime(0.125);
        }), "time: the clock moves by 1/8 s in every step, whatever deltaT is: it is hard-coded");
    }

    @Test
    void derivativeDividedByDeltaT() {
        assertFound("Mine", () -> euler((dSdt, deltaT) -> dSdt / deltaT),
                "method: the new state is s + 16 k1, which does not follow deltaT: "
                        + "the derivative is divided by deltaT; it has to be "
                        + "multiplied by deltaT");
    }
}
