package particles.experiments.stability;

import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import particles.experiments.stability.Spectrum.Mode;

/**
 * Predicts the longest stable step of a solver from a spectrum: the longest step at which no mode grows that would not
 * grow by itself. It is the smallest limit of all modes, each measured on the solver's real code in the direction of
 * its lambda in the complex plane. Each mode is treated as a separate spring. That is exact for Runge-Kutta and
 * implicit methods, and for symplectic ones if the damping matrix has the modes of the stiffness matrix.
 */
final class SpectrumLimit {
    /** Modes whose directions in the plane agree to this share a limit. */
    private static final double SAME_DIRECTION = 1e-7;

    private final Amplification amplification;
    private final List<Mode> modes;
    private final Map<List<Long>, Double> known = new HashMap<>();

    /**
     * @param amplification the amplification of the solver
     * @param spectrum      the spectrum of the system
     */
    SpectrumLimit(Amplification amplification, Spectrum spectrum) {
        this.amplification = amplification;
        modes = spectrum.decaying();
    }

    /** @return the longest step (s); 0 if some mode grows at any, infinite if none does */
    double deltaT() {
        return deltaT(deciding());
    }

    private double deltaT(Mode mode) {
        return limit(mode) / mode.size();
    }

    /** @return the mode that sets {@link #deltaT}, or the fastest, if none does */
    Mode deciding() {
        return modes.stream().min(Comparator.comparingDouble(this::deltaT)).orElseThrow();
    }

    /** @return the mode that grows most in a step of this length */
    Mode growingMost(double deltaT) {
        return modes.stream().max(Comparator.comparingDouble(mode -> factor(mode, deltaT))).orElseThrow();
    }

    /** @return the factor by which a step of this length multiplies a mode */
    double factor(Mode mode, double deltaT) {
        // else its partner grows by itself
        boolean overdamped = amplification.ofSprings() && mode.im() == 0 && mode.stiffness() > 0;
        return overdamped ? amplification.ofSpring(deltaT * deltaT * mode.stiffness(), deltaT * mode.damping())
                : amplification.at(deltaT * mode.re(), deltaT * mode.im());
    }

    /** The limit of h |lambda| in this mode's direction. */
    private double limit(Mode mode) {
        List<Long> direction = List.of(Math.round(mode.re() / mode.size() / SAME_DIRECTION),
                mode.im() == 0 && amplification.ofSprings()
                        ? Math.round(mode.damping() / mode.size() / SAME_DIRECTION) : -1);
        return known.computeIfAbsent(direction, unknown ->
                StabilityLimit.measure(h -> factor(mode, h / mode.size())).value());
    }
}
