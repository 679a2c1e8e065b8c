package deSolvers.linear;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;

import deSolvers.JacobianBlocks;
import deSolvers.implicit.BlockByBlock;
import deSolvers.implicit.NamedBlocks;
import java.util.Arrays;
import java.util.Random;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/** K = dF/dx and C = dF/dv beside full matrices, into which everything is written where it belongs. */
class ForceBlocksTest {
    private static final int ROWS = 4;
    private static final double[] MASSES = {2, 0.5, 0, 3};      // the third particle is held

    private final Random random = new Random(31);
    private final ImplicitWork.Counter work = new ImplicitWork.Counter();
    private final ForceBlocks forces = new ForceBlocks(work);

    /** What is named, with all that is not 0 in its place. */
    private static final class Full extends BlockByBlock {
        final double[][] k = new double[3 * ROWS][3 * ROWS];
        final double[][] c = new double[3 * ROWS][3 * ROWS];

        @Override
        public void put(int i, int j, double[] dFdX, double[] dFdV, double sign) {
            for (int e = 0; e < 9; e++) {
                k[3 * i + e / 3][3 * j + e % 3] += sign * dFdX[e];
                c[3 * i + e / 3][3 * j + e % 3] += sign * dFdV[e];
            }
        }

        @Override
        public void transformRow(int i, double[] m) {
            for (double[][] matrix : new double[][][] {k, c}) {
                double[][] rows = {matrix[3 * i].clone(), matrix[3 * i + 1].clone(), matrix[3 * i + 2].clone()};
                for (int e = 0; e < 9 * ROWS; e++) {
                    int a = e / (3 * ROWS);
                    int column = e % (3 * ROWS);
                    matrix[3 * i + a][column] = m[3 * a] * rows[0][column] + m[3 * a + 1] * rows[1][column]
                            + m[3 * a + 2] * rows[2][column];
                }
            }
        }

        /** Holds the third particle. */
        Full hold() {
            for (int r = 6; r < 9; r++) {
                Arrays.fill(k[r], 0);
                Arrays.fill(c[r], 0);
            }
            return this;
        }
    }

    private double[] random(int n) {
        return random.doubles(n, -1, 1).toArray();
    }

    private Full collect(Consumer<JacobianBlocks> blocks) {
        forces.collect(new NamedBlocks(ROWS, blocks) {
            @Override
            public double getInverseMass(int i) {
                return MASSES[i] == 0 ? 0 : 1 / MASSES[i];
            }
        }, ROWS);
        Full full = new Full();
        blocks.accept(full);
        assertForces(full.hold());
        for (double g : new double[] {0.25, -2}) {
            assertCombined(full, g);
        }
        return full;
    }

    private void assertForces(Full full) {
        double[] x = random(3 * ROWS);
        double[] v = random(3 * ROWS);
        double[] force = new double[3 * ROWS];
        double[] expected = new double[3 * ROWS];
        for (int e = 0; e < 9 * ROWS * ROWS; e++) {
            int r = e / (3 * ROWS);
            int s = e % (3 * ROWS);
            expected[r] += full.k[r][s] * x[s] + full.c[r][s] * v[s];
        }
        long before = work.blockOperations;
        forces.apply(x, v, force);
        assertEquals(2 * forces.pattern().blocks(), work.blockOperations - before);
        assertArrayEquals(expected, force, 5e-15);                      // measured 8.9e-16
    }

    /** M - g C - g^2 K block by block, and how much stiffer the stiffest particle is than inert. */
    private void assertCombined(Full full, double g) {
        BlockPattern pattern = forces.pattern();
        double[] values = new double[9 * pattern.blocks()];
        double condition = forces.combine(g, values);
        double stiffest = 1;
        for (int i = 0; i < ROWS; i++) {
            double mass = MASSES[i] == 0 ? 1 : MASSES[i];
            assertEquals(mass, forces.mass(i), 1e-15);
            double trace = 0;
            for (int s = pattern.rowStart[i]; s < pattern.rowStart[i + 1]; s++) {
                int j = pattern.column[s];
                for (int e = 0; e < 9; e++) {
                    double entry = (i == j && e % 4 == 0 ? mass : 0) - g * full.c[3 * i + e / 3][3 * j + e % 3]
                            - g * g * full.k[3 * i + e / 3][3 * j + e % 3];
                    assertEquals(entry, values[9 * s + e], 5e-15);      // measured 8.9e-16
                    trace += i == j && e % 4 == 0 ? Math.abs(entry) : 0;
                }
            }
            stiffest = Math.max(stiffest, trace / 3 / mass);
        }
        assertEquals(stiffest, condition, 1e-14 * stiffest);
    }

    @Test
    void everyBlockHasItsPlace() {
        for (int n = 1; n <= 10; n++) {
            double[][] b = new double[14][];
            Arrays.setAll(b, e -> random(9));
            collect(blocks -> NamedBlocks.addOneOfEach(blocks, b));
            assertEquals(n, work.jacobians);
        }
        assertEquals(12, forces.pattern().blocks());       // 4 on the diagonal; 03, 12, 01 and 13 with their mirrors
    }

    /** Another set of pairs makes another pattern; what acts on one particle alone does not. */
    @Test
    void pairsMayComeAndGo() {
        double[] b = random(9);
        double[] c = random(9);
        collect(blocks -> blocks.addPair(0, 1, b, c));
        BlockPattern first = forces.pattern();
        collect(blocks -> {
            blocks.addPair(0, 1, c, b);
            blocks.add(3, 3, c, b);
        });
        assertSame(first, forces.pattern());
        collect(blocks -> {
            blocks.addPair(0, 1, b, c);
            blocks.addPair(1, 3, c, b);
            blocks.transformRow(3, b);
        });
        assertNotSame(first, forces.pattern());
        collect(blocks -> blocks.add(1, 3, c, b));
        collect(blocks -> {
            blocks.add(3, 3, c, b);
            blocks.transformRow(3, b);
        });
        assertEquals(ROWS, forces.pattern().blocks());
    }
}
