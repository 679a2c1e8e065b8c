package particles.experiments.grid;

import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.experiments.runs.FollowedParticle;
import particles.law.Particles;

/**
 * Follows one coordinate of a particle: its range, and its turning points, which are found on the motion between two
 * steps. If a rule removes the particle, its last value is NaN; the rest is that of its life.
 */
final class ParticlePath implements Observer {
    /** The coordinates of a particle in the order of the state; the speed is the length of the velocity. */
    enum Coordinate {
        X("x", "m"), Y("y", "m"), Z("z", "m"), VX("vx", "m/s"), VY("vy", "m/s"), VZ("vz", "m/s"), SPEED("speed", "m/s");

        final String symbol;
        final String unit;

        Coordinate(String symbol, String unit) {
            this.symbol = symbol;
            this.unit = unit;
        }

        private double of(double[] state, int x) {
            return this != SPEED ? state[x + ordinal()] : Math.sqrt(state[x + 3] * state[x + 3]
                    + state[x + 4] * state[x + 4] + state[x + 5] * state[x + 5]);
        }
    }

    /** Bisections of a step that find a turning point to the digits of the clock. */
    private static final int HALVINGS = 52;

    private final Coordinate coordinate;
    private final String particle;
    private final FollowedParticle followed;
    private int index;                                  // -1 once the particle is gone
    private double last;
    private double least = Double.POSITIVE_INFINITY;
    private double most = Double.NEGATIVE_INFINITY;
    private double firstMaximum = Double.NaN;           // its time
    private double lastMaximum = Double.NaN;
    private int maxima;
    private double high = Double.NaN;                   // at the last maximum
    private double low = Double.NaN;                    // at the last minimum

    ParticlePath(Coordinate coordinate, String particle) {
        this.coordinate = coordinate;
        this.particle = particle;
        followed = new FollowedParticle(particle);
    }

    @Override
    public void started(ParticleSystem system) {
        index = followed.in(system.getParticles());
        if (index < 0) {
            throw new IllegalArgumentException("particle '" + particle + "' does not exist");
        }
        add(coordinate.of(system.getOwnState(), Particles.STRIDE * index));
    }

    @Override
    public void moved(Motion motion) {
        for (int k = 0; k < motion.getPieces() && index >= 0; k++) {
            Motion piece = motion.getPiece(k);
            if (coordinate.ordinal() < Coordinate.VX.ordinal()) {
                turn(piece, Particles.STRIDE * index + coordinate.ordinal());
            }
            add(coordinate.of(piece.getEndState(), Particles.STRIDE * index));
        }
    }

    @Override
    public void changed(ParticleSystem system, Rule rule) {
        if (index < 0) {
            return;
        }
        index = followed.in(system.getParticles());
        if (index < 0) {
            last = Double.NaN;
        } else {
            add(coordinate.of(system.getOwnState(), Particles.STRIDE * index));
        }
    }

    private void add(double value) {
        last = value;
        least = Math.min(least, value);
        most = Math.max(most, value);
    }

    /** Where the velocity changes its sign, the position has an extreme, which bisection finds. */
    private void turn(Motion piece, int c) {
        double v0 = piece.getStartState()[c + 3];
        double v1 = piece.getEndState()[c + 3];
        if (!(v0 * v1 < 0 || v1 == 0 && v0 != 0)) {
            return;
        }
        double before = piece.getStartTime();
        double time = piece.getEndTime();
        double[] state = new double[piece.getEndState().length];
        for (int halving = 0; halving < HALVINGS; halving++) {
            double middle = (before + time) / 2;
            piece.interpolate(middle, state);
            if (state[c + 3] * v0 > 0) {
                before = middle;
            } else {
                time = middle;
            }
        }
        piece.interpolate(time, state);
        add(state[c]);
        if (v0 > 0) {
            high = state[c];
            lastMaximum = time;
            firstMaximum = maxima++ == 0 ? time : firstMaximum;
        } else {
            low = state[c];
        }
    }

    double getLast() {
        return last;
    }

    double getLeast() {
        return least;
    }

    double getMost() {
        return most;
    }

    /** Half the distance from the last minimum to the last maximum; NaN before there are both. */
    double getAmplitude() {
        return (high - low) / 2;
    }

    /** The mean time from one maximum to the next (s); NaN before there are two. */
    double getPeriod() {
        return maxima < 2 ? Double.NaN : (lastMaximum - firstMaximum) / (maxima - 1);
    }
}
