package deSolvers.extrapolation;

import static deSolvers.extrapolation.OrderControl.Verdict.ACCEPT;
import static deSolvers.extrapolation.OrderControl.Verdict.CONTINUE;
import static deSolvers.extrapolation.OrderControl.Verdict.REJECT;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.extrapolation.OrderControl.Verdict;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Order and step-size control case by case, from the rules of Hairer, N&oslash;rsett and Wanner. */
class OrderControlTest {
    private static final double H = 2;
    /** Evaluations up to a column: 1 + 2, then 6, 10, 14 ... more. */
    private static final int[] COST = {3, 9, 19, 33, 51, 73, 99, 129, 163};

    private final OrderControl control = new OrderControl();

    @BeforeEach
    void threeIsTheTarget() {
        control.restart(1e-6);
    }

    /** The stretch with which column k would just be good enough: 0.94 (0.65/error)^(1/(2k+1)), within its bounds. */
    private static double best(int k, double error) {
        double power = 1.0 / (2 * k + 1);
        double edge = Math.pow(0.02, power);
        return H * Math.max(edge / 4, Math.min(1 / edge, 0.94 * Math.pow(0.65 / error, power)));
    }

    private void assertNext(double stretch, int target) {
        assertEquals(stretch, control.getNext(), 4e-15 * stretch);     // measured 4e-16
        assertEquals(2 * target + 1, control.targetExponent());
    }

    private void assertVerdict(Verdict expected, int k, double error) {
        assertEquals(expected, control.column(k, error, H), "column " + k + ", error " + error);
    }

    @ParameterizedTest
    @CsvSource({"1e3, 1", "1, 1", "1e-1, 1", "1e-3, 1", "1e-5, 2", "1e-6, 3", "1e-9, 4", "1e-12, 6", "1e-15, 6",
            "0, 6"})
    void theFirstTargetFollowsFromTheTolerance(double tolerance, int target) {
        control.restart(tolerance);
        assertEquals(2 * target + 1, control.targetExponent());
    }

    @Test
    void columnsBeforeTheTargetAreNotAccepted() {
        assertVerdict(CONTINUE, 1, 0);
        assertVerdict(CONTINUE, 1, 1e10);
        assertVerdict(CONTINUE, 1, Double.MAX_VALUE);
        assertVerdict(REJECT, 1, Double.POSITIVE_INFINITY);
        assertNext(H * Math.cbrt(0.02) / 4, 1);
        control.restart(1e-6);
        assertVerdict(REJECT, 1, Double.NaN);
    }

    /** The errors up to which later columns can be expected to converge: a factor (n_j/n_0)^2 for each of them. */
    @Test
    void aHopelessStretchIsRejectedEarly() {
        double both = 7 * 9 * 7 * 9;
        assertVerdict(CONTINUE, 2, 1.0000001);
        assertVerdict(CONTINUE, 2, both);
        assertVerdict(CONTINUE, 3, 81);
        assertVerdict(REJECT, 4, 1.0000001);
        control.restart(1e-6);
        assertVerdict(REJECT, 2, both * 1.0000001);
        control.restart(1e-6);
        assertVerdict(CONTINUE, 2, both);
        assertVerdict(REJECT, 3, 81.00001);
    }

    @Test
    void anErrorOfOneIsAccepted() {
        for (int k = 2; k <= 4; k++) {
            control.restart(1e-6);
            assertVerdict(ACCEPT, k, 1);
        }
    }

    /** Work for a unit of time 23.9 against 36.8: two columns do it for less. */
    @Test
    void aMuchCheaperLowerColumnBecomesTheTarget() {
        assertVerdict(CONTINUE, 2, 1.5);
        assertVerdict(ACCEPT, 3, 0.9);
        assertNext(best(2, 1.5), 2);
    }

    /** 33.4 against 33.8: neither much cheaper nor much dearer. */
    @Test
    void theTargetStaysIfNoColumnIsMuchCheaper() {
        assertVerdict(CONTINUE, 2, 8);
        assertVerdict(ACCEPT, 3, 0.5);
        assertNext(best(3, 0.5), 3);
    }

