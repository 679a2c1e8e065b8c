package particles.energy;

import deSolvers.text.Digits;
import java.util.Comparator;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.SimulationException;
import particles.SimulationException.End;
import particles.law.Particles;
import particles.law.Vector3;

/**
 * Fails a run whose numerical error, as a gain of energy, became larger than its energy. It fails at the end if the
 * error was larger than all energy, or {@value #WRONG_GAIN} times the energy that is not error, and earlier once it is
 * {@value #MOST_GAIN} times that energy. Until then the run goes on, so that one can watch a step that is too long blow
 * up, or Euler spiral outwards.
 *
 * <p>Only a gain counts: solvers that damp lose energy, but no run can lose more than it has and receives. Energy from
 * wind, moving anchors or births belongs to the scale, since a solver with a small relative error has an absolute error
 * that grows as long as energy flows in. What the ledger cannot resolve does not count.
 */
public final class NumericalErrorLimit implements Observer {
    private static final int MOST_GAIN = 1000;
    private static final int WRONG_GAIN = 10;
    private static final double ROUND_OFF = 1e-9;
    /** Kinetic energies below this part of the scene's estimated energy are round-off of a scene at rest. */
    private static final double AT_REST = 1e-12;

    private final EnergyHistory energy;
    private final EnergyLedgerRecorder books;
    private final double estimate;
    private final double rounding;
    private double explained;
    private double mostInternal = Double.NEGATIVE_INFINITY;     // kinetic plus stored, without the error
    private double largest;
    private double passed = Double.NaN;
    private int strongest;

    /**
     * @param energy      the run's energies; an observer that is called before this one
     * @param books       the run's ledger; an observer that is called before this one
     * @param energyScale the scene's estimated energy (J)
     */
    public NumericalErrorLimit(EnergyHistory energy, EnergyLedgerRecorder books, double energyScale) {
        this.energy = energy;
        this.books = books;
        estimate = energyScale;
        rounding = AT_REST * energyScale;
    }

    @Override
    public void started(ParticleSystem system) {
        mostInternal = energy.getInternal();
    }

    @Override
    public void changed(ParticleSystem system, Rule rule) {
        noteInternal();
    }

    private void noteInternal() {
        double error = books.getLatestNumericalError() - books.getUncertainty();
        mostInternal = Math.max(mostInternal, energy.getInternal() - Math.max(0, error));
    }

    /** The energy scale of what was given to the system: without the energy that is numerical error (J). */
    double getScale() {
        return energy.scaleOf(mostInternal, estimate);
    }

    @Override
    public void moved(Motion motion) {
        noteInternal();
        double error = books.getLatestNumericalError();
        if (!Double.isFinite(error)) {
            find(motion);
            fail(motion.getEndTime(), error);
        }
        error -= books.getUncertainty();
        largest = Math.max(largest, error);
        explained = Math.max(explained, energy.getLatest() - Math.max(0, error));
        double expected = expected();
        if (error > Math.max(rounding, MOST_GAIN * expected) && error > MOST_GAIN * (expected + putIn())) {
            find(motion);
            throw new SimulationException(End.NUMERICAL_ERROR, motion.getEndTime(), strongest,
                    "the numerical error is " + Digits.few(error) + " J, over " + MOST_GAIN
                    + " times the rest of the energy");
        }
        if (Double.isNaN(passed) && isAboveScale(error)) {
            passed = motion.getEndTime();
            find(motion);
        }
    }

    @Override
    public void finished(ParticleSystem system) {
        if (!Double.isFinite(books.getLatestNumericalError())) {
            fail(system.getTime(), books.getLatestNumericalError());
        }
        if (isAboveScale(largest)) {
            boolean aboveAll = isAboveAll(largest);
            double scale = (aboveAll ? getScale() : expected()) + putIn();
            throw new SimulationException(End.WRONG_MOTION, passed, strongest, "the numerical error of "
                    + Digits.few(largest) + " J is " + (aboveAll ? "" : "over " + WRONG_GAIN + " times ")
                    + (aboveAll ? "larger than the energy scale" : "the rest of the energy")
                    + (putIn() > 0 ? " and the work put in" : "") + ", " + Digits.few(scale) + " J");
        }
    }

    private double expected() {
        return Math.max(explained, energy.getRestScale());
    }

    /** Notes the particle with the largest kinetic energy, or one whose energy is not a number. */
    private void find(Motion motion) {
        Particles particles = motion.getSystem().getParticles();
        strongest = particles.free().boxed()
                .max(Comparator.comparingDouble(i -> {
                    Vector3 v = Vector3.at(motion.getEndState(), Particles.STRIDE * i + 3);
                    return particles.mass(i) * v.dot(v);
                })).orElse(0);
    }

    private void fail(double time, double error) {
        throw new SimulationException(End.NUMERICAL_ERROR, time, strongest, "the numerical error of its energy is "
                + Digits.few(error) + (Double.isNaN(error) ? "" : " J"));
    }

    private boolean isAboveScale(double error) {
        return isAboveAll(error) || error > rounding && error > WRONG_GAIN * (expected() + putIn());
    }

    /** After its first Euler step, all energy of a falling body is error; that does not count as above. */
    private boolean isAboveAll(double error) {
        double above = (1 + ROUND_OFF) * energy.getScale();
        return error > Math.max(rounding, above) && error > above + putIn();
    }

    /** All work that brought energy into the run (J). */
    private double putIn() {
        return books.getWork().values().stream().mapToDouble(work -> Math.max(0, work)).sum();
    }
}
