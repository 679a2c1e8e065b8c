package particles.reactions;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import particles.SimulationException;
import particles.law.Particles;
import particles.law.Scales.Skin;
import particles.law.Vector3;
import particles.reactions.ContactModes.Mode;
import particles.reactions.Row.Kind;

/**
 * Impacts at one moment, of particles with surfaces and with each other: all contacts that approach are answered
 * together. With N v &lt; 0 in their rows, the impulses lambda &ge; 0 make N v' &ge; -r N v, with equality where lambda
 * &gt; 0. So the part of v that leads into the contacts, measured by the masses, is turned back by 1 + r. Contacts that
 * approach after that, as the next ball of a row does, are answered in the next round, until none approaches. Momentum,
 * for r = 1 energy, and the symmetry of the set-up are kept, and no order of contacts matters. (B. Smith and others,
 * "Reflections on simultaneous impact", 2012.)
 */
public final class BlockImpacts {
    private static final int STRIDE = Particles.STRIDE;
    /** After this number of rounds, and two for each row, nothing bounces any more; with r = 0.5, 20 leave 1e-6. */
    private static final int MOST_ROUNDS = 100;
    /** The largest number of iterations for friction; one is enough for particles with one contact each. */
    private static final int MOST_ITERATIONS = 200;

    private static final BitSet NOBODY = new BitSet();

    private final Contacts contacts;
    private final ContactModes modes;
    private final GatherPhase gather;
    private final EvaluatePhase evaluate;
    private final SolvePhase solve;
    private final ApplyPhase apply;

    /**
     * A particle that meets a surface.
     *
     * @param surface  the surface's index
     * @param particle the particle's index
     * @param leaving  the speed with which it leaves, if nothing else happens at that moment (m/s)
     * @param pull     a velocity whose component into another surface brings the particle back to it in time (m/s)
     */
    public record Meeting(int surface, int particle, double leaving, Vector3 pull) {
    }

    BlockImpacts(ApplyPhase apply) {
        this.apply = apply;
        solve = apply.solve;
        contacts = solve.contacts;
        modes = contacts.getModes();
        gather = solve.gather;
        evaluate = solve.evaluate;
    }

    /**
     * Whether a surface can push a particle away. It cannot where rods and wires keep the particle from moving across
     * the surface, as at the bottom of a wire that touches the ground there: the wire then carries the particle, and
     * the surface exerts no force.
     *
     * @param surface  the surface's index
     * @param particle the particle's index
     * @param state    the state, with the particle on the surface
     * @return true for every particle that is not coupled
     */
    public boolean canPush(int surface, int particle, double[] state) {
        Block block = gather.of(particle);
        if (!block.isJoined()) {
            return true;
        }
        gather(block, List.of(new Meeting(surface, particle, 0, Vector3.ZERO)), false);
        evaluate.evaluate(block, state);
        Row struck = Row.find(block.rows, Kind.SURFACE, surface, particle).orElseThrow();
        for (Row row : block.rows) {
            row.right = row == struck ? 1 : 0;
        }
        return solve.solve(block, row -> row != struck, true) && Math.abs(struck.separation) < Tolerances.NO_SOLUTION;
    }

    /**
     * Answers all impacts at this moment. Rods, wires and surfaces that were touched before transmit impulses; what is
     * lifted off loses contact, and what sticks slides from now on.
     *
     * @param meetings the particles that meet surfaces
     * @param state    the state, in which velocities are changed
     */
    public void answer(List<Meeting> meetings, double[] state) {
        Map<Block, List<Meeting>> concerned = new LinkedHashMap<>();
        gather.joined().stream().filter(block -> block.hasPairs)
                .forEach(block -> concerned.put(block, new ArrayList<>()));
        meetings.forEach(meeting -> concerned.computeIfAbsent(gather.of(meeting.particle), block -> new ArrayList<>())
                .add(meeting));
        concerned.forEach((block, some) -> answer(block, some, state));
    }

