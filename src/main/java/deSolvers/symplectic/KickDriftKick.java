package deSolvers.symplectic;

import static deSolvers.symplectic.BlockLayout.kick;
import static deSolvers.symplectic.BlockLayout.kickDrift;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import deSolvers.GuardedStep;
import deSolvers.SecondOrderStateSource;
import deSolvers.StepMemory;

/**
 * A step made of one or more leapfrogs, each as long as its weight says: half a kick, a drift, half a kick. The
 * acceleration at the end of one is the acceleration at the beginning of the next, in the same step or the one after.
 */
final class KickDriftKick {
    private final BlockLayout layout;
    private final double[] weights;
    private final GuardedStep guard;
    private final StepMemory memory = new StepMemory();
    private final ClosingKick closingKick = new ClosingKick();
    private double[] state = {};
    private double[] dSdt = {};

    /**
     * @param solver  whose steps these are
     * @param weights the parts of deltaT that the leapfrogs take; their sum is 1
     */
    KickDriftKick(DESolver solver, double... weights) {
        layout = new BlockLayout(solver);
        this.guard = new GuardedStep(solver);
        this.weights = weights;
    }

    void step(DEStateSource client, double deltaT) {
        SecondOrderStateSource secondOrder = layout.of(client);
        int n = client.getStateSize();
        if (state.length != n) {
            resize(n);
        }
        try (GuardedStep source = guard.begin(client, deltaT)) {
            double[] from = source.getStartState();
            boolean continues = memory.holds(client, source.getStartTime(), from, deltaT);
            memory.forget();                            // until this step has ended well
            if (!continues) {
                source.getStateDerivative(from, dSdt);  // at (x, v, t)
                source.requireFinite(dSdt);
            }
            int last = weights.length - 1;
            if (last > 0) {
                leapfrogsBefore(last, source, secondOrder, from, n, deltaT);
                from = state;
            }
            leapfrog(source, secondOrder, from, n, weights[last] * deltaT, deltaT);
            source.finish(state);                       // copied in, so that ours is left to be remembered
            memory.keep(client, source.getEndTime(), state, deltaT);
        }
    }

    private void resize(int n) {
        state = new double[n];
        dSdt = new double[n];
        memory.forget();
    }

    /** All but the last, which stands by itself: a step of a single one needs no loop. */
    private void leapfrogsBefore(int last, GuardedStep source, SecondOrderStateSource secondOrder, double[] start, int n,
            double deltaT) {
        double[] from = start;
        double done = 0;
        for (int k = 0; k < last; k++) {
            double h = weights[k] * deltaT;
            done += h;
            leapfrog(source, secondOrder, from, n, h, done);
            from = state;
        }
    }

    /** From one state into ours, over h, to where the step has come at its end; the derivative moves along. */
    private void leapfrog(GuardedStep source, SecondOrderStateSource secondOrder, double[] from, int n, double h, double end) {
        double[] state = this.state;
        double[] dSdt = this.dSdt;
        int d = secondOrder.getDimension();
        source.setOffset(end);
        if (secondOrder.accelerationDependsOnVelocity()) {
            closingKick.open(from, dSdt, n, d, h, state);
            closingKick.solve(source, state, dSdt, d, h / 2);
        } else {
            kickDrift(from, dSdt, from, n, d, h / 2, h, state);
            source.getStateDerivative(state, dSdt);     // at (x(t + h), t + h)
            source.requireFinite(dSdt);
            kick(state, dSdt, n, d, h / 2);
        }
    }

    void reset() {
        memory.forget();
    }
}
