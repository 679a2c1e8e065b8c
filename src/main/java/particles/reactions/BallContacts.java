package particles.reactions;

import java.util.Arrays;
import java.util.BitSet;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import particles.reactions.contact.ContactModes.Mode;

/**
 * The contacts of hard balls: rods between their centres that may only push, see the {@linkplain particles.reactions
 * theory}. The rule {@code particles.rules.Collisions} decides when they begin and end.
 */
public final class BallContacts {
    private final RigidConstraints constraints;
    private final ConstraintRows rows;

    BallContacts(RigidConstraints constraints, ConstraintRows rows) {
        this.constraints = constraints;
        this.rows = rows;
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

    /** @return the pairs that are in contact or joined by a rod, each in both orders */
    public Set<List<Integer>> findLinks() {
        Set<List<Integer>> links = new HashSet<>();
        for (int r = 0; r < end(); r++) {
            links.add(List.of(first(r), second(r)));
            links.add(List.of(second(r), first(r)));
        }
        return links;
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
        rows.evaluate(state);
        forEach(block -> constraints.getBlocks().correct(block, state, 0, Block.ALL));
        stop(state, false);
    }

    /**
     * Stops balls in contact that approach each other, all together and without a bounce.
     *
     * @param mayPart whether balls may separate; if not, they stop too
     */
    public void stop(double[] state, boolean mayPart) {
        forEach(block -> constraints.getBlocks().settle(block, state, mayPart, Block.ALL));
    }

    /** Calls something for each block in which balls touch. */
    private void forEach(Consumer<Block> action) {
        if (hasContacts()) {
            constraints.getJoined().stream()
                    .filter(block -> Arrays.stream(block.members).anyMatch(rows::isContact)).forEach(action);
        }
    }

    /**
     * @param force the total force of all effects (N)
     * @return the smallest force between two balls in contact (N); if some separate, minus their acceleration, but for
     *         round-off
     */
    public double leastPush(double[] state, double time, double[] force) {
        BlockForces blocks = constraints.getBlocks();
        double[] least = {Double.POSITIVE_INFINITY};
        blocks.prepare(state, time);
        forEach(block -> {
            blocks.solve(block, state, time, force);
            IntStream.range(0, block.size()).filter(block::isPair)
                    .forEach(r -> least[0] = Math.min(least[0], blocks.push(block, r, force)));
        });
        return least[0];
    }

    /** Ends all contacts of balls, and theirs with surfaces, that separate, but for round-off. */
    public void partWhereFree(double[] state, double time, double[] force) {
        BlockForces blocks = constraints.getBlocks();
        BitSet ending = new BitSet();
        blocks.prepare(state, time);
        forEach(block -> {
            blocks.solve(block, state, time, force);
            for (int r = 0; r < block.size(); r++) {
                boolean free = block.isContact(r) && blocks.push(block, r, force) < 0;
                if (free && block.isPair(r)) {
                    ending.set(block.member(r));
                } else if (free) {
                    int k = block.contact(r);
                    constraints.getModes().set(block.touching.surface[k], block.touching.particle[k], Mode.FREE);
                }
            }
        });
        for (int r = ending.length() - 1; r >= 0; r = ending.previousSetBit(r - 1)) {
            part(r);
        }
    }
}