    /** 109 against 18.9: one more column will probably pay, with a stretch of the same cost per unit of time. */
    @Test
    void aHigherColumnIsTriedIfThisOnePaid() {
        assertVerdict(CONTINUE, 2, 3000);
        assertVerdict(ACCEPT, 3, 1e-3);
        assertNext(best(3, 1e-3) * COST[4] / COST[3], 4);
    }

    /** The bounds between these: 0.8 downwards, 0.9 upwards, by the errors that lie just on either side. */
    @Test
    void theTargetChangesAtItsCostRatios() {
        for (double slightly : new double[] {0.9999, 1.0001}) {
            control.restart(1e-6);
            double work = COST[3] / best(3, 0.9);
            double down = errorForWork(2, 0.8 * work * slightly);
            assertVerdict(CONTINUE, 2, down);
            assertVerdict(ACCEPT, 3, 0.9);
            assertNext(slightly < 1 ? best(2, down) : best(3, 0.9), slightly < 1 ? 2 : 3);
            control.restart(1e-6);
            double up = errorForWork(2, work / 0.9 * slightly);
            assertVerdict(CONTINUE, 2, up);
            assertVerdict(ACCEPT, 3, 0.9);
            assertNext(slightly > 1 ? best(3, 0.9) * COST[4] / COST[3] : best(3, 0.9), slightly > 1 ? 4 : 3);
            control.restart(1e-6);
            double rejected = COST[3] / best(3, 100);
            double lower = errorForWork(2, 0.8 * rejected * slightly);
            assertVerdict(CONTINUE, 2, lower);
            assertVerdict(REJECT, 3, 100);
            assertNext(slightly < 1 ? best(2, lower) : best(3, 100), slightly < 1 ? 2 : 3);
        }
    }

    /** The error with which column k costs so much for a unit of time. */
    private static double errorForWork(int k, double work) {
        return 0.65 / Math.pow(COST[k] / work / H / 0.94, 2 * k + 1);
    }

    @Test
    void theFirstColumnIsNeverTheTargetForLong() {
        control.restart(1e-3);
        assertVerdict(ACCEPT, 1, 0.5);
        assertNext(best(1, 0.5) * COST[2] / COST[1], 2);
        control.restart(1e-3);
        assertVerdict(REJECT, 1, 3000);
        assertNext(best(1, 3000), 1);
        assertVerdict(ACCEPT, 1, 0.5);
        assertNext(best(1, 0.5), 1);
        assertVerdict(ACCEPT, 1, 0.5);
        assertNext(best(1, 0.5) * COST[2] / COST[1], 2);
    }

    /** After a rejection the target does not rise, and one step later it may again. */
    @Test
    void theTargetDoesNotRiseRightAfterARejection() {
        assertVerdict(CONTINUE, 2, 3000);
        assertVerdict(CONTINUE, 3, 80);
        assertVerdict(REJECT, 4, 2);
        assertNext(best(3, 80), 3);
        assertVerdict(CONTINUE, 2, 3000);
        assertVerdict(ACCEPT, 3, 1e-3);
        assertNext(best(3, 1e-3), 3);
        assertVerdict(CONTINUE, 2, 3000);
        assertVerdict(ACCEPT, 3, 1e-3);
        assertNext(best(3, 1e-3) * COST[4] / COST[3], 4);
    }

    /** No more than one column above the target, even if the column above was the one that was accepted. */
    @Test
    void theTargetRisesByOneAtATime() {
        assertVerdict(CONTINUE, 2, 3000);
        assertVerdict(CONTINUE, 3, 80);
        assertVerdict(ACCEPT, 4, 1e-6);
        assertNext(best(4, 1e-6), 4);
    }

    @Test
    void theTargetNeverPassesTheLastColumn() {
        control.restart(1e-12);
        assertVerdict(CONTINUE, 5, 1e4);
        assertVerdict(CONTINUE, 6, 100);
        assertVerdict(ACCEPT, 7, 1e-4);
        assertNext(best(7, 1e-4), 7);
        assertVerdict(CONTINUE, 6, 1e4);
        assertVerdict(CONTINUE, 7, 289);
        assertVerdict(ACCEPT, 8, 1e-4);
        assertNext(best(8, 1e-4), 7);
    }
}