    private void answer(Block block, List<Meeting> meetings, double[] state) {
        gather(block, meetings, true);
        evaluate.evaluate(block, state);
        double fast = 0;
        for (int i : block.particles) {
            fast = Math.max(fast, Vector3.at(state, STRIDE * i + 3).norm1());
        }
        for (Row row : block.rows) {
            fast = Math.max(fast, Math.abs(row.rate));
        }
        Row[] all = block.rows;
        int most = MOST_ROUNDS + 2 * all.length;
        for (int round = 0; meets(all, fast) && round <= most; round++) {
            for (Row row : all) {
                row.hasMet |= row.meets;
                row.meets |= round == most && row.hasMet;
                double leaving = !row.meets || round == most ? 0
                        : round > 0 ? row.bounce.leaving(-row.rate) : leaving(row, meetings);
                row.right = row.isIdle() ? 0 : leaving - row.rate;
                row.stops = row.meets && leaving == 0;
                if (row.kind == Kind.BALLS && leaving > 0) {
                    contacts.rows.get(row.number).bounced = true;
                }
            }
            gather.keep(block, Arrays.stream(all).filter(row -> !row.isContact() || row.meets || touches(row)));
            strike(block, fast, state);
            rub(block, fast, state);
            gather.keep(block, Arrays.stream(all));
            evaluate.evaluate(block, state);
        }
        for (Row row : block.rows) {
            if (touches(row) && row.rate > Math.max(Tolerances.ROUNDING * fast, Math.max(row.bounce.restSpeed(),
                    inwards(row, meetings)))) {
                modes.set(row.number, row.first, Mode.FREE);
            }
        }
    }

    private void gather(Block block, List<Meeting> meetings, boolean balls) {
        gather.gather(block, NOBODY, balls, (surface, i) -> modes.get(surface, i) != Mode.FREE
                || meetings.stream().anyMatch(meeting -> meeting.surface == surface && meeting.particle == i));
    }

    /**
     * Moves a particle out of surfaces that it is below, by the shortest way.
     *
     * @param under the surfaces' indices
     * @param state the state, in which its position is changed
     */
    public void lift(int particle, BitSet under, double[] state) {
        Block block = gather.alone(particle);
        gather.gather(block, NOBODY, false, (surface, i) -> under.get(surface));
        for (int k = 0; k < MOST_ITERATIONS && (k == 0 || block.rows.length > 1 && isBelow(block, state)); k++) {
            apply.correct(block, state, 0, true);
        }
    }

    private static boolean isBelow(Block block, double[] state) {
        double near = Tolerances.ROUNDING * (1 + Vector3.at(state, STRIDE * block.particles[0]).norm1());
        return Arrays.stream(block.rows).anyMatch(row -> row.surface.distance(state, row.first) < -near);
    }

    /**
     * Marks the contacts that approach; returns whether there are any. What is left of an approach that was stopped is
     * an error of dependent rows.
     */
    private static boolean meets(Row[] rows, double fast) {
        boolean any = false;
        for (Row row : rows) {
            double slow = row.stops ? Tolerances.NO_SOLUTION : Tolerances.ROUNDING;
            row.meets = row.isContact() && !row.isIdle() && row.rate < -slow * fast;
            any |= row.meets;
        }
        return any;
    }

    private boolean touches(Row row) {
        return row.kind == Kind.SURFACE && modes.get(row.number, row.first) != Mode.FREE;
    }

    private static double leaving(Row row, List<Meeting> meetings) {
        for (Meeting meeting : meetings) {
            if (row.kind == Kind.SURFACE && row.number == meeting.surface && row.first == meeting.particle) {
                return meeting.leaving;
            }
        }
        return row.bounce.leaving(-row.rate);
    }

    private static double inwards(Row row, List<Meeting> meetings) {
        double most = 0;
        for (Meeting meeting : meetings) {
            if (meeting.particle == row.first) {
                most = Math.max(most, -Vector3.at(row.gradient, 0).dot(meeting.pull));
            }
        }
        return most;
    }

