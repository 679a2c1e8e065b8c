package deSolvers.implicit;

import deSolvers.JacobianBlocks;
import deSolvers.JacobianStateSource;
import java.util.function.Consumer;

/** A source of particles that only names its blocks. */
public class NamedBlocks implements JacobianStateSource {
    private final int particles;
    private final Consumer<JacobianBlocks> blocks;

    public NamedBlocks(int particles, Consumer<JacobianBlocks> blocks) {
        this.particles = particles;
        this.blocks = blocks;
    }

    /** Of four particles: alone, as pairs in both directions, and rows transformed before and after more is added. */
    public static void addOneOfEach(JacobianBlocks blocks, double[][] b) {
        blocks.add(1, 1, b[0], b[1]);
        blocks.addPair(0, 3, b[2], b[3]);
        blocks.add(0, 1, b[4], b[5]);
        blocks.addPair(2, 1, b[6], b[7]);
        blocks.transformRow(1, b[8]);
        blocks.addPair(3, 0, b[9], b[10]);
        blocks.add(3, 1, b[11], b[12]);
        blocks.transformRow(0, b[13]);
    }

    @Override
    public void addJacobianBlocks(JacobianBlocks receiver) {
        blocks.accept(receiver);
    }

    @Override
    public void getJacobianProduct(double[] direction, double[] product) {
        throw new UnsupportedOperationException();
    }

    @Override
    public int getStateSize() {
        return 6 * particles;
    }

    @Override
    public void getState(double[] state) {
        throw new UnsupportedOperationException();
    }

    @Override
    public void setState(double[] state) {
        throw new UnsupportedOperationException();
    }

    @Override
    public void getStateDerivative(double[] dSdt) {
        throw new UnsupportedOperationException();
    }

    @Override
    public double getTime() {
        return 0;
    }

    @Override
    public void incTime(double deltaT) {
        throw new UnsupportedOperationException();
    }
}
