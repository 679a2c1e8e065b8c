package deSolvers.implicit;

import deSolvers.JacobianBlocks;
import deSolvers.JacobianStateSource;
import java.util.function.Consumer;

/** A source of particles that only names its blocks. */
class NamedBlocks implements JacobianStateSource {
    private final int particles;
    private final Consumer<JacobianBlocks> blocks;

    NamedBlocks(int particles, Consumer<JacobianBlocks> blocks) {
        this.particles = particles;
        this.blocks = blocks;
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
