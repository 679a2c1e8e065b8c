package particles.scene.parts;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.law.Vector3;
import particles.scene.parts.SpringFamily.Sink;
import particles.scene.parts.SpringFamily.Sort;
import particles.view.Scenery.Surface;

/**
 * A regular grid of particles in one, two or three directions: a rope, a cloth or a block. The first index varies
 * slowest.
 *
 * @param id      the shape's name; its particles have names such as {@code cloth[3,4]}
 * @param counts  the number of particles along each direction, at least 2
 * @param origin  the position of the particle [0,0,0] (m)
 * @param edges   the vectors from the first to the last particle along each direction (m)
 * @param sides   the names of the two ends along each direction
 */
record Lattice(String id, List<Integer> counts, Vector3 origin, List<Vector3> edges, List<List<String>> sides)
        implements ParticleLayout {
    @Override
    public long size() {
        return counts.stream().mapToLong(Integer::longValue).reduce(1, Math::multiplyExact);
    }

    /** @return the indices of particle n */
    int[] indices(int n) {
        int[] indices = new int[counts.size()];
        for (int d = indices.length - 1; d >= 0; d--) {
            indices[d] = n % counts.get(d);
            n /= counts.get(d);
        }
        return indices;
    }

    /** @return the number of the particle at these indices, or -1 if they lie outside */
    int number(int... indices) {
        int n = 0;
        for (int d = 0; d < indices.length; d++) {
            if (indices[d] < 0 || indices[d] >= counts.get(d)) {
                return -1;
            }
            n = n * counts.get(d) + indices[d];
        }
        return n;
    }

    /** @return the step in particle number for an index in this direction */
    int stride(int direction) {
        return counts.subList(direction + 1, counts.size()).stream().reduce(1, (a, b) -> a * b);
    }

    @Override
    public String idOf(int n) {
        return Arrays.stream(indices(n)).mapToObj(Integer::toString).collect(Collectors.joining(",", id + "[", "]"));
    }

    @Override
    public Optional<Integer> find(String particle) {
        int[] indices = Stream.of(particle.substring(particle.indexOf('[') + 1).split("\\D+"))
                .filter(index -> index.matches("\\d{1,9}")).mapToInt(Integer::parseInt).toArray();
        int n = indices.length == counts.size() ? number(indices) : -1;
        return n >= 0 && idOf(n).equals(particle) ? Optional.of(n) : Optional.empty();
    }

    @Override
    public Vector3 position(int n) {
        int[] indices = indices(n);
        Vector3 position = origin;
        for (int d = 0; d < indices.length; d++) {
            position = position.plus(edges.get(d).times((double) indices[d] / (counts.get(d) - 1)));
        }
        return position;
    }

    /** @return the area or volume of the edges, relative to their lengths: 1 if orthogonal, 0 if linearly dependent */
    double flatness() {
        if (edges.stream().anyMatch(edge -> edge.length() == 0)) {
            return 0;
        }
        List<Vector3> units = edges.stream().map(Vector3::normalized).toList();
        return switch (units.size()) {
            case 1 -> 1;
            case 2 -> units.get(0).cross(units.get(1)).length();
            default -> Math.abs(units.get(0).cross(units.get(1)).dot(units.get(2)));
        };
    }

    @Override
    public double mass(int n, double total) {
        return total / size();
    }

    @Override
    public IntStream numbers(String part) {
        if (part.endsWith("]")) {
            return find(part).stream().mapToInt(Integer::intValue);
        }
        List<String> together = List.of(part.split("-"));
        return IntStream.range(0, (int) size()).filter(n -> {
            List<String> own = sidesOf(indices(n));
            return switch (part) {
                case "corners" -> own.size() == counts.size();
                case "edges" -> !own.isEmpty();
                default -> own.containsAll(together);
            };
        });
    }

    /** @return the names of the sides to which a particle belongs */
    private List<String> sidesOf(int[] indices) {
        List<String> names = new ArrayList<>();
        for (int d = 0; d < indices.length; d++) {
            if (indices[d] == 0 || indices[d] == counts.get(d) - 1) {
                names.add(sides.get(d).get(indices[d] == 0 ? 0 : 1));
            }
        }
        return names;
    }

    @Override
    public long pairs(Sort sort) {
        return sort.offsets(counts.size()).stream().mapToLong(offset -> IntStream.range(0, offset.length)
                .mapToLong(d -> Math.max(0, counts.get(d) - Math.abs(offset[d]))).reduce(1, (a, b) -> a * b)).sum();
    }

    @Override
    public void forEachPair(Sort sort, Sink sink) {
        for (int[] offset : sort.offsets(counts.size())) {
            for (int n = 0; n < size(); n++) {
                int[] at = indices(n);
                Arrays.setAll(at, d -> at[d] + offset[d]);
                int partner = number(at);
                if (partner >= 0) {
                    sink.spring(n, partner);
                }
            }
        }
    }

    /** {@inheritDoc} A lattice in two or three directions spans one: a cloth itself, or the six sides of a block. */
    @Override
    public Optional<Surface> surface(int first, List<Sort> sorts) {
        IntStream.Builder triangles = IntStream.builder();
        if (counts.size() == 1) {
            return Optional.empty();
        } else if (counts.size() == 2) {
            addSheet(triangles, first, 1, 0);           // front: the viewer sees [0,0] top left
        } else {
            for (int d = 0; d < 3; d++) {
                addSheet(triangles, first, (d + 2) % 3, (d + 1) % 3);
                addSheet(triangles, first + (counts.get(d) - 1) * stride(d), (d + 1) % 3, (d + 2) % 3);
            }
        }
        return Optional.of(new Surface(triangles.build().toArray(), sorts.contains(Sort.STRUCTURAL)));
    }

    /** Adds the sheet through a corner along directions u and v; its front is on the side of u x v. */
    private void addSheet(IntStream.Builder triangles, int corner, int u, int v) {
        int right = stride(u);
        int down = stride(v);
        for (int i = 0; i + 1 < counts.get(u); i++) {
            for (int j = 0; j + 1 < counts.get(v); j++) {
                int a = corner + i * right + j * down;
                int c = a + right + down;
                IntStream.of(a, a + right, c, a, c, a + down).forEach(triangles);
            }
        }
    }
}
