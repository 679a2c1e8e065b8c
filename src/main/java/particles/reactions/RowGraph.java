package particles.reactions;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import particles.law.Particles;

/**
 * The graph of constraint rows that share a movable particle: its connected components, and an order in which each
 * matrix has a small bandwidth.
 */
final class RowGraph {
    private final Rows rows;
    private final Map<Integer, List<Integer>> rowsOf = new HashMap<>();     // by movable particle
    private final Particles particles;

    RowGraph(Rows rows, Particles particles) {
        this.rows = rows;
        this.particles = particles;
        for (int r = 0; r < rows.count; r++) {
            join(r, rows.first[r]);
            join(r, rows.second[r]);
        }
    }

    private void join(int row, int particle) {
        if (particle >= 0 && !particles.isFixed(particle)) {
            rowsOf.computeIfAbsent(particle, p -> new ArrayList<>()).add(row);
        }
    }

    /**
     * Returns the connected components, each in Cuthill-McKee order (1969): breadth-first from a row with few
     * neighbours, so that the matrix of a chain is tridiagonal.
     */
    List<int[]> parts() {
        List<int[]> parts = new ArrayList<>();
        boolean[] placed = new boolean[rows.count];
        Comparator<Integer> byDegree = Comparator.comparingInt(this::degree);
        List<Integer> all = new ArrayList<>();
        for (int r = 0; r < placed.length; r++) {
            all.add(r);
        }
        all.sort(byDegree);
        for (int start : all) {
            if (placed[start]) {
                continue;
            }
            List<Integer> part = new ArrayList<>();
            ArrayDeque<Integer> queue = new ArrayDeque<>(List.of(start));
            placed[start] = true;
            while (!queue.isEmpty()) {
                int row = queue.remove();
                part.add(row);
                neighbours(row).stream().filter(other -> !placed[other]).distinct().sorted(byDegree).forEach(other -> {
                    placed[other] = true;
                    queue.add(other);
                });
            }
            parts.add(part.stream().mapToInt(Integer::intValue).toArray());
        }
        return parts;
    }

    private int degree(int row) {
        return neighbours(row).size();
    }

    private List<Integer> neighbours(int row) {
        List<Integer> all = new ArrayList<>(rowsOf.getOrDefault(rows.first[row], List.of()));
        all.addAll(rowsOf.getOrDefault(rows.second[row], List.of()));
        return all;
    }
}
