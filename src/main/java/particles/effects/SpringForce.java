package particles.effects;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Set;
import particles.Effect;
import particles.ForceDerivatives;
import particles.Particles;
import particles.SpringView;
import particles.Vector3;

/**
 * Damped springs between pairs of particles, the slides' "Damped Spring Force": on particle i, due to j,
 * <pre>
 *   r = x_j - x_i,   r' = v_j - v_i
 *   F_ij = [ k (|r| - l) + k_d (r . r') / |r| ] r / |r|,     F_ji = -F_ij
 * </pre>
 * k stiffness, l rest length, k_d damping. (The slide's r' is printed with a sign lost; it is the derivative of r.)
 *
 * <p>Two particles at the same place give no direction to push in: such a spring exerts no force at that instant. For
 * l = 0 that is the law's own limit; for l &gt; 0 it is the unstable balance of a spring compressed to a point.
 *
 * <p>Potential energy k (|r| - l)&sup2; / 2, dissipated power k_d (d|r|/dt)&sup2;. Source: COMPSCI 715 (2003), slides "Spring
 * Force" and "Damped Spring Force".
 */
public final class SpringForce implements Effect, SpringView {
    /** Between these bounds the square of a length neither overflows nor loses digits. */
    private static final double SMALLEST_SQUARE = 1e-280;
    private static final double LARGEST_SQUARE = 1e280;

    private final Particles particles;
    private int count;
    private int[] from = new int[8];                    // where the particles' entries begin in the state
    private int[] to = new int[8];
    private double[] stiffness = new double[8];
    private double[] restLength = new double[8];
    private double[] damping = new double[8];
    private boolean damped;
    private final SpringJacobian derivative = new SpringJacobian();

    /** @param particles whom the springs connect */
    public SpringForce(Particles particles) {
        this.particles = particles;
    }

    /**
     * Adds a spring.
     *
     * @param i          the index of the particle where it begins
     * @param j          the index of the particle where it ends, another one
     * @param stiffness  k (N/m), 0 or more
     * @param restLength l (m), 0 or more
     * @param damping    k_d (N s/m), 0 or more
     * @throws IllegalArgumentException if a number is out of its range, or i = j
     */
    public void addSpring(int i, int j, double stiffness, double restLength, double damping) {
        int n = particles.count();
        if (i < 0 || i >= n || j < 0 || j >= n) {
            throw new IllegalArgumentException("a spring between particles " + i + " and " + j + "; there are " + n);
        }
        if (i == j) {
            throw new IllegalArgumentException("a spring from particle '" + particles.id(i) + "' to itself");
        }
        require("stiffness", stiffness);
        require("rest length", restLength);
        require("damping", damping);
        if (count == from.length) {
            int capacity = count + count / 2;
            from = Arrays.copyOf(from, capacity);
            to = Arrays.copyOf(to, capacity);
            this.stiffness = Arrays.copyOf(this.stiffness, capacity);
            this.restLength = Arrays.copyOf(this.restLength, capacity);
            this.damping = Arrays.copyOf(this.damping, capacity);
        }
        from[count] = Particles.STRIDE * i;
        to[count] = Particles.STRIDE * j;
        this.stiffness[count] = stiffness;
        this.restLength[count] = restLength;
        this.damping[count] = damping;
        damped |= damping > 0;
        count++;
    }

