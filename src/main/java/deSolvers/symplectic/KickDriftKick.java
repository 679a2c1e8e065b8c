package deSolvers.symplectic;

import static deSolvers.symplectic.BlockLayout.kick;
import static deSolvers.symplectic.BlockLayout.kickDrift;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import deSolvers.GuardedStep;
import deSolvers.SecondOrderStateSource;
import deSolvers.StepMemory;
import java.util.Arrays;

/**
 * Methods whose step is made of one or more leapfrogs, each as long as its weight says: half a kick, a drift, half a kick. The
 * acceleration at the end of one is the acceleration at the beginning of the next, in the same step or the one after.
 */
abstract class KickDriftKick extends DESolver {
    private final double[] weightsBefore;               // all but the last
    private final double lastWeight;
    private final GuardedStep guard = new GuardedStep(this);
    private final StepMemory memory = new StepMemory();
    private final ClosingKick closingKick = new ClosingKick();
    private double[] state = {};
    private double[] dSdt = {};

    /** @param weights the parts of deltaT that the leapfrogs take; their sum is 1 */
    KickDriftKick(double... weights) {
        weightsBefore = Arrays.copyOf(weights, weights.length - 1);
        lastWeight = weights[weights.length - 1];
    }

    @Override
    public final void stepState(DEStateSource client, double deltaT) {
        int n = client.getStateSize();
        SecondOrderStateSource secondOrder = BlockLayout.of(this, client);
        int d = secondOrder.getDimension();
        boolean damped = secondOrder.accelerationDependsOnVelocity();
        if (state.length != n) {
            resize(n);
        }
        try (GuardedStep source = guard.begin(client, deltaT)) {
            double[] from = source.getStartState();
            if (!memory.takeUp(client, source.getStartTime(), from, deltaT, state)) {
                source.getStateDerivative(from, dSdt);  // at (x, v, t)
                source.requireFinite(dSdt);
            }
            if (weightsBefore.length > 0) {
                leapfrogsBefore(source, damped, from, n, d, deltaT);
                from = state;
            }
            leapfrog(source, damped, from, n, d, lastWeight * deltaT, deltaT);
            source.finish(state, dSdt);                 // copied in, so that ours is left to be remembered
            memory.keep(client, source.getEndTime(), deltaT);
        }
    }

    private void resize(int n) {
        state = new double[n];
        dSdt = new double[n];
        memory.forget();
    }

    /** All but the last, which stands by itself: a step of a single one needs no loop. */
    private void leapfrogsBefore(GuardedStep source, boolean damped, double[] start, int n, int d, double deltaT) {
        double[] from = start;
        double done = 0;
        for (double weight : weightsBefore) {
            double h = weight * deltaT;
            done += h;
            leapfrog(source, damped, from, n, d, h, done);
            source.requireFinite(dSdt);
            from = state;
        }
    }

    /**
     * From one state into ours, over h, to where the step has come at its end; the derivative moves along. Whether that is
     * finite has still to be looked at.
     *
     * @param damped whether the acceleration depends on the velocity
     */
    private void leapfrog(GuardedStep source, boolean damped, double[] from, int n, int d, double h, double end) {
        double[] state = this.state;
        double[] dSdt = this.dSdt;
        source.setOffset(end);
        if (damped) {
            closingKick.open(from, dSdt, n, d, h, state);
            closingKick.solve(source, state, dSdt, d, h / 2);
        } else {
            kickDrift(from, dSdt, n, d, h / 2, h, state);
            source.getStateDerivative(state, dSdt);     // at (x(t + h), t + h)
            kick(state, dSdt, n, d, h / 2);
        }
    }

    @Override
    public final void reset() {
        memory.forget();
    }
}
