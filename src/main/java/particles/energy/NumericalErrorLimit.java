package particles.energy;

import deSolvers.text.Digits;
import java.util.Comparator;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.SimulationException;
import particles.SimulationException.End;
import particles.law.Particles;
import particles.law.Vector3;

/**
 * Fails a run whose numerical error, as a gain of energy, became larger than its energy. It fails at the end if the
 * error was larger than the energy scale, and earlier once the error is {@value #MOST_GAIN} times all energy that is
 * not error. Between the two the run goes on, so that one can watch a step that is too long blow up, or Euler spiral
 * outwards.
 *
 * <p>Only a gain counts: solvers that damp lose energy, but no run can lose more than it has and receives. Energy from
 * wind, moving anchors or births belongs to the scale, since a solver with a small relative error has an absolute error
 * that grows as long as energy flows in. What the ledger cannot resolve does not count.
 */
public final class NumericalErrorLimit implements Observer {
    private static final int MOST_GAIN = 1000;
    private static final double ROUND_OFF = 1e-9;
    /** Kinetic energies below this part of the scene's estimated energy are round-off of a scene at rest. */
    private static final double AT_REST = 1e-12;

    private final EnergyHistory energy;
    private final EnergyLedgerRecorder books;
    private final double rounding;
    private double explained;
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
        rounding = AT_REST * energyScale;
    }

    @Override
    public void moved(Motion motion) {
        double error = books.getLatestNumericalError();
        if (!Double.isFinite(error)) {
            find(motion);
            fail(motion.getEndTime(), error);
        }
        error -= books.getUncertainty();
        largest = Math.max(largest, error);
        explained = Math.max(explained, energy.getLatest() - Math.max(0, error));
        double expected = Math.max(explained, energy.getRestScale());
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
            throw new SimulationException(End.WRONG_MOTION, passed, strongest, "the numerical error of "
                    + Digits.few(largest) + " J is larger than the energy scale"
                    + (putIn() > 0 ? " and the work put in" : "") + ", "
                    + Digits.few(energy.getScale() + putIn()) + " J");
        }
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

    /** After its first Euler step, all energy of a falling body is error; that does not count as above. */
    private boolean isAboveScale(double error) {
        double above = (1 + ROUND_OFF) * energy.getScale();
        return error > Math.max(rounding, above) && error > above + putIn();
    }

    /** All work that brought energy into the run (J). */
    private double putIn() {
        return books.getWork().values().stream().mapToDouble(work -> Math.max(0, work)).sum();
    }
}
