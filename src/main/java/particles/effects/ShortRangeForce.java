package particles.effects;

import deSolvers.TimeScaleSource;
import java.util.Arrays;
import particles.effects.neighbours.NeighbourLists;
import particles.law.Particles;
import particles.law.Passage;

/**
 * Base class of pair forces with a reach: each particle is a ball, and two act on each other where their balls overlap.
 * Neighbours come from {@link NeighbourLists}.
 */
abstract class ShortRangeForce extends PairForce {
    /**
     * By how much balls are enlarged in the middle of a sub-step, to find those that touch within it. A sub-step is
     * planned as a quarter of the shortest time: with the speeds of its beginning, no ball moves relative to another by
     * more than the smallest radius, and so by half of it before the middle and after. Balls that are much faster at
     * the end of a sub-step than at its beginning may touch unseen.
     */
    private static final double WIDER = 1 + TimeScaleSource.PART;

    final NeighbourLists lists;
    private final NeighbourLists wideLists = new NeighbourLists(false);
    private final Reach reach = new Reach();
    private final double radius;
    private double largest;
    double[] radii = {};
    private double[] wide = {};
    private double[] middle = {};

    /** The overlap of two balls. */
    private static final class Reach extends Passage {
        private double touching;

        @Override
        protected double depth(double[] s) {
            return touching - Math.sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
        }

        @Override
        protected double sinking(double[] s) {
            return -(s[0] * s[3] + s[1] * s[4] + s[2] * s[5]);
        }
    }

    /**
     * @param particles    the particles on which it acts
     * @param damped       whether it loses energy
     * @param betweenFixed whether two fixed particles are neighbours
     * @param radius       the radius of each particle without one of its own (m), positive
     */
    ShortRangeForce(Particles particles, boolean damped, boolean betweenFixed, double radius) {
        super(particles, damped);
        lists = new NeighbourLists(betweenFixed);
        this.radius = radius;
        largest = radius;
    }

    /** Gives a particle a radius of its own (m). */
    final void put(int particle, double own) {
        fit(Math.max(particle + 1, radii.length));
        radii[particle] = own;
        largest = Math.max(largest, own);
        forget();
    }

    private void forget() {
        lists.forget();
        wideLists.forget();
    }

    private void fit(int count) {
        int before = radii.length;
        if (before < count) {
            radii = Arrays.copyOf(radii, count + count / 3);
            Arrays.fill(radii, before, radii.length, radius);
        }
    }

    @Override
    void findNeighbours(double[] state) {
        fit(particles.count());
        lists.update(state, particles, radii, largest);
        near = lists.getNear();
    }

    @Override
    final int end(int i) {
        return lists.end(i);
    }

    @Override
    public final double getShortestTime(double[] state, double time) {
        fit(particles.count());
        double least = radius;
        for (int i = 0; i < particles.count(); i++) {
            least = Math.min(least, radii[i]);
        }
        return 4 * least / largestSpeed(state);
    }

    /** The largest relative speed that the velocities allow (m/s): the diagonal of the box that holds them. */
    private double largestSpeed(double[] state) {
        double square = 0;
        for (int c = 3; c < STRIDE; c++) {
            double least = Double.POSITIVE_INFINITY;
            double most = Double.NEGATIVE_INFINITY;
            for (int v = c; v < STRIDE * particles.count(); v += STRIDE) {
                least = Math.min(least, state[v]);
                most = Math.max(most, state[v]);
            }
            square += particles.count() < 2 ? 0 : (most - least) * (most - least);
        }
        return Math.sqrt(square);
    }

    @Override
    public final double findPassage(double[] from, double[] to, double duration) {
        fit(particles.count());
        if (middle.length != from.length) {
            middle = new double[from.length];
        }
        for (int x = 0; x < from.length; x += STRIDE) {
            for (int c = x; c < x + 3; c++) {
                middle[c] = (from[c] + to[c]) / 2 + duration / 8 * (from[c + 3] - to[c + 3]);
            }
        }
        if (wide.length != radii.length) {
            wide = new double[radii.length];
        }
        for (int i = 0; i < wide.length; i++) {
            wide[i] = WIDER * radii[i];
        }
        wideLists.update(middle, particles, wide, WIDER * largest);
        double first = Double.POSITIVE_INFINITY;
        for (int i = 0; i < particles.count(); i++) {
            for (int k = wideLists.first(i, false); k < wideLists.end(i); k++) {
                int j = wideLists.getNear()[k];
                reach.touching = radii[i] + radii[j];
                first = Math.min(first, reach.find(from, to, i, j, duration));
            }
        }
        return first;
    }

    @Override
    public final void reindex(int[] newIndex) {
        fit(newIndex.length);
        int left = 0;
        for (int i = 0; i < newIndex.length; i++) {
            if (newIndex[i] >= 0) {
                radii[newIndex[i]] = radii[i];
                left++;
            }
        }
        Arrays.fill(radii, left, radii.length, radius);
        forget();
    }
}