    /** Solves for the impulses. */
    private void strike(Block block, double fast, double[] state) {
        boolean solved = solve.solve(block, row -> true, true);
        for (Row row : block.rows) {
            solved &= row.isContact() || Math.abs(row.separation) <= Tolerances.NO_SOLUTION * fast;
        }
        double approach = Arrays.stream(block.rows).filter(row -> row.meets).mapToDouble(row -> -row.rate).max()
                .orElse(0);
        if (!solved && approach > Tolerances.NO_SOLUTION * fast) {
            throw SolvePhase.reason(block).map(why -> solve.failure(block, contacts.system.getTime(), why))
                    .orElseGet(() -> noRoom(block));
        }
        apply.move(block, state, 3);
        for (Row row : block.rows) {
            if (row.force != 0) {                       // an impact on one ball leaves the rest of a pile at rest
                modes.setWhereTouching(row.first, Mode.SLIDING);
                modes.setWhereTouching(Math.max(row.first, row.second), Mode.SLIDING);
            }
        }
    }

    /** The error that ends a run where what a particle touches leaves it no way to go. */
    private SimulationException noRoom(Block block) {
        Row worst = Arrays.stream(block.rows).filter(Row::isContact)
                .min(Comparator.comparingDouble(row -> row.separation)).orElseThrow();
        int i = worst.movable[0] < 0 ? worst.second : worst.first;
        List<String> by = Arrays.stream(block.rows).filter(row -> row.moves(i)).map(row -> nameBeside(row, i))
                .distinct().toList();
        String last = by.get(by.size() - 1);
        return new SimulationException(contacts.system.getTime(), i, "there is no room left "
                + (by.size() == 1 ? "at " : "between " + String.join(", ", by.subList(0, by.size() - 1)) + " and ")
                + last, null);
    }

    /** What acts on a particle through a row. */
    private String nameBeside(Row row, int i) {
        if (row.kind == Kind.SURFACE) {
            return "'" + row.surface.name() + "'";
        }
        String other = row.kind == Kind.WIRE ? ""
                : "'" + contacts.particles.id(row.first + row.second - i) + "'";
        return row.kind == Kind.BALLS ? other : row.kind == Kind.ROD ? "its rod to " + other : "its wire";
    }

    /**
     * Coulomb's impulses across the normals: those that leave the least energy of all that are at most mu times the
     * normal ones, or in the half ellipses of scales. Jacobi's iteration, with equal shares for all contacts of a
     * particle, does not depend on their order.
     */
    private void rub(Block block, double fast, double[] state) {
        Row[] rows = Arrays.stream(block.rows).filter(row -> row.isContact() && row.bounce.friction() * row.force > 0)
                .toArray(Row[]::new);
        if (rows.length == 0) {
            return;
        }
        Vector3[] impulses = new Vector3[rows.length];
        Arrays.fill(impulses, Vector3.ZERO);
        double[] slowness = new double[rows.length];
        Skin[] skins = new Skin[rows.length];
        for (int r = 0; r < rows.length; r++) {
            skins[r] = rows[r].kind == Kind.SURFACE
                    ? evaluate.sliding.skin(rows[r].first, state, Vector3.at(rows[r].gradient, 0)) : Skin.SMOOTH;
            for (int k = 0; k < 2; k++) {
                int i = rows[r].movable[k];
                slowness[r] += i < 0 ? 0 : block.weight(i) * Arrays.stream(rows).filter(row -> row.moves(i)).count();
            }
        }
        double change = Double.POSITIVE_INFINITY;
        for (int iteration = 0; change > Tolerances.ROUNDING * fast && iteration < MOST_ITERATIONS; iteration++) {
            Vector3[] more = new Vector3[rows.length];
            change = 0;
            for (int r = 0; r < rows.length; r++) {
                Vector3 wanted = impulses[r].minus(rows[r].slip(state).over(slowness[r]));
                more[r] = skins[r].balance(wanted.times(-1), rows[r].bounce.friction() * rows[r].force).times(-1)
                        .minus(impulses[r]);
                change = Math.max(change, slowness[r] * more[r].length());
            }
            for (int r = 0; r < rows.length; r++) {
                impulses[r] = impulses[r].plus(more[r]);
                for (int k = 0; k < 2; k++) {
                    int i = rows[r].movable[k];
                    if (i >= 0) {
                        int v = STRIDE * i + 3;
                        double sign = rows[r].kind == Kind.BALLS && k == 0 ? -1 : 1;
                        Vector3.at(state, v).plus(more[r].times(sign * block.weight(i))).put(state, v);
                    }
                }
            }
        }
        if (block.isJoined()) {
            apply.correct(block, state, 3, true);
        }
    }
}
