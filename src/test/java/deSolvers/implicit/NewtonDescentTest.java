package deSolvers.implicit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.linear.ImplicitWork;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The way downhill to where Newton's method converges, on equations of one unknown each. */
class NewtonDescentTest {
    private final ImplicitWork.Counter work = new ImplicitWork.Counter();
    private final Newton newton = new Newton(work);

    /**
     * The slope 3 - u with a matrix that is ten times too small: the secant finds where it is flat, and Newton the
     * rest.
     */
    @Test
    void descendingGoesWhereTheSlopeIsFlat() {
        EquationsOfOne problem = new EquationsOfOne(1, u -> 3 - u, u -> 1);
        problem.definite = 0.1;
        double[] u = {1};
        newton.solve(problem, new double[] {3}, new double[] {1});     // makes the work arrays
        problem.asked.clear();
        work.newtonIterations = 0;
        assertTrue(newton.descend(problem, u, new double[] {1}));
        assertEquals(3, u[0], 1e-15);
        assertEquals(List.of(1.0, 21.0), problem.asked.subList(0, 2), "twenty times too far");
        assertEquals(3, problem.asked.get(2), 1e-15, "a tenth of it");

        // 3.3 times too far: the secant itself.
        EquationsOfOne far = new EquationsOfOne(1, v -> 3 - v, v -> 1);
        far.definite = 0.3;
        assertTrue(newton.descend(far, new double[] {1}, new double[] {1}));
        assertEquals(3, far.asked.get(2), 1e-15);

        // Where there is no number so far out, a tenth of the way is tried.
        EquationsOfOne edge = new EquationsOfOne(1, v -> v > 3.5 ? Double.NaN : 3 - v, v -> 1);
        edge.definite = 0.5;
        assertTrue(newton.descend(edge, new double[] {1}, new double[] {1}));
        assertEquals(List.of(1.0, 5.0, 1.4), edge.asked.subList(0, 3));

        // Where the slope falls by less than half beyond its middle, the whole correction is taken.
        EquationsOfOne near = new EquationsOfOne(1, v -> 3 - v, v -> 1);
        near.definite = 0.75;
        u[0] = 1;
        assertTrue(newton.descend(near, u, new double[] {1}));
        assertEquals(1 + 2 / 0.75, near.asked.get(1), 1e-15);
        assertEquals(near.asked.get(1) + (3 - near.asked.get(1)) / 0.75, near.asked.get(2), 1e-15);
        assertEquals(3, u[0], 1e-12);
        EquationsOfOne none = new EquationsOfOne(1, v -> 3 - v, v -> 1);
        assertFalse(newton.descend(none, new double[] {1}, new double[] {1}), "none is definite");
    }

    /** Newton's own steps jump from well to well of a wavy slope; downhill they end in the one they are in. */
    @Test
    void descendingReachesWhatNewtonDoesNot() {
        EquationsOfOne problem = new EquationsOfOne(1, u -> -u - 3 * StrictMath.sin(3 * u),
                u -> 1 + 9 * StrictMath.cos(3 * u));
        problem.definite = 10;
        double[] u = {0.5};
        newton.solve(problem, new double[] {0}, new double[] {1});     // makes the work arrays
        assertTrue(newton.descend(problem, u, new double[] {1}));
        assertEquals(0, u[0], 1e-12);
        EquationsOfOne flat = new EquationsOfOne(1, v -> 1, v -> 1);
        flat.definite = 1;                              // downhill for ever, until given up
        work.newtonIterations = 0;
        assertFalse(newton.descend(flat, new double[] {0}, new double[] {1}));
        assertTrue(work.newtonIterations >= 200, work.newtonIterations + " corrections");
        assertTrue(newton.describeFailure().contains("after 200 iterations"), newton.describeFailure());
        EquationsOfOne jump = new EquationsOfOne(1, v -> v < 1 ? 1 : -1, v -> 1);
        jump.definite = 1;                              // no place is flat about: 40 ever shorter parts are tried
        double[] edge = {Math.nextDown(1.0)};
        newton.solve(jump, new double[] {1}, new double[] {1});
        jump.asked.clear();
        assertFalse(newton.descend(jump, edge, new double[] {1}));
        assertEquals(41, jump.asked.size());
    }

    /**
     * Newton's method, tried on the way, may lead astray: then the way goes on from where it was, with the residual
     * there, and Newton's method has to wait until corrections are a tenth of what they were.
     */
    @Test
    void whereNewtonFailsOnTheWayTheWayGoesOn() {
        // From 1 half of the way is taken, to 2; there the matrix is singular. Close to 3 it is what it should be.
        EquationsOfOne problem = new EquationsOfOne(1, v -> 3 - v, v -> v == 1 ? 2 : v < 2.5 ? 0 : 1);
        problem.definite = 50;
        newton.solve(problem, new double[] {3}, new double[] {1});     // makes the work arrays
        problem.asked.clear();
        problem.linearisations = 0;
        double[] u = {1};
        assertTrue(newton.descend(problem, u, new double[] {1}));
        assertEquals(List.of(1.0, 1.0, 2.0, 1.0, 1.04), problem.asked.subList(0, 5), "tried, back, and down");
        assertEquals(3, u[0], 1e-15);
        assertEquals(3, problem.linearisations, "twice when it was tried too early, and once in the end");
        // (3 - u)/50 is less than a tenth of 0.04/1.04 of u where u > 2.516: 1 - (3 - u)/2 = 1 - 0.98^k, from k = 71
        // on.
        assertEquals(5 + 70 + 2, problem.asked.size());
    }
}
