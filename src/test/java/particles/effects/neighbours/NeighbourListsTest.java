package particles.effects.neighbours;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import particles.law.Particles;
import particles.law.SeededRandom;

/** {@link NeighbourLists} against a {@link NeighbourGrid} that is made anew for every state. */
class NeighbourListsTest {
    private static final int N = 200;
    private static final double RANGE = 0.3;

    /** The later neighbours within range of each particle, in order. */
    private static List<List<Integer>> within(double[] state, int[] near, int[] first, int[] end) {
        List<List<Integer>> all = new ArrayList<>();
        for (int i = 0; i < N; i++) {
            List<Integer> row = new ArrayList<>();
            for (int k = first[i]; k < end[i]; k++) {
                double square = 0;
                for (int c = 0; c < 3; c++) {
                    double r = state[6 * i + c] - state[6 * near[k] + c];
                    square += r * r;
                }
                if (square < RANGE * RANGE) {
                    row.add(near[k]);
                }
            }
            all.add(row);
        }
        return all;
    }

    private static List<List<Integer>> byGrid(double[] state) {
        NeighbourGrid grid = new NeighbourGrid();
        grid.build(state, N, RANGE);
        int[] near = new int[N * N];
        int[] first = new int[N];
        int[] end = new int[N];
        int[] found = new int[N];
        for (int i = 0, count = 0; i < N; i++) {
            first[i] = count;
            int candidates = grid.findLater(i, found);
            System.arraycopy(found, 0, near, count, candidates);
            count += candidates;
            end[i] = count;
        }
        return within(state, near, first, end);
    }

    /**
     * Particles wander, stream past each other, jump, and go back to an earlier state as a solver's trial states do;
     * the list never misses a neighbour, and has them in the grid's order.
     */
    @Test
    void listsOfTrialStatesAndStepsBackAreAsTheGridFindsThem() {
        SeededRandom random = new SeededRandom(3);
        Particles particles = new Particles();
        double[] state = new double[6 * N];
        for (int i = 0; i < N; i++) {
            particles.add("p" + i, 1, false, 0);
            for (int c = 0; c < 3; c++) {
                state[6 * i + c] = 1.2 * random.nextDouble() - 0.6;
            }
        }
        NeighbourLists lists = new NeighbourLists(true);
        double[] radii = new double[N];
        Arrays.fill(radii, RANGE / 2);
        double[] earlier = state.clone();
        int pairs = 0;
        for (int call = 0; call < 400; call++) {
            double step = call % 50 == 49 ? 0.5 : 0.012;
            for (int k = 0; k < state.length; k++) {
                state[k] += step * (random.nextDouble() - 0.5);
            }
            for (int i = 0; i < N; i++) {               // half of them against the other half
                state[6 * i] += (i % 2 == 0 ? 0.01 : -0.01) * (call / 25 % 2 == 0 ? 1 : -1);
            }
            if (call % 7 == 6) {
                System.arraycopy(earlier, 0, state, 0, state.length);
            } else if (call % 7 == 0) {
                earlier = state.clone();
            }
            lists.update(state, particles, radii, RANGE / 2);
            lists.sortByCubes(state, RANGE);
            List<List<Integer>> expected = byGrid(state);
            assertEquals(expected, within(state, lists.near, lists.later,
                    Arrays.copyOfRange(lists.start, 1, N + 1)));
            pairs += expected.stream().mapToInt(List::size).sum();
        }
        assertTrue(pairs > 100_000, "there are neighbours to miss: " + pairs);
    }
}
