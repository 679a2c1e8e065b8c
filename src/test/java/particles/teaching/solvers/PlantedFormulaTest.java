package particles.teaching.solvers;

import static particles.teaching.solvers.PlantedSolvers.MOVES;
import static particles.teaching.solvers.PlantedSolvers.NEW_STATE;
import static particles.teaching.solvers.PlantedSolvers.PLACES;
import static particles.teaching.solvers.PlantedSolvers.WEIGHTS;
import static particles.teaching.solvers.PlantedSolvers.assertFound;
import static particles.teaching.solvers.PlantedSolvers.blocks;
import static particles.teaching.solvers.PlantedSolvers.euler;
import static particles.teaching.solvers.PlantedSolvers.midpoint;
import static particles.teaching.solvers.PlantedSolvers.rk4;
import static particles.teaching.solvers.PlantedSolvers.slope;
import static particles.teaching.solvers.PlantedSolvers.slopeAt;
import static particles.teaching.solvers.PlantedSolvers.solver;
import static particles.teaching.solvers.PlantedSolvers.state;
import static particles.teaching.solvers.PlantedSolvers.with;

import org.junit.jupiter.api.Test;

/** Mistakes in the formula. Every planted one is named, and nothing else is. */
class PlantedFormulaTest {
    /** The scaffolding itself makes no mistakes. */
    @Test
    void withoutAMistakeNothingIsFound() {
        assertFound("Mine", () -> rk4(PLACES, MOVES, WEIGHTS));
        assertFound("Mine", () -> midpoint(0.5, 0.5, 0.5));
        assertFound("Mine", () -> euler((dSdt, deltaT) -> dSdt * deltaT));
        assertFound("Mine", () -> blocks(true));
        assertFound("Mine", () -> blocks(false));
        assertFound("SymplecticEuler", () -> blocks(true));
        assertFound("EulerSolver", () -> blocks(false));
    }

    @Test
    void wrongWeight() {
        assertFound("Mine", () -> rk4(PLACES, MOVES, new double[] {1.0 / 6, 1.0 / 3, 1.0 / 6, 1.0 / 6}),
                "method: the new state is s + k1/6 + k2/3 + k3/6 + k4/6" + NEW_STATE
                        + ": the weight of k3 is 1/6 instead of 1/3");
    }

    @Test
    void k2FromK1WithoutTheHalf() {
        assertFound("Mine", () -> rk4(new double[] {1, 0.5, 1}, MOVES, WEIGHTS),
                "method: k2 is evaluated at s + k1; the slide says s + k1/2: the half is missing");
    }

    @Test
    void midpointWithoutTheHalf() {
        assertFound("Mine", () -> midpoint(1, 0.5, 0.5),
                "method: gMid is evaluated at s + deltaS; the slide says s + deltaS/2: the half is missing");
    }

    @Test
    void newVelocityWhereEulerTakesTheOld() {
        assertFound("EulerSolver", () -> blocks(true),
                "name: the position is updated with the new velocity; the slide's Euler method takes the old");
    }

    @Test
    void oldVelocityWhereTheSimpleAlgorithmTakesTheNew() {
        assertFound("SymplecticEulerSolver", () -> blocks(false),
                "name: the position is updated with the old velocity, which is the Euler method; the slides' simple "
                        + "algorithm takes the new");
    }

    @Test
    void signError() {
        assertFound("Mine", () -> euler((dSdt, deltaT) -> -dSdt * deltaT),
                "method: the new state is s - deltaS; the slide says s + deltaS: the sign is wrong");
    }

    @Test
    void lastStageForgotten() {
        assertFound("RK4Solver", () -> solver((source, deltaT) -> {
            double[] state = state(source);
            double[] k1 = slope(source);
            source.incTime(deltaT / 2);
            double[] k2 = slopeAt(source, with(state, i -> deltaT / 2 * k1[i]));
            double[] k3 = slopeAt(source, with(state, i -> deltaT / 2 * k2[i]));
            source.setState(with(state, i -> deltaT * (k1[i] / 6 + k2[i] / 3 + k3[i] / 3)));
            source.incTime(deltaT / 2);
        }), "method: k4 is missing: the calls of getStateDerivative are 3, the slide needs 4");
    }

    @Test
    void wholeNumbersDivided() {
        assertFound("RK4Solver", () -> rk4(PLACES, MOVES, new double[] {1 / 6, 1 / 3, 1 / 3, 1 / 6}),
                "method: the new state is s" + NEW_STATE + ": no derivative is in it: it was"
                        + " left out, or 1/6 is 0 in Java");
    }

    @Test
    void stepTakenFromTheMiddle() {
        assertFound("MidpointSolver", () -> solver((source, deltaT) -> {
            double[] state = state(source);
            double[] dSdt = slope(source);
            source.incTime(deltaT / 2);
            double[] gMid = slopeAt(source, with(state, i -> deltaT / 2 * dSdt[i]));
            source.setState(with(state(source), i -> deltaT * gMid[i]));
            source.incTime(deltaT / 2);
        }), "method: the new state is s + deltaS/2 + deltaT gMid; the slide says s + deltaT gMid: go back to the start "
                + "s before adding");
    }

    @Test
    void heunWithoutTheHalf() {
        assertFound("HeunSolver", () -> solver((source, deltaT) -> {
            double[] state = state(source);
            double[] k1 = slope(source);
            source.incTime(deltaT);
            double[] k2 = slopeAt(source, with(state, i -> deltaT * k1[i]));
            source.setState(with(state, i -> deltaT * (k1[i] + k2[i])));
        }), "method: the new state is s + k1 + k2; Heun's method says s + k1/2 + k2/2: the half is missing");
    }

    @Test
    void anotherMethodThanTheNameSays() {
        assertFound("HeunSolver", () -> midpoint(0.5, 0.5, 0.5),
                "name: this is the midpoint method and not Heun's method, as its name says");
    }

    @Test
    void verletWithTheOldAccelerationOnly() {
        assertFound("VerletSolver", () -> solver((source, deltaT) -> {
            double[] state = state(source);
            double[] dSdt = slope(source);
            for (int x = 0; x < state.length; x += x % 6 == 2 ? 4 : 1) {
                state[x] += state[x + 3] * deltaT + dSdt[x + 3] * deltaT * deltaT / 2;
                state[x + 3] += dSdt[x + 3] * deltaT;
            }
            source.setState(state);
            source.incTime(deltaT);
        }), "method: a2 is missing: the calls of getStateDerivative are 1, the method needs 2"
                + ": the acceleration at the new position is missing");
    }
}
