package deSolvers.adaptive;

import deSolvers.StepTransaction;

/**
 * Guesses the length of the first sub-step from the first two derivatives of the solution (Hairer, N&oslash;rsett,
 * Wanner, section II.4); a trial Euler step shows how fast the derivative changes.
 */
final class FirstSubStep {
    private FirstSubStep() {
    }

    /**
     * @param source   the step's source; left at the trial
     * @param exponent e if a sub-step's error is O(h<sup>e</sup>)
     * @param state    the state at the beginning
     * @param slope    the derivative there
     * @param deltaT   the whole step (s)
     * @param trial    work space
     * @param change   work space
     * @return a length, &gt; 0 and at most that of deltaT (s)
     */
    static double guess(StepTransaction source, Tolerance tolerance, int exponent, double[] state, double[] slope,
            double deltaT,
                        double[] trial, double[] change) {
        double length = Math.abs(deltaT);
        double size = tolerance.size(state, state);
        double speed = tolerance.size(slope, state);
        // A hundredth of the time in which the state would change by its own size; unknown for a state of about 0.
        double slow = size > 1 && speed > 0 ? 0.01 * (size / speed) : Double.POSITIVE_INFINITY;
        double euler = Math.min(length, slow);
        if (slow == Double.POSITIVE_INFINITY && speed > 1 / length) {
            euler = 1 / speed;                          // as far as the tolerance reaches
        }
        if (!(euler >= Double.MIN_NORMAL)) {
            return length;                              // too short for a trial
        }
        double h = Math.copySign(euler, deltaT);
        for (int i = 0; i < state.length; i++) {
            trial[i] = state[i] + h * slope[i];
        }
        source.setState(trial);
        source.setOffset(h);
        source.getStateDerivative(change);              // at (s + h f, t + h)
        for (int i = 0; i < state.length; i++) {
            change[i] = (change[i] - slope[i]) / euler;
        }
        double fastest = Math.max(speed, tolerance.size(change, state));
        double byChange = fastest > 0 ? AdaptiveSolver.root(0.01 / fastest, exponent) : length;
        double guess = Math.min(length, Math.min(100 * slow, byChange));
        return guess > 0 ? guess : euler;               // also if the trial gave NaN
    }
}
