package deSolvers.linear;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.JacobianBlocks;
import deSolvers.JacobianStateSource;
import deSolvers.implicit.BlockByBlock;
import deSolvers.implicit.NamedBlocks;
import java.util.Arrays;
import java.util.Random;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/** The sparse matrix M - g D - g^2 K beside a full one, into which everything is written where it belongs. */
class BlockMatrixTest {
    private static final int ROWS = 4;
    private static final double G = 0.25;
    private static final double[] MASSES = {2, 0.5, 0, 3};      // the third particle is held

    private final Random random = new Random(12);
    private final ImplicitWork.Counter work = new ImplicitWork.Counter();
    private final BlockMatrix matrix = new BlockMatrix(work);

    @Test
    void aSourceThatSaysNothingHasNoBlocksAndUnitMasses() {
        JacobianStateSource source = new NamedBlocks(ROWS, blocks -> { });
        assertEquals(JacobianStateSource.Blocks.NONE, source.getJacobianBlocks());
        assertEquals(1, source.getInverseMass(3));
    }

    /** The same, with all that is not 0 in its place; and, by row, the sum of what each term of a force may be. */
    private static final class Full extends BlockByBlock {
        final double[][] k = new double[3 * ROWS][3 * ROWS];
        final double[] scale = new double[3 * ROWS];
        private final double[] state;

        Full(double[] state) {
            this.state = state;
        }

        @Override
        public void put(int i, int j, double[] dFdX, double[] dFdV, double sign) {
            for (int e = 0; e < 9; e++) {
                k[3 * i + e / 3][3 * j + e % 3] += sign * (G * G * dFdX[e] + G * dFdV[e]);
                scale[3 * i + e / 3] += Math.abs(dFdX[e] * state[6 * j + e % 3]);
            }
        }

        @Override
        public void transformRow(int i, double[] m) {
            double[][] rows = {k[3 * i].clone(), k[3 * i + 1].clone(), k[3 * i + 2].clone()};
            double[] before = Arrays.copyOfRange(scale, 3 * i, 3 * i + 3);
            for (int a = 0; a < 3; a++) {
                scale[3 * i + a] = 0;
                Arrays.fill(k[3 * i + a], 0);
                for (int b = 0; b < 3; b++) {
                    scale[3 * i + a] += Math.abs(m[3 * a + b]) * before[b];
                    for (int c = 0; c < 3 * ROWS; c++) {
                        k[3 * i + a][c] += m[3 * a + b] * rows[b][c];
                    }
                }
            }
        }

        /** The product of M - K with x, where held rows are those of the unit matrix. */
        double[] apply(double[] x) {
            double[] y = new double[3 * ROWS];
            for (int r = 0; r < y.length; r++) {
                double mass = MASSES[r / 3];
                y[r] = mass == 0 ? x[r] : mass * x[r];
                for (int c = 0; c < y.length && mass != 0; c++) {
                    y[r] -= k[r][c] * x[c];
                }
            }
            return y;
        }
    }

    private double[] random(int n) {
        return random.doubles(n, -1, 1).toArray();
    }

    private Full collect(Consumer<JacobianBlocks> blocks) {
        double[] state = random(6 * ROWS);
        Full full = new Full(state);
        blocks.accept(full);
        matrix.collect(new NamedBlocks(ROWS, blocks), state, G, MASSES, false);
        for (int n = 0; n < 5; n++) {
            double[] x = random(3 * ROWS);
            double[] y = new double[3 * ROWS];
            matrix.apply(x, y);
            assertArrayEquals(full.apply(x), y, 8e-15);                 // measured 8.9e-16
        }
        assertArrayEquals(full.scale, matrix.forceScale(), 1e-14);
        return full;
    }

    @Test
    void everyBlockHasItsPlace() {
        for (int n = 1; n <= 20; n++) {
            double[][] b = new double[14][];
            Arrays.setAll(b, e -> random(9));
            collect(blocks -> NamedBlocks.addOneOfEach(blocks, b));
            assertEquals(n, work.jacobians);
        }
        long before = work.blockOperations;
        matrix.apply(new double[3 * ROWS], new double[3 * ROWS]);
        // 4 on the diagonal; 03, 12, 01 and 13 with their mirrors
        assertEquals(12, work.blockOperations - before);
    }

    /** Another set of pairs makes another pattern; and back. */
    @Test
    void pairsMayComeAndGo() {
        double[] b = random(9);
        double[] c = random(9);
        collect(blocks -> blocks.addPair(0, 1, b, c));
        collect(blocks -> {
            blocks.addPair(0, 1, b, c);
            blocks.addPair(1, 3, c, b);
        });
        collect(blocks -> blocks.addPair(1, 3, c, b));
        collect(blocks -> blocks.add(3, 3, c, b));
    }

    private static double[] symmetric(double[] b) {
        return new double[] {b[0], b[1], b[2], b[1], b[3], b[4], b[2], b[4], b[5]};
    }

    private boolean isSymmetric(Consumer<JacobianBlocks> blocks) {
        collect(blocks);
        return matrix.isSymmetric();
    }

