package particles.reactions;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import particles.law.Particles;
import particles.reactions.Row.Kind;

/** The rows of rods, of balls in contact and of wires, in this order. */
final class Rows {
    final List<Row> list = new ArrayList<>();
    private int changes;

    Row get(int row) {
        return list.get(row);
    }

    /** Counts changes of the list. */
    int getChanges() {
        return changes;
    }

    /** Adds the row of a rod or of two balls, in the order of kinds; it keeps this distance (m). */
    Row addLink(Kind link, int from, int to, double distance) {
        changes++;
        Row row = new Row(link, from, to, distance);
        list.add(begin(Kind.values()[link.ordinal() + 1]), row);
        return row;
    }

    /** Adds the rows of a bead. */
    void addBead(int particle, Curve wire) {
        changes++;
        for (int k = 0; k < Curve.ROWS; k++) {
            list.add(Row.wire(particle, wire, k));
        }
    }

    /** Removes a row. */
    void remove(int row) {
        changes++;
        list.remove(row);
    }

    /** Updates indices after particles were removed; their rows are removed too. */
    void reindex(int[] newIndex) {
        changes++;
        for (Row row : list) {
            row.first = newIndex[row.first];
            row.second = row.second < 0 ? -1 : newIndex[row.second];
        }
        list.removeIf(row -> row.first < 0 || row.second < 0 && row.kind != Kind.WIRE);
    }

    /** The index of the first row of a kind, or of a later one. */
    int begin(Kind from) {
        int r = list.size();
        while (r > 0 && list.get(r - 1).kind.compareTo(from) >= 0) {
            r--;
        }
        return r;
    }

    /**
     * Returns the connected components of the graph of rows that share a movable particle, each in Cuthill-McKee order
     * (1969): breadth-first from a row with few neighbours, so that the matrix of a chain is tridiagonal.
     */
    List<int[]> parts(Particles particles) {
        List<List<Integer>> neighbours = neighbours(particles);
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
    private List<List<Integer>> neighbours(Particles particles) {
        Map<Integer, List<Integer>> rowsOf = new HashMap<>();       // by movable particle
        for (int r = 0; r < list.size(); r++) {
            for (int i : new int[] {list.get(r).first, list.get(r).second}) {
                if (i >= 0 && !particles.isFixed(i)) {
                    rowsOf.computeIfAbsent(i, p -> new ArrayList<>()).add(r);
                }
            }
        }
        List<List<Integer>> neighbours = new ArrayList<>();
        for (Row row : list) {
            List<Integer> all = new ArrayList<>(rowsOf.getOrDefault(row.first, List.of()));
            all.addAll(rowsOf.getOrDefault(row.second, List.of()));
            neighbours.add(all);
        }
        return neighbours;
    }
}
