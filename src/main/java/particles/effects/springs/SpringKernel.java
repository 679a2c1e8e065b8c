package particles.effects.springs;

/**
 * The inner loops of the spring force, for springs sorted by their first particle. The law is explained in {@link
 * SpringForce}; a cloth simulation spends most of its time here.
 */
final class SpringKernel {
    /** The force divided by a shorter length may overflow (m). */
    private static final double NO_LENGTH = 1e-290;
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

    /**
     * Spring by spring: faster if a particle begins one or two springs. In a chain each spring begins where the one
     * before it ended: that particle's position and force stay in registers, and its force is stored once.
     */
    private static void addSingly(SpringTable table, double[] state, double[] force, int first, int end) {
        int[] from = table.from;
        int[] to = table.to;
        int i = from[first];
        double x = state[i];
        double y = state[i + 1];
        double z = state[i + 2];
        double fx = force[i + 3];
        double fy = force[i + 4];
        double fz = force[i + 5];
        for (int s = first; s < end; s++) {
            int next = from[s];
            if (next != i) {
                force[i + 3] = fx;
                force[i + 4] = fy;
                force[i + 5] = fz;
                i = next;
                x = state[i];
                y = state[i + 1];
                z = state[i + 2];
                fx = force[i + 3];
                fy = force[i + 4];
                fz = force[i + 5];
            }
            int j = to[s];
            double xj = state[j];
            double yj = state[j + 1];
            double zj = state[j + 2];
            double rx = xj - x;
            double ry = yj - y;
            double rz = zj - z;
            double perLength = perLength(table, s, state, rx, ry, rz);
            force[i + 3] = Math.fma(perLength, rx, fx);
            force[i + 4] = Math.fma(perLength, ry, fy);
            force[i + 5] = Math.fma(perLength, rz, fz);
            fx = Math.fma(-perLength, rx, force[j + 3]);
            fy = Math.fma(-perLength, ry, force[j + 4]);
            fz = Math.fma(-perLength, rz, force[j + 5]);
            i = j;
            x = xj;
            y = yj;
            z = zj;
        }
        force[i + 3] = fx;
        force[i + 4] = fy;
        force[i + 5] = fz;
    }

    /**
     * Particle by particle, with the first particle's position and force in registers for all of its springs: faster
     * for cloth. (There are not enough registers for its velocity too.) It is a single loop because nested loops of a
     * handful of springs each do not get fast.
     */
    private static void addGrouped(SpringTable table, double[] state, double[] force, int first, int end) {
        int[] from = table.from;
        int[] to = table.to;
        int i = from[first];
        double x = state[i];
        double y = state[i + 1];
        double z = state[i + 2];
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
                sumX = 0;
                sumY = 0;
                sumZ = 0;
            }
            int j = to[s];
            double rx = state[j] - x;
            double ry = state[j + 1] - y;
            double rz = state[j + 2] - z;
            double perLength = perLength(table, s, state, rx, ry, rz);
            sumX = Math.fma(perLength, rx, sumX);
            sumY = Math.fma(perLength, ry, sumY);
            sumZ = Math.fma(perLength, rz, sumZ);
            force[j + 3] = Math.fma(-perLength, rx, force[j + 3]);
            force[j + 4] = Math.fma(-perLength, ry, force[j + 4]);
            force[j + 5] = Math.fma(-perLength, rz, force[j + 5]);
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

    /** The force on the first particle of a spring, divided by |r|; 0 where r is 0 or too short to divide by. */
    private static double perLength(SpringTable table, int s, double[] state, double rx, double ry, double rz) {
        double square = Math.fma(rx, rx, Math.fma(ry, ry, rz * rz));
        if (!isOrdinary(square)) {
            double length = table.length(state, s);
            return length < NO_LENGTH ? 0 : (table.stiffness[s] * (length - table.restLength[s])
                    + table.damping[s] * table.lengthRate(state, s)) / length;
        }
        int v = table.from[s] + 3;
        int w = table.to[s] + 3;
        double length = Math.sqrt(square);
        double stretching = Math.fma(rx, state[w] - state[v],
                Math.fma(ry, state[w + 1] - state[v + 1], rz * (state[w + 2] - state[v + 2])));
        double inverse = 1 / length;
        return Math.fma(table.damping[s] * stretching, inverse,
                table.stiffness[s] * (length - table.restLength[s])) * inverse;
    }
}
