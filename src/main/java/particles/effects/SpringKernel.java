package particles.effects;

/**
 * The inner loops of the spring force, for springs sorted by the particle where they begin. The law is that of
 * {@link SpringForce}; these loops are where a simulation of cloth spends its time.
 */
final class SpringKernel {
    /** Between these bounds the square of a length neither overflows nor loses digits. */
    static final double SMALLEST_SQUARE = 1e-280;
    static final double LARGEST_SQUARE = 1e280;

    private SpringKernel() {
    }

    /** Adds the forces of the springs first ... end - 1. */
    static void addForces(SpringTable table, double[] state, double[] force, int first, int end) {
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
            if (!(square > SMALLEST_SQUARE && square < LARGEST_SQUARE)) {
                addExtremeForce(table, s, state, force);
                continue;
            }
            double length = Math.sqrt(square);
            double stretching = Math.fma(rx, state[j + 3] - state[i + 3],
                    Math.fma(ry, state[j + 4] - state[i + 4], rz * (state[j + 5] - state[i + 5])));
            double inverse = 1 / length;
            double perLength = Math.fma(damping[s] * stretching, inverse, stiffness[s] * (length - restLength[s])) * inverse;
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

    /** Particle by particle, keeping what belongs to the first one in registers for all of its springs: best in cloth. */
    private static void addGrouped(SpringTable table, double[] state, double[] force, int first, int end) {
        int[] from = table.from;
        int[] to = table.to;
        double[] stiffness = table.stiffness;
        double[] restLength = table.restLength;
        double[] damping = table.damping;
        int[] groupEnds = table.groupEnds;
        int s = first;
        for (int group = table.groupOf(first); s < end; group++) {
            int last = Math.min(groupEnds[group], end);
            int i = from[s];
            double x = state[i];
            double y = state[i + 1];
            double z = state[i + 2];
            double vx = state[i + 3];
            double vy = state[i + 4];
            double vz = state[i + 5];
            double sumX = 0;
            double sumY = 0;
            double sumZ = 0;
            for (; s < last; s++) {
                int j = to[s];
                double rx = state[j] - x;
                double ry = state[j + 1] - y;
                double rz = state[j + 2] - z;
                double square = Math.fma(rx, rx, Math.fma(ry, ry, rz * rz));
                if (square > SMALLEST_SQUARE && square < LARGEST_SQUARE) {
                    double length = Math.sqrt(square);
                    double stretching = Math.fma(rx, state[j + 3] - vx,
                            Math.fma(ry, state[j + 4] - vy, rz * (state[j + 5] - vz)));
                    double inverse = 1 / length;
                    double perLength = Math.fma(damping[s] * stretching, inverse,
                            stiffness[s] * (length - restLength[s])) * inverse;
                    double fx = perLength * rx;
                    double fy = perLength * ry;
                    double fz = perLength * rz;
                    sumX += fx;
                    sumY += fy;
                    sumZ += fz;
                    force[j + 3] -= fx;
                    force[j + 4] -= fy;
                    force[j + 5] -= fz;
                } else {
                    addExtremeForce(table, s, state, force);
                }
            }
            force[i + 3] += sumX;
            force[i + 4] += sumY;
            force[i + 5] += sumZ;
        }
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
