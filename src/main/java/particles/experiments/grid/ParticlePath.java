package particles.experiments.grid;

import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.experiments.runs.FollowedParticle;
import particles.law.Particles;

/**
 * Follows one coordinate of a particle: its range, and its turning points, which are found on the cubic between two
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

    private static final double MIDDLE = 0.5;

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

    /** Where the velocity changes its sign in a piece, its cubic has an extreme. */
    private void turn(Motion piece, int c) {
        double v0 = piece.getStartState()[c + 3];
        double v1 = piece.getEndState()[c + 3];
        if (!(v0 * v1 < 0 || v1 == 0 && v0 != 0)) {
            return;
        }
        double h = piece.getEndTime() - piece.getStartTime();
        double x0 = piece.getStartState()[c];
        double way = piece.getEndState()[c] - x0;
        // the velocity on the cubic is v0 + b u + a u^2; it has one root in [0, 1], but for round-off
        double b = 6 * way / h - 4 * v0 - 2 * v1;
        double a = 3 * (v0 + v1) - 6 * way / h;
        double q = -0.5 * (b + Math.copySign(Math.sqrt(Math.max(0, b * b - 4 * a * v0)), b));
        double one = v0 / q;
        double other = q / a;                           // not finite if a is 0
        double root = Math.abs(other - MIDDLE) < Math.abs(one - MIDDLE) ? other : one;
        double u = v1 == 0 ? 1 : Math.max(0, Math.min(1, root));
        double extreme = x0 + h * u * (v0 + u * (b / 2 + u * a / 3));
        add(extreme);
        if (v0 > 0) {
            high = extreme;
            lastMaximum = piece.getStartTime() + u * h;
            firstMaximum = maxima++ == 0 ? lastMaximum : firstMaximum;
        } else {
            low = extreme;
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
