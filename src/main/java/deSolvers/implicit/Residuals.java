package deSolvers.implicit;

import deSolvers.FiniteCheck;

/** What an equation leaves, entry by entry, beside what rounding makes of it. */
final class Residuals {

    private Residuals() {
    }

    static boolean areZero(double[] residual) {
        for (double value : residual) {
            if (value != 0) {
                return false;
            }
        }
        return true;
    }

    static boolean areFinite(double[] residual) {
        return FiniteCheck.firstNonFinite(residual) < 0;
    }

    /** Whether each is at most so many times its limit; false where one is no number. */
    static boolean areBelow(double[] residual, double[] limits, double factor) {
        for (int i = 0; i < residual.length; i++) {
            if (!(Math.abs(residual[i]) <= factor * limits[i])) {
                return false;
            }
        }
        return true;
    }

    /** Replaces by 0 what is at most so many times its limit. */
    static void drop(double[] residual, double[] limits, double factor) {
        for (int i = 0; i < residual.length; i++) {
            if (Math.abs(residual[i]) <= factor * limits[i]) {
                residual[i] = 0;
            }
        }
    }
}
