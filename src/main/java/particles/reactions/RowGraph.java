package particles.reactions;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import particles.law.Particles;

/**
 * The graph of constraint rows that share a movable particle: its connected components, and an order in which each
 * matrix has a small bandwidth.
 */
final class RowGraph {
    private final List<List<Integer>> neighbours = new ArrayList<>();       // by row

    RowGraph(List<Row> rows, Particles particles) {
        Map<Integer, List<Integer>> rowsOf = new HashMap<>();               // by movable particle
        for (int r = 0; r < rows.size(); r++) {
            for (int i : new int[] {rows.get(r).first, rows.get(r).second}) {
                if (i >= 0 && !particles.isFixed(i)) {
                    rowsOf.computeIfAbsent(i, p -> new ArrayList<>()).add(r);
                }
            }
        }
        for (Row row : rows) {
            List<Integer> all = new ArrayList<>(rowsOf.getOrDefault(row.first, List.of()));
            all.addAll(rowsOf.getOrDefault(row.second, List.of()));
            neighbours.add(all);
        }
    }

    /**
     * Returns the connected components, each in Cuthill-McKee order (1969): breadth-first from a row with few
     * neighbours, so that the matrix of a chain is tridiagonal.
     */
    List<int[]> parts() {
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
}
