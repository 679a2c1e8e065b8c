package particles.effects.springs;

import particles.law.Vector3;

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
        double[] stiffness = table.stiffness;
        double[] restLength = table.restLength;
        double[] damping = table.damping;
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
            double perLength = perLength(stiffness[s], restLength[s], damping[s], rx, ry, rz,
                    state[j + 3] - state[i + 3], state[j + 4] - state[i + 4], state[j + 5] - state[i + 5]);
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
        double[] stiffness = table.stiffness;
        double[] restLength = table.restLength;
        double[] damping = table.damping;
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
            double perLength = perLength(stiffness[s], restLength[s], damping[s], rx, ry, rz,
                    state[j + 3] - state[i + 3], state[j + 4] - state[i + 4], state[j + 5] - state[i + 5]);
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

    /** The law: the force on the first particle, divided by |r|; (ux, uy, uz) is r'. */
    private static double perLength(double stiffness, double restLength, double damping, double rx, double ry,
            double rz, double ux, double uy, double uz) {
        double square = Math.fma(rx, rx, Math.fma(ry, ry, rz * rz));
        if (!isOrdinary(square)) {
            return extreme(stiffness, restLength, damping, new Vector3(rx, ry, rz), new Vector3(ux, uy, uz));
        }
        double length = Math.sqrt(square);
        double inverse = 1 / length;
        double stretching = Math.fma(rx, ux, Math.fma(ry, uy, rz * uz));
        return Math.fma(damping * stretching, inverse, stiffness * (length - restLength)) * inverse;
    }

    /** The same where |r|&sup2; overflows or loses digits; 0 where r is 0 or too short to divide by. */
    private static double extreme(double stiffness, double restLength, double damping, Vector3 r, Vector3 u) {
        double length = r.length();
        return length < NO_LENGTH ? 0
                : (stiffness * (length - restLength) + damping * r.over(length).dot(u)) / length;
    }
}
