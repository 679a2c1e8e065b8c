package particles.effects.springs;

/**
 * The inner loops of the spring force, for springs sorted by the particle where they begin. The law is that of
 * {@link SpringForce}; these loops are where a simulation of cloth spends its time.
 */
final class SpringKernel {
    /**
     * The bits of the square of a length from which on it does not lose digits, and how many follow before it
     * overflows.
     */
    private static final long SMALLEST = Double.doubleToRawLongBits(1e-280);
    private static final long ORDINARY = Double.doubleToRawLongBits(1e280) - SMALLEST;

    private SpringKernel() {
    }

    /** Adds the forces of the springs first ... end - 1, if there are any. */
    static void addForces(SpringTable table, double[] state, double[] force, int first, int end) {
        if (first >= end) {
            return;
        }
        if (table.isGrouped()) {
            addGrouped(table, state, force, first, end);
        } else {
            addSingly(table, state, force, first, end);
        }
    }

    /** Spring by spring: best where a particle owns one or two, as in a chain. */
    private static void addSingly(SpringTable table, double[] state, double[] force, int first, int end) {
        int[] from = table.from;
        int[] to = table.to;
        double[] stiffness = table.stiffness;
        double[] restLength = table.restLength;
        double[] damping = table.damping;
        for (int s = first; s < end; s++) {
            int i = from[s];
            int j = to[s];
            double rx = state[j] - state[i];
            double ry = state[j + 1] - state[i + 1];
            double rz = state[j + 2] - state[i + 2];
            double square = Math.fma(rx, rx, Math.fma(ry, ry, rz * rz));
            if (!isOrdinary(square)) {
                addExtremeForce(table, s, state, force);
                continue;
            }
            double length = Math.sqrt(square);
            double stretching = Math.fma(rx, state[j + 3] - state[i + 3],
                    Math.fma(ry, state[j + 4] - state[i + 4], rz * (state[j + 5] - state[i + 5])));
            double inverse = 1 / length;
            double perLength = Math.fma(damping[s] * stretching, inverse,
                    stiffness[s] * (length - restLength[s])) * inverse;
            force[i + 3] = Math.fma(perLength, rx, force[i + 3]);
            force[i + 4] = Math.fma(perLength, ry, force[i + 4]);
            force[i + 5] = Math.fma(perLength, rz, force[i + 5]);
            force[j + 3] = Math.fma(-perLength, rx, force[j + 3]);
            force[j + 4] = Math.fma(-perLength, ry, force[j + 4]);
            force[j + 5] = Math.fma(-perLength, rz, force[j + 5]);
        }
    }

    /**
     * Particle by particle, keeping what belongs to the first one in registers for all of its springs: best in cloth.
     * One loop over all springs, since one within it would be over after a handful each time, before it gets fast.
     */
    private static void addGrouped(SpringTable table, double[] state, double[] force, int first, int end) {
        int[] from = table.from;
        int[] to = table.to;
        double[] stiffness = table.stiffness;
        double[] restLength = table.restLength;
        double[] damping = table.damping;
        int i = from[first];
        double x = state[i];
        double y = state[i + 1];
        double z = state[i + 2];
        double vx = state[i + 3];
        double vy = state[i + 4];
        double vz = state[i + 5];
        double sumX = 0;
        double sumY = 0;
        double sumZ = 0;
        for (int s = first; s < end; s++) {
            int next = from[s];
            if (next != i) {
                force[i + 3] += sumX;
                force[i + 4] += sumY;
                force[i + 5] += sumZ;
                i = next;
                x = state[i];
                y = state[i + 1];
                z = state[i + 2];
                vx = state[i + 3];
                vy = state[i + 4];
                vz = state[i + 5];
                sumX = 0;
                sumY = 0;
                sumZ = 0;
            }
            int j = to[s];
            double rx = state[j] - x;
            double ry = state[j + 1] - y;
            double rz = state[j + 2] - z;
            double square = Math.fma(rx, rx, Math.fma(ry, ry, rz * rz));
            if (isOrdinary(square)) {
                double length = Math.sqrt(square);
                double stretching = Math.fma(rx, state[j + 3] - vx,
                        Math.fma(ry, state[j + 4] - vy, rz * (state[j + 5] - vz)));
                double inverse = 1 / length;
                double perLength = Math.fma(damping[s] * stretching, inverse,
                        stiffness[s] * (length - restLength[s])) * inverse;
                sumX = Math.fma(perLength, rx, sumX);
                sumY = Math.fma(perLength, ry, sumY);
                sumZ = Math.fma(perLength, rz, sumZ);
                force[j + 3] = Math.fma(-perLength, rx, force[j + 3]);
                force[j + 4] = Math.fma(-perLength, ry, force[j + 4]);
                force[j + 5] = Math.fma(-perLength, rz, force[j + 5]);
            } else {
                addExtremeForce(table, s, state, force);
            }
        }
        force[i + 3] += sumX;
        force[i + 4] += sumY;
        force[i + 5] += sumZ;
    }

    /**
     * Whether the square of a length neither overflows nor loses digits: by the bits, whose order is that of the
     * numbers and ends with NaN, in one comparison.
     */
    static boolean isOrdinary(double square) {
        return Long.compareUnsigned(Double.doubleToRawLongBits(square) - SMALLEST, ORDINARY) < 0;
    }

    /** The same law for lengths whose square would overflow or underflow: the direction is found after scaling. */
    private static void addExtremeForce(SpringTable table, int s, double[] state, double[] force) {
        int i = table.from[s];
        int j = table.to[s];
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
        double tension = table.stiffness[s] * (largest * scaledLength - table.restLength[s]) + table.damping[s] * rate;
        for (int c = 0; c < 3; c++) {
            double direction = (state[j + c] - state[i + c]) / largest / scaledLength;
            force[i + 3 + c] += tension * direction;
            force[j + 3 + c] -= tension * direction;
        }
    }
}
