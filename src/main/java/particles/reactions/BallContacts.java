package particles.reactions;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import particles.reactions.contact.ContactModes.Mode;

/**
 * The contacts of hard balls: rods between their centres that may only push, see the {@linkplain particles.reactions
 * theory}. The rule {@code particles.rules.Collisions} decides when they begin and end.
 */
public final class BallContacts {
    /** Relative to the largest force of a block. */
    private static final double NO_FORCE = 1e-12;

    private final RigidConstraints constraints;
    private final ConstraintRows rows;

    BallContacts(RigidConstraints constraints, ConstraintRows rows) {
        this.constraints = constraints;
        this.rows = rows;
    }

    /** Whether a row pushes, by more than round-off. */
    static boolean pushes(Block block, int row) {
        double largest = 0;
        for (int r = 0; r < block.size(); r++) {
            largest = Math.max(largest, Math.abs(block.force(r)));
        }
        return block.force(row) > NO_FORCE * largest;
    }

    /** Adds a contact of two balls, whose centres are this far apart (m); its number is the next one. */
    public void touch(int i, int j, double distance) {
        rows.addContact(i, j, distance);
        constraints.noteChange();
    }

    /** @return the first ball of a contact */
    public int first(int contact) {
        return rows.first(contact);
    }

    /** @return its second ball */
    public int second(int contact) {
        return rows.second(contact);
    }

    /** Ends the contact with this number. */
    public void part(int contact) {
        rows.removeContact(contact);
        constraints.noteChange();
    }

    /** @return the number of the first contact; later ones change theirs when one ends */
    public int begin() {
        return rows.getRods();
    }

    /** @return one more than the number of the last contact */
    public int end() {
        return rows.getBeadRows();
    }

    /** @return whether any balls touch */
    public boolean hasContacts() {
        return end() > begin();
    }

    /** @return whether two balls are in contact, or a rod keeps their distance */
    public boolean areLinked(int i, int j) {
        for (int r = 0; r < end(); r++) {
            if (rows.first(r) == i && rows.second(r) == j || rows.first(r) == j && rows.second(r) == i) {
                return true;
            }
        }
        return false;
    }

    /** @return the speed at which the two balls of a contact separate (m/s) */
    public double separation(int contact, double[] state) {
        rows.evaluate(state);
        return rows.rate[contact];
    }

    /**
     * Applies an impact of the two balls of a contact: rods, wires and touched surfaces transmit the impulse, other
     * contacts of balls do not.
     *
     * @param leaving  the speed with which they separate (m/s)
     * @param friction the largest impulse of friction, as a multiple of the normal impulse
     * @param state    the state, in which velocities are changed
     */
    public void strike(int contact, double leaving, double friction, double[] state) {
        int i = rows.first(contact);
        Block block = constraints.block(i).or(() -> constraints.block(rows.second(contact))).orElseThrow();
        constraints.getBlocks().impacts().strikePair(block, contact, leaving, friction, state);
    }

    /** Moves balls in contact, and all that is connected to them, by the small error of a step. */
    public void putTogether(double[] state) {
        for (Block block : withContacts()) {
            rows.evaluate(state);
            constraints.getBlocks().correct(block, state, 0, false);
            constraints.getBlocks().settle(block, state, true, Block.ALL);
        }
    }

    /**
     * Stops balls in contact that approach each other, all together and without a bounce.
     *
     * @param mayPart whether balls may separate; if not, they stop too
     */
    public void stop(double[] state, boolean mayPart) {
        for (Block block : withContacts()) {
            constraints.getBlocks().settle(block, state, mayPart, Block.ALL);
        }
    }

    private List<Block> withContacts() {
        return !hasContacts() ? List.of() : constraints.getJoined().stream()
                .filter(block -> Arrays.stream(block.getMembers()).anyMatch(rows::isContact)).toList();
    }

    /**
     * @param force the total force of all effects (N)
     * @return the smallest force between two balls in contact (N), negative if they would have to pull
     */
    public double leastPush(double[] state, double time, double[] force) {
        double least = Double.POSITIVE_INFINITY;
        for (Block block : withContacts()) {
            constraints.getBlocks().prepare(state, time);
            constraints.getBlocks().solve(block, state, time, force);
            for (int r = 0; r < block.size(); r++) {
                least = block.isPair(r) ? Math.min(least, push(block, r)) : least;
            }
        }
        return least;
    }

    private static double push(Block block, int r) {
        return block.force(r) != 0 ? block.force(r) : -block.separation(r);
    }

    /** Ends all contacts of balls, and theirs with surfaces, that do not push but for round-off, if none may pull. */
    public void partWhereFree(double[] state, double time, double[] force) {
        BitSet ending = new BitSet();
        for (Block block : withContacts()) {
            constraints.getBlocks().prepare(state, time);
            constraints.getBlocks().solveOpening(block, state, time, force);
            for (int r = 0; r < block.size(); r++) {
                boolean free = !block.isIdle(r) && !pushes(block, r);
                if (free && block.isPair(r)) {
                    ending.set(block.member(r));
                } else if (free && !block.isMember(r)) {
                    int k = block.contact(r);
                    constraints.getModes().set(block.touching.surface[k], block.touching.particle[k], Mode.FREE);
                }
            }
        }
        for (int r = ending.length() - 1; r >= 0; r = ending.previousSetBit(r - 1)) {
            part(r);
        }
    }
}
