package particles.reactions;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import particles.reactions.ContactModes.Mode;
import particles.reactions.ContactSurface.Bounce;
import particles.reactions.Row.Kind;

/**
 * The contacts of hard balls: rods between their centres that may only push, see the {@linkplain particles.reactions
 * theory}. The rule {@code particles.rules.Collisions} decides when they begin and end.
 */
public final class BallContacts {
    private final SolvePhase solve;
    private final ApplyPhase apply;
    private final Contacts contacts;
    private final List<Row> rows;

    BallContacts(ApplyPhase apply) {
        this.apply = apply;
        solve = apply.solve;
        contacts = solve.contacts;
        rows = contacts.rows;
    }

    /** Adds a contact of two balls, whose centres are this far apart (m); its number is the next one. */
    public void touch(int i, int j, double distance, Bounce bounce) {
        contacts.addLink(Kind.BALLS, i, j, distance).bounce = bounce;
    }

    /** @return the first ball of a contact */
    public int first(int contact) {
        return rows.get(contact).first;
    }

    /** @return its second ball */
    public int second(int contact) {
        return rows.get(contact).second;
    }

    /** Lets the contact that was added last not end before {@link #unlatch}, though its force may be 0. */
    public void latch() {
        rows.get(end() - 1).latched = true;
    }

    /** Lets contacts end again. */
    public void unlatch() {
        rows.forEach(row -> row.latched = false);
    }

    /** Forgets which contacts had a bounce. */
    public void forgetBounces() {
        rows.forEach(row -> row.bounced = false);
    }

    /** @return whether a contact had a bounce in the last impact */
    public boolean hasBounced(int contact) {
        return rows.get(contact).bounced;
    }

    /** Ends the contact with this number. */
    public void part(int contact) {
        contacts.removeRow(contact);
    }

    /** @return the number of the first contact; later ones change theirs when one ends */
    public int begin() {
        return contacts.begin(Kind.BALLS);
    }

    /** @return one more than the number of the last contact */
    public int end() {
        return contacts.begin(Kind.WIRE);
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

    /** Moves balls in contact, and all that is connected to them, by the small error of a step. */
    public void putTogether(double[] state) {
        forEach(block -> apply.correct(block, state, 0, false, true));
        stop(state, false);
    }

    /**
     * Stops balls in contact that approach each other, all together and without a bounce.
     *
     * @param mayPart whether balls may separate; if not, they stop too
     */
    public void stop(double[] state, boolean mayPart) {
        forEach(block -> apply.correct(block, state, 3, mayPart, true));
    }

    /** Calls something for each block in which balls touch. */
    private void forEach(Consumer<Block> action) {
        if (hasContacts()) {
            solve.gather.joined().stream().filter(block -> block.hasPairs).forEach(action);
        }
    }

    /**
     * @param force the total force of all effects (N)
     * @return the smallest force between two balls in contact (N); if some separate, minus their acceleration, but for
     *         round-off
     */
    public double leastPush(double[] state, double time, double[] force) {
        double[] least = {Double.POSITIVE_INFINITY};
        solve.evaluate.prepare(state, time);
        forEach(block -> {
            solve.solveForces(block, state, time, force);
            for (Row row : block.rows) {
                if (row.kind == Kind.BALLS && !rows.get(row.number).latched) {
                    least[0] = Math.min(least[0], solve.push(block, row, force));
                }
            }
        });
        return least[0];
    }

    /**
     * Ends all contacts of balls, and theirs with surfaces, that separate, but for round-off.
     *
     * @param most the largest push of a contact of balls that ends (N); less than 0 for those that separate only
     * @return the pairs of balls that were in contact
     */
    public List<List<Integer>> partWhereFree(double[] state, double time, double[] force, double most) {
        BitSet ending = new BitSet();
        solve.evaluate.prepare(state, time);
        forEach(block -> {
            solve.solveForces(block, state, time, force);
            for (Row row : block.rows) {
                double push = row.isContact() ? solve.push(block, row, force) : 0;
                if (row.kind == Kind.BALLS) {
                    ending.set(row.number, push <= Math.max(most, -Double.MIN_VALUE) && !rows.get(row.number).latched);
                } else if (push < 0) {
                    contacts.getModes().set(row.number, row.first, Mode.FREE);
                }
            }
        });
        List<List<Integer>> parted = new ArrayList<>();
        for (int r = ending.length() - 1; r >= 0; r = ending.previousSetBit(r - 1)) {
            parted.add(List.of(first(r), second(r)));
            part(r);
        }
        return parted;
    }
}
