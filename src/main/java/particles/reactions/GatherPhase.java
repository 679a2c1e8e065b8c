package particles.reactions;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.law.Particles;
import particles.reactions.ContactModes.Mode;
import particles.reactions.Row.Kind;

/**
 * The first phase, which gathers who is joined and who touches what: the blocks of the system and the rows of each.
 * Blocks stay until a rod, wire or contact of balls is added or removed, their rows of forces also until a contact mode
 * changes.
 */
final class GatherPhase {
    private final Contacts contacts;
    private final ContactModes modes;
    private final Particles particles;
    private final List<Row> rows;
    private final List<Block> singles = new ArrayList<>();
    private final List<Block> joined = new ArrayList<>();
    private Block[] blockOf = {};                       // by particle; null for one that is not coupled
    private int joinedAt = Block.NEVER;                 // the rows' count of changes

    /** Which contacts with surfaces get rows. */
    interface Touching {
        boolean test(int surface, int particle);
    }

    GatherPhase(Contacts contacts) {
        this.contacts = contacts;
        modes = contacts.getModes();
        particles = contacts.particles;
        rows = contacts.rows;
    }

    /** The blocks of coupled particles. */
    List<Block> joined() {
        if (joinedAt != contacts.getRowChanges()) {
            joinedAt = contacts.getRowChanges();
            joined.clear();
            blockOf = new Block[particles.count()];
            for (int[] part : parts()) {
                Block block = block(part, Arrays.stream(part).mapToObj(rows::get)
                        .flatMapToInt(row -> IntStream.of(row.first, row.second))
                        .filter(i -> i >= 0 && !particles.isFixed(i)).distinct().sorted().toArray());
                joined.add(block);
                Arrays.stream(block.particles).forEach(i -> blockOf[i] = block);
            }
        }
        return joined;
    }

    private Block block(int[] members, int... movable) {
        return new Block(members, movable, rows, particles);
    }

    /** Whether a particle is on a rod or wire, or in contact with a ball. */
    boolean isCoupled(int particle) {
        joined();
        return particle < blockOf.length && blockOf[particle] != null;
    }

    /** The block of a particle. */
    Block of(int particle) {
        return isCoupled(particle) ? blockOf[particle] : alone(particle);
    }

    /** A block of one particle and its surfaces, even if it is coupled. */
    Block alone(int particle) {
        while (singles.size() <= particle) {
            singles.add(block(new int[0], singles.size()));
        }
        return singles.get(particle);
    }

    /** A block of the rows that act on held particles only, which may all move, without their contacts. */
    Block linksBetween(Block block, int[] held) {
        Block links = block(Arrays.stream(block.rows).filter(Row::isIdle).mapToInt(row -> row.number).toArray(), held);
        gather(links, new BitSet(), true, (surface, i) -> false);
        return links;
    }

    /** Whether no particle of a row moves while forces act. */
    boolean isHeld(Row row) {
        return IntStream.of(row.first, row.second).allMatch(i -> i < 0 || particles.isFixed(i) || modes.isSticking(i));
    }

    /** The particles of a block with a property. */
    static BitSet where(Block block, IntPredicate property) {
        BitSet found = new BitSet();
        for (int i : block.particles) {
            found.set(i, property.test(i));
        }
        return found;
    }

    /**
     * Finds the rows of a block while sticking particles are held.
     *
     * @param balls whether balls in contact get rows
     */
    void gather(Block block, boolean balls) {
        if (block.stickingAt != modes.getChanges()) {
            block.stickingAt = modes.getChanges();
            block.sticking = where(block, modes::isSticking);
        }
        gather(block, block.sticking, balls);
    }

    /** As {@link #gather(Block, boolean)}, while given particles are held. */
    void gather(Block block, BitSet held, boolean balls) {
        boolean lasts = !block.hasPairs || held == block.sticking && balls;     // where balls touch, those of forces
        if (!lasts || block.gatheredAt != modes.getChanges() || !block.held.equals(held)) {
            gather(block, held, balls, (surface, i) -> modes.get(surface, i) != Mode.FREE);
            block.gatheredAt = lasts ? modes.getChanges() : Block.NEVER;
        }
    }

