package particles.reactions;

import java.util.Arrays;
import java.util.BitSet;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.ObjDoubleConsumer;
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
    private final Set<List<Integer>> parted = new HashSet<>();  // in this step, as nothing pushed them together

    BallContacts(ApplyPhase apply) {
        this.apply = apply;
        solve = apply.solve;
        contacts = solve.contacts;
        rows = contacts.rows;
    }

    /** Begins a step. */
    public void beginStep() {
        parted.clear();
        rows.forEach(row -> row.latched = false);
    }

    /**
     * Adds a contact of two balls, whose centres are this far apart (m). If they had parted in this step as nothing
     * pushed them together, they stay together until its end: it could go on for ever.
     */
    public void touch(int i, int j, double distance, Bounce bounce) {
        Row row = contacts.addLink(Kind.BALLS, i, j, distance);
        row.bounce = bounce;
        row.latched = parted.contains(List.of(i, j));
    }

    private int begin() {
        return contacts.begin(Kind.BALLS);
    }

    private int end() {
        return contacts.begin(Kind.WIRE);
    }

    /** @return the number of contacts */
    public int count() {
        return end() - begin();
    }

    /** @return whether any balls touch */
    public boolean hasContacts() {
        return count() > 0;
    }

    /** @return the pairs that are in contact or joined by a rod, each in both orders */
    public Set<List<Integer>> findLinks() {
        Set<List<Integer>> links = new HashSet<>();
        for (Row row : rows.subList(0, end())) {
            links.add(List.of(row.first, row.second));
            links.add(List.of(row.second, row.first));
        }
        return links;
    }

    private static double separation(Row row, double[] state) {
        row.evaluate(state);
        return row.rate;
    }

    /** @return whether any balls in contact approach or separate faster than some speed (m/s) */
    public boolean isAnyMoving(double[] state, double slow) {
        return rows.subList(begin(), end()).stream().anyMatch(row -> Math.abs(separation(row, state)) > slow);
    }

    /**
     * Ends the contacts of balls that separate.
     *
     * @param rounding the speed that is round-off (m/s)
     * @param slow     the speed below which those stay in contact that did not bounce in the last impact (m/s)
     * @return the balls
     */
    public BitSet partWhereFast(double[] state, double rounding, double slow) {
        BitSet apart = new BitSet();
        for (int r = end() - 1; r >= begin(); r--) {
            Row row = rows.get(r);
            if (separation(row, state) > (row.bounced ? rounding : slow)) {
                apart.set(row.first);
                apart.set(row.second);
                contacts.removeRow(r);
            }
            row.bounced = false;
        }
        return apart;
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

    /** Shows the push of each contact in blocks in which balls touch, see {@link SolvePhase#push}. */
    private void forEachPush(double[] state, double time, double[] force, ObjDoubleConsumer<Row> action) {
        solve.evaluate.prepare(state, time);
        forEach(block -> {
            solve.solveForces(block, state, time, force);
            Arrays.stream(block.rows).filter(Row::isContact)
                    .forEach(row -> action.accept(row, solve.push(block, row, force)));
        });
    }

    private boolean mayPart(Row row) {
        return row.kind == Kind.BALLS && !rows.get(row.number).latched;
    }

    /**
     * @param force the total force of all effects (N)
     * @return the smallest force between two balls in contact (N); if some separate, minus their acceleration, but for
     *         round-off
     */
    public double leastPush(double[] state, double time, double[] force) {
        double[] least = {Double.POSITIVE_INFINITY};
        forEachPush(state, time, force, (row, push) -> least[0] = mayPart(row) ? Math.min(least[0], push) : least[0]);
        return least[0];
    }

    /**
     * Ends all contacts of balls, and theirs with surfaces, that separate, but for round-off.
     *
     * @param most the largest push of a contact of balls that ends (N); less than 0 for those that separate only
     */
    public void partWhereFree(double[] state, double time, double[] force, double most) {
        BitSet ending = new BitSet();
        forEachPush(state, time, force, (row, push) -> {
            if (row.kind == Kind.BALLS) {
                ending.set(row.number, mayPart(row) && push <= Math.max(most, -Double.MIN_VALUE));
            } else if (push < 0) {
                contacts.getModes().set(row.number, row.first, Mode.FREE);
            }
        });
        for (int r = ending.length() - 1; r >= 0; r = ending.previousSetBit(r - 1)) {
            parted.add(List.of(rows.get(r).first, rows.get(r).second));
            contacts.removeRow(r);
        }
    }
}
