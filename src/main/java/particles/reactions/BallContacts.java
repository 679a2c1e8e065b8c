package particles.reactions;

import java.util.BitSet;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import particles.reactions.ContactModes.Mode;
import particles.reactions.Row.Kind;

/**
 * The contacts of hard balls: rods between their centres that may only push, see the {@linkplain particles.reactions
 * theory}. The rule {@code particles.rules.Collisions} decides when they begin and end.
 */
public final class BallContacts {
    private final Blocks blocks;
    private final BlockImpacts impacts;
    private final ContactModes modes;
    private final Rows rows;

    BallContacts(Blocks blocks, RestingContacts contacts) {
        this.blocks = blocks;
        impacts = contacts.getImpacts();
        modes = contacts.getModes();
        rows = blocks.getRows();
    }

    /** Adds a contact of two balls, whose centres are this far apart (m); its number is the next one. */
    public void touch(int i, int j, double distance) {
        rows.addLink(Kind.BALLS, i, j, distance);
    }

    /** @return the first ball of a contact */
    public int first(int contact) {
        return rows.get(contact).first;
    }

    /** @return its second ball */
    public int second(int contact) {
        return rows.get(contact).second;
    }

    /** Ends the contact with this number. */
    public void part(int contact) {
        rows.remove(contact);
    }

    /** @return the number of the first contact; later ones change theirs when one ends */
    public int begin() {
        return rows.begin(Kind.BALLS);
    }

    /** @return one more than the number of the last contact */
    public int end() {
        return rows.begin(Kind.WIRE);
    }

    /** @return whether any balls touch */
    public boolean hasContacts() {
        return end() > begin();
    }

    /** @return the pairs that are in contact or joined by a rod, each in both orders */
    public Set<List<Integer>> findLinks() {
        Set<List<Integer>> links = new HashSet<>();
        for (int r = end() - 1; r >= 0; r--) {
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
        impacts.strikePair(contact, leaving, friction, state);
    }

    /** Moves balls in contact, and all that is connected to them, by the small error of a step. */
    public void putTogether(double[] state) {
        forEach(block -> blocks.correct(block, state, 0, false, Block.ALL));
        stop(state, false);
    }

    /**
     * Stops balls in contact that approach each other, all together and without a bounce.
     *
     * @param mayPart whether balls may separate; if not, they stop too
     */
    public void stop(double[] state, boolean mayPart) {
        forEach(block -> blocks.correct(block, state, 3, mayPart, Block.ALL));
    }

    /** Calls something for each block in which balls touch. */
    private void forEach(Consumer<Block> action) {
        if (hasContacts()) {
            blocks.joined().stream().filter(Block::hasPairs).forEach(action);
        }
    }

    /**
     * @param force the total force of all effects (N)
     * @return the smallest force between two balls in contact (N); if some separate, minus their acceleration, but for
     *         round-off
     */
    public double leastPush(double[] state, double time, double[] force) {
        double[] least = {Double.POSITIVE_INFINITY};
        blocks.prepare(state, time);
        forEach(block -> {
            blocks.solve(block, state, time, force);
            for (Row row : block.rows) {
                least[0] = row.kind != Kind.BALLS ? least[0] : Math.min(least[0], blocks.push(block, row, force));
            }
        });
        return least[0];
    }

    /** Ends all contacts of balls, and theirs with surfaces, that separate, but for round-off. */
    public void partWhereFree(double[] state, double time, double[] force) {
        BitSet ending = new BitSet();
        blocks.prepare(state, time);
        forEach(block -> {
            blocks.solve(block, state, time, force);
            for (Row row : block.rows) {
                boolean free = row.isContact() && blocks.push(block, row, force) < 0;
                if (free && row.kind == Kind.BALLS) {
                    ending.set(row.number);
                } else if (free) {
                    modes.set(row.number, row.first, Mode.FREE);
                }
            }
        });
        for (int r = ending.length() - 1; r >= 0; r = ending.previousSetBit(r - 1)) {
            part(r);
        }
    }
}