    /** Finds the rows of a block. A particle's contacts come right after its first rod: the envelope stays narrow. */
    void gather(Block block, BitSet held, boolean balls, Touching touching) {
        block.held = held;
        block.gatheredAt = Block.NEVER;
        BitSet placed = new BitSet();                   // particles whose contacts have rows
        List<Row> found = new ArrayList<>();
        for (int member : block.members) {
            Row row = rows.get(member);
            if (balls || row.kind != Kind.BALLS) {
                found.add(row.numbered(member));
                addContacts(block, row.first, touching, placed, found);
                addContacts(block, row.second, touching, placed, found);
            }
        }
        for (int i : block.particles) {
            addContacts(block, i, touching, placed, found);
        }
        keep(block, found.stream());
        block.active = new boolean[block.rows.length];
        Arrays.fill(block.active, true);
        block.firstAt = Block.NEVER;
    }

    /** Adds a row for each surface that a movable particle touches, the first time. */
    private void addContacts(Block block, int i, Touching touching, BitSet placed, List<Row> found) {
        if (canMove(block, i) && !placed.get(i)) {
            placed.set(i);
            for (int p = 0; p < contacts.getSurfaces().size(); p++) {
                if (touching.test(p, i)) {
                    found.add(Row.contact(i, p, contacts.getSurfaces().get(p)));
                }
            }
        }
    }

    private boolean canMove(Block block, int i) {
        return i >= 0 && particles.getInverseMasses()[i] != 0 && !block.held.get(i);
    }

    /** Lets a block have these rows only. Their envelope begins where an earlier row moves one of their particles. */
    void keep(Block block, Stream<Row> kept) {
        block.rows = kept.toArray(Row[]::new);
        int[] firstRow = new int[block.particles.length];
        Arrays.fill(firstRow, block.rows.length);
        block.matrix.clear();
        for (int r = 0; r < block.rows.length; r++) {
            Row row = block.rows[r];
            int begin = r;
            for (int k = 0; k < 2; k++) {
                int i = row.particle(k);
                if (canMove(block, i)) {
                    row.movable[k] = i;
                    int place = Arrays.binarySearch(block.particles, i);
                    firstRow[place] = Math.min(firstRow[place], r);
                    begin = Math.min(begin, firstRow[place]);
                }
            }
            block.matrix.add(begin);
        }
    }

    /**
     * Returns the connected components of the graph of rows that share a movable particle, each in Cuthill-McKee order
     * (1969): breadth-first from a row with few neighbours, so that the matrix of a chain is tridiagonal.
     */
    private List<int[]> parts() {
        List<List<Integer>> neighbours = neighbours();
        List<int[]> parts = new ArrayList<>();
        boolean[] placed = new boolean[neighbours.size()];
        Comparator<Integer> byDegree = Comparator.comparingInt(row -> neighbours.get(row).size());
        IntStream.range(0, placed.length).boxed().sorted(byDegree).filter(row -> !placed[row]).forEach(start -> {
            List<Integer> part = new ArrayList<>();
            ArrayDeque<Integer> queue = new ArrayDeque<>(List.of(start));
            placed[start] = true;
            while (!queue.isEmpty()) {
                int row = queue.remove();
                part.add(row);
                neighbours.get(row).stream().filter(other -> !placed[other]).distinct().sorted(byDegree)
                        .forEach(other -> {
                            placed[other] = true;
                            queue.add(other);
                        });
            }
            parts.add(part.stream().mapToInt(Integer::intValue).toArray());
        });
        return parts;
    }

    /** For each row, those that share a movable particle with it. */
    private List<List<Integer>> neighbours() {
        Map<Integer, List<Integer>> rowsOf = new HashMap<>();       // by movable particle
        for (int r = 0; r < rows.size(); r++) {
            for (int i : new int[] {rows.get(r).first, rows.get(r).second}) {
                if (i >= 0 && !particles.isFixed(i)) {
                    rowsOf.computeIfAbsent(i, p -> new ArrayList<>()).add(r);
                }
            }
        }
        List<List<Integer>> neighbours = new ArrayList<>();
        for (Row row : rows) {
            List<Integer> all = new ArrayList<>(rowsOf.getOrDefault(row.first, List.of()));
            all.addAll(rowsOf.getOrDefault(row.second, List.of()));
            neighbours.add(all);
        }
        return neighbours;
    }
}
