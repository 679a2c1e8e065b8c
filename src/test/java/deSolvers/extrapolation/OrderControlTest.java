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

    /**
     * After the verdict on each column by its error, "best" is the stretch that is best for a column, which becomes the
     * target; "more" is one column more than that, with a stretch of the same cost per unit of time. Later columns can
     * be expected to converge up to an error of (n_j/n_0)^2 for each of them: 49 81 = 3969 for two.
     */
    @ParameterizedTest(name = "{0}")
    @CsvSource(delimiter = '|', textBlock = """
            columns before the target are not accepted | 1e-6 | CONTINUE 1 0; CONTINUE 1 1e10; \
            CONTINUE 1 1.7976931348623157e308; REJECT 1 Infinity; best 1 Infinity
            not a number                               | 1e-6 | REJECT 1 NaN
            errors that leave hope                     | 1e-6 | CONTINUE 2 1.0000001; CONTINUE 2 3969; CONTINUE 3 81; \
            REJECT 4 1.0000001
            no hope in two columns                     | 1e-6 | REJECT 2 3969.0001
            no hope in one column                      | 1e-6 | CONTINUE 2 3969; REJECT 3 81.00001
            one before the target                      | 1e-6 | ACCEPT 2 1
            an error of one is accepted                | 1e-6 | ACCEPT 3 1
            one after the target                       | 1e-6 | ACCEPT 4 1
            a lower column is much cheaper: 23.9, 36.8 | 1e-6 | CONTINUE 2 1.5; ACCEPT 3 0.9; best 2 1.5
            neither is much cheaper: 33.4, 33.8        | 1e-6 | CONTINUE 2 8; ACCEPT 3 0.5; best 3 0.5
            this column paid: 109, 18.9                | 1e-6 | CONTINUE 2 3000; ACCEPT 3 1e-3; more 3 1e-3
            from the first column the target rises     | 1e-3 | ACCEPT 1 0.5; more 1 0.5
            but not right after a rejection            | 1e-3 | REJECT 1 3000; best 1 3000; ACCEPT 1 0.5; best 1 0.5; \
            ACCEPT 1 0.5; more 1 0.5
            nor does it from another column            | 1e-6 | CONTINUE 2 3000; CONTINUE 3 80; REJECT 4 2; best 3 80; \
            CONTINUE 2 3000; ACCEPT 3 1e-3; best 3 1e-3; CONTINUE 2 3000; ACCEPT 3 1e-3; more 3 1e-3
            the target rises by one at a time          | 1e-6 | CONTINUE 2 3000; CONTINUE 3 80; ACCEPT 4 1e-6; \
            best 4 1e-6
            the last column is no target               | 1e-12 | CONTINUE 5 1e4; CONTINUE 6 100; ACCEPT 7 1e-4; \
            best 7 1e-4; CONTINUE 6 1e4; CONTINUE 7 289; ACCEPT 8 1e-4; best 8 1e-4
            """)
    void columnsAreJudgedByTheirErrors(String why, double tolerance, String script) {
        control.restart(tolerance);
        for (String part : script.split("; ")) {
            String[] words = part.split(" ");
            int k = Integer.parseInt(words[1]);
            double error = Double.parseDouble(words[2]);
            switch (words[0]) {
                case "best" -> assertNext(best(k, error), Math.min(k, COST.length - 2));
                case "more" -> assertNext(best(k, error) * COST[k + 1] / COST[k], k + 1);
                default -> assertVerdict(Verdict.valueOf(words[0]), k, error);
            }
        }
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
}
