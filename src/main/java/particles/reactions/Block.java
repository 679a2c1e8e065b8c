package particles.reactions;

import deSolvers.linear.EnvelopeMatrix;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import particles.law.Particles;
import particles.reactions.Row.Kind;

/**
 * The data of a block: the particles connected by rods, wires and contacts of balls, or one particle without any, and
 * the linear system of their reaction forces. It has a row for each rod and each contact, and two for each particle on
 * a wire. Two balls in contact have the row of a rod that may only push. Column c of the matrix is the acceleration of
 * all rows if row c has a force of 1 N. The force of a sliding contact includes friction, -S<sup>T</sup> lambda, so the
 * matrix A = J W (J - S)<sup>T</sup> is not symmetric. It has entries only where two rows share a movable particle. A
 * held particle has no contacts, since it does not move at all. A single particle on one surface has the 1 x 1 matrix
 * 1.
 */
final class Block {
    /** No step, and no count of changes. */
    static final int NEVER = -1;

    final int[] members;                                // rows of rods, wires and balls, neighbours near each other
    final int[] particles;                              // that can move
    final boolean hasPairs;                             // whether some row is that of two balls in contact
    final double massRatio;                             // the largest by the smallest
    Row[] rows = {};
    BitSet held = new BitSet();                         // particles that do not move
    BitSet sticking = held;                             // as the modes were at a count of changes
    int stickingAt = NEVER;
    int gatheredAt = NEVER;                             // the modes' count of changes, if the rows are those of forces
    final EnvelopeMatrix matrix = new EnvelopeMatrix();
    boolean[] active = {};
    boolean[] first = {};                               // those that were active as the step began
    int firstAt = NEVER;                                // the number of that step
    double left;                                        // the residual of the last solution, relative to accelerations
    int solutions;                                      // so far: the last is at hand while the number is the same
    private final Particles system;

    /**
     * @param members   rows of the system
     * @param particles the particles that they move, in ascending order
     */
    Block(int[] members, int[] particles, List<Row> all, Particles system) {
        this.members = members;
        this.particles = particles;
        this.system = system;
        double[] weights = Arrays.stream(particles).mapToDouble(this::weight).sorted().toArray();
        massRatio = weights.length == 0 ? 1 : weights[weights.length - 1] / weights[0];
        hasPairs = Arrays.stream(members).anyMatch(r -> all.get(r).kind == Kind.BALLS);
    }

    boolean isJoined() {
        return members.length > 0;
    }

    /** W: 1/m, but 1 for a single particle, whose mass cancels, so that its rows are forces and not accelerations. */
    double weight(int i) {
        return isJoined() ? system.getInverseMasses()[i] : 1;
    }

    /** Adds the forces of all rows, with friction. */
    void addForces(double[] force) {
        for (Row row : rows) {
            row.addForce(force);
        }
    }
}