    private static void require(String name, double value) {
        if (!(value >= 0) || !(value <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("a spring's " + name + " has to be 0 or more and finite, not " + value);
        }
    }

    @Override
    public String getName() {
        return "springs";
    }

    @Override
    public Set<Trait> getTraits() {
        return damped ? EnumSet.of(Trait.INTERNAL, Trait.TRANSLATION_INVARIANT, Trait.ROTATION_INVARIANT, Trait.DISSIPATIVE)
                : EnumSet.of(Trait.INTERNAL, Trait.TRANSLATION_INVARIANT, Trait.ROTATION_INVARIANT, Trait.CONSERVATIVE);
    }

    @Override
    public int size() {
        return count;
    }

    @Override
    public boolean dependsOnVelocity() {
        return damped;
    }

    @Override
    public void addForces(double[] state, double time, double[] force, int first, int end) {
        int[] from = this.from;
        int[] to = this.to;
        for (int s = first; s < end; s++) {
            int i = from[s];
            int j = to[s];
            double rx = state[j] - state[i];
            double ry = state[j + 1] - state[i + 1];
            double rz = state[j + 2] - state[i + 2];
            double square = rx * rx + ry * ry + rz * rz;
            if (!(square > SMALLEST_SQUARE && square < LARGEST_SQUARE)) {
                addExtremeForce(s, state, force);
                continue;
            }
            double inverse = 1 / Math.sqrt(square);
            double stretching = rx * (state[j + 3] - state[i + 3]) + ry * (state[j + 4] - state[i + 4])
                    + rz * (state[j + 5] - state[i + 5]);
            double perLength = stiffness[s] * (1 - restLength[s] * inverse) + damping[s] * stretching * inverse * inverse;
            double fx = perLength * rx;
            double fy = perLength * ry;
            double fz = perLength * rz;
            force[i + 3] += fx;
            force[i + 4] += fy;
            force[i + 5] += fz;
            force[j + 3] -= fx;
            force[j + 4] -= fy;
            force[j + 5] -= fz;
        }
    }

    @Override
    public boolean hasForceDerivatives() {
        return true;
    }

    @Override
    public void addForceDerivatives(double[] state, double time, ForceDerivatives derivatives) {
        for (int s = 0; s < count; s++) {
            derivative.add(state, from[s], to[s], stiffness[s], restLength[s], damping[s], derivatives);
        }
    }

    /** The same law for lengths whose square would overflow or underflow: the direction is found after scaling. */
    private void addExtremeForce(int s, double[] state, double[] force) {
        int i = from[s];
        int j = to[s];
        double largest = 0;
        for (int c = 0; c < 3; c++) {
            largest = Math.max(largest, Math.abs(state[j + c] - state[i + c]));
        }
        if (largest == 0) {
            return;                                     // no direction, no force
        }
        double scaledSquare = 0;
        for (int c = 0; c < 3; c++) {
            double scaled = (state[j + c] - state[i + c]) / largest;
            scaledSquare += scaled * scaled;
        }
        double scaledLength = Math.sqrt(scaledSquare);
        double rate = 0;
        for (int c = 0; c < 3; c++) {
            double direction = (state[j + c] - state[i + c]) / largest / scaledLength;
            rate += direction * (state[j + 3 + c] - state[i + 3 + c]);
        }
        double tension = stiffness[s] * (largest * scaledLength - restLength[s]) + damping[s] * rate;
        for (int c = 0; c < 3; c++) {
            double direction = (state[j + c] - state[i + c]) / largest / scaledLength;
            force[i + 3 + c] += tension * direction;
            force[j + 3 + c] -= tension * direction;
        }
    }

    @Override
    public double getPotentialEnergy(double[] state, double time) {
        double energy = 0;
        for (int s = 0; s < count; s++) {
            double stretch = length(state, s) - restLength[s];
            energy += stiffness[s] * stretch * stretch / 2;
        }
        return energy;
    }

    @Override
    public double getDissipatedPower(double[] state, double time) {
        double power = 0;
        for (int s = 0; damped && s < count; s++) {
            int i = from[s];
            int j = to[s];
            double length = length(state, s);
            if (length > 0) {
                double rate = 0;
                for (int c = 0; c < 3; c++) {
                    rate += (state[j + c] - state[i + c]) / length * (state[j + 3 + c] - state[i + 3 + c]);
                }
                power += damping[s] * rate * rate;
            }
        }
        return power;
    }

    /**
     * @param state the particles' state
     * @param s     a spring
     * @return its present length |r| (m)
     */
    public double length(double[] state, int s) {
        int i = from[s];
        int j = to[s];
        double rx = state[j] - state[i];
        double ry = state[j + 1] - state[i + 1];
        double rz = state[j + 2] - state[i + 2];
        double square = rx * rx + ry * ry + rz * rz;
        return square > SMALLEST_SQUARE && square < LARGEST_SQUARE ? Math.sqrt(square)
                : new Vector3(rx, ry, rz).length();
    }

    /** {@inheritDoc} Springs go with either of their ends. */
    @Override
    public void reindex(int[] newIndex) {
        int stay = 0;
        for (int s = 0; s < count; s++) {
            int i = newIndex[from(s)];
            int j = newIndex[to(s)];
            if (i >= 0 && j >= 0) {
                from[stay] = Particles.STRIDE * i;
                to[stay] = Particles.STRIDE * j;
                move(s, stay++);
            }
        }
        count = stay;
    }

    /**
     * Takes springs out. Those that stay keep their order.
     *
     * @param gone by index, true for springs to be taken out; as many as there are springs
     */
    public void removeSprings(boolean[] gone) {
        int stay = 0;
        for (int s = 0; s < count; s++) {
            if (!gone[s]) {
                from[stay] = from[s];
                to[stay] = to[s];
                move(s, stay++);
            }
        }
        count = stay;
    }

    private void move(int s, int stay) {
        stiffness[stay] = stiffness[s];
        restLength[stay] = restLength[s];
        damping[stay] = damping[s];
    }

    @Override
    public int springCount() {
        return count;
    }

    @Override
    public int from(int s) {
        return from[s] / Particles.STRIDE;
    }

    @Override
    public int to(int s) {
        return to[s] / Particles.STRIDE;
    }

    @Override
    public double restLength(int s) {
        return restLength[s];
    }

    @Override
    public double stiffness(int s) {
        return stiffness[s];
    }

    @Override
    public double damping(int s) {
        return damping[s];
    }
}