    @Test
    void aMirrorImageIsSeen() {
        double[] s = symmetric(random(9));
        double[] none = new double[9];
        double[] skew = {0, 1, 0, -1, 0, 0, 0, 0, 0};
        assertTrue(isSymmetric(blocks -> {
            blocks.addPair(0, 1, s, s);
            blocks.addPair(1, 3, s, none);
            blocks.add(3, 3, s, s);
        }));
        assertFalse(isSymmetric(blocks -> blocks.add(0, 0, skew, none)), "a block on the diagonal");
        assertFalse(isSymmetric(blocks -> blocks.add(3, 3, none, skew)), "the last");
        assertFalse(isSymmetric(blocks -> blocks.addPair(0, 1, skew, none)), "a pair");
        assertFalse(isSymmetric(blocks -> blocks.add(3, 0, s, none)), "one half of a pair");
        assertFalse(isSymmetric(blocks -> blocks.add(0, 3, s, none)), "the other");
        assertTrue(isSymmetric(blocks -> blocks.add(0, 2, s, none)), "what acts on one that is held is not looked at");
        assertTrue(isSymmetric(blocks -> blocks.add(2, 0, s, none)));
        for (int e : new int[] {1, 2, 3, 5, 6, 7}) {
            double[] one = new double[9];
            one[e] = 1;
            assertFalse(isSymmetric(blocks -> blocks.add(1, 1, one, none)), "entry " + e);
        }
    }

    /** How much stiffer the springs make a particle than it is inert, by the trace of its block. */
    @Test
    void theStiffestParticleMakesTheCondition() {
        double[] k = {-64, 0, 0, 0, -32, 0, 0, 0, -16};         // g^2 k: 4, 2, 1
        collect(blocks -> blocks.add(3, 3, k, new double[9]));
        assertEquals((4 + 2 + 1 + 9) / 3.0, matrix.condition(), 1e-15);
        collect(blocks -> blocks.add(1, 1, k, new double[9]));
        assertEquals((4 + 2 + 1 + 1.5) / 0.5, matrix.condition(), 1e-15);
        collect(blocks -> blocks.add(2, 2, k, new double[9]));
        assertEquals(3, matrix.condition(),
                "one that is held is as stiff as it is inert, and the others are not stiff");
    }

    /** Only what pulls a pair back may be in a definite matrix: of (-4, 3, -1) along the axes, -4 and -1. */
    @Test
    void aDefiniteMatrixLeavesOutWhatPushesOutwards() {
        double[] k = {-4, 0, 0, 0, 3, 0, 0, 0, -1};
        double[] restoring = {-4, 0, 0, 0, 0, 0, 0, 0, -1};
        double[] state = random(6 * ROWS);
        double[] none = new double[9];
        Full full = new Full(state);
        full.addPair(0, 1, restoring, none);
        for (boolean definite : new boolean[] {true, false}) {
            matrix.collect(new NamedBlocks(ROWS, blocks -> blocks.addPair(0, 1, k, none)), state, G, MASSES, definite);
            double[] x = {0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
            double[] y = new double[3 * ROWS];
            matrix.apply(x, y);
            assertEquals(definite ? 2 : 2 - 3 * G * G, y[1], 2e-16);     // measured 0, as the next
            assertEquals(definite ? 0 : 3 * G * G, y[4], 2e-16);
            double[] z = random(3 * ROWS);
            matrix.apply(z, y);
            double[] expected = full.apply(z);
            assertEquals(expected[0], y[0], 2e-16);              // measured 2.8e-17 at most
            assertEquals(expected[5], y[5], 2e-16);
        }
    }

    /** Each diagonal block is inverted by itself, at one product a row; a singular one is refused. */
    @Test
    void diagonalBlocksAreInverted() {
        double[][] b = new double[6][];
        Arrays.setAll(b, e -> random(9));
        collect(blocks -> {
            blocks.addPair(0, 1, b[0], b[1]);
            blocks.add(3, 3, b[2], b[3]);
            blocks.add(1, 1, b[4], b[5]);
        });
        BlockJacobi inverse = new BlockJacobi(work);
        assertTrue(inverse.prepare(matrix.pattern(), matrix.values()));
        double[] x = random(3 * ROWS);
        double[] y = random(3 * ROWS);
        long before = work.blockOperations;
        inverse.apply(x, y);
        assertEquals(ROWS, work.blockOperations - before);
        for (int i = 0; i < ROWS; i++) {
            double[] back = new double[3];
            Block3.multiplyAdd(matrix.values(), 9 * matrix.pattern().diagonal[i], y, 3 * i, back, 0);
            assertArrayEquals(Arrays.copyOfRange(x, 3 * i, 3 * i + 3), back, 2e-15);     // measured 3.3e-16
        }
        double[] none = matrix.values().clone();
        Arrays.fill(none, 9 * matrix.pattern().diagonal[3], 9 * matrix.pattern().diagonal[3] + 9, 1);
        assertFalse(inverse.prepare(matrix.pattern(), none));
    }
}
