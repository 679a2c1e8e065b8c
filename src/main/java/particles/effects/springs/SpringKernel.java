package particles.effects.springs;

/**
 * The inner loops of the spring force, for springs sorted by their first particle. The law is explained in {@link
 * SpringForce}; a cloth simulation spends most of its time here.
 */
final class SpringKernel {
    /**
     * Squares of lengths from this bit pattern on have full precision; ORDINARY is how many patterns follow before
     * overflow.
     */
    private static final long SMALLEST = Double.doubleToRawLongBits(1e-280);
    private static final long ORDINARY = Double.doubleToRawLongBits(1e280) - SMALLEST;

    private SpringKernel() {
    }

    /** Adds the forces of the springs first ... end - 1. */
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

    /** Spring by spring: faster if a particle begins one or two springs, as in a chain. */
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
     * Particle by particle, with the first particle's data in registers for all of its springs: faster for cloth. It is
     * a single loop because nested loops of a handful of springs each do not get fast.
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
     * Whether the square of a length neither overflows nor loses digits. Bit patterns are ordered like the numbers,
     * with NaN last, so one comparison is enough.
     */
    static boolean isOrdinary(double square) {
        return Long.compareUnsigned(Double.doubleToRawLongBits(square) - SMALLEST, ORDINARY) < 0;
    }

    /** The same law for lengths with squares that overflow or underflow; r is scaled first. */
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
