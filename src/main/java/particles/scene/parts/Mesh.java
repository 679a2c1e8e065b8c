package particles.scene.parts;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import particles.law.Vector3;
import particles.scene.parts.ObjReader.Contents;
import particles.scene.parts.ObjReader.Polygon;
import particles.scene.parts.SpringFamily.Sink;
import particles.scene.parts.SpringFamily.Sort;
import particles.view.Scenery.Surface;

/**
 * The vertices of a polygon mesh: particles {@code id[0]}, {@code id[1]} and so on, in the order of the file. Edges are
 * neighbours, and so are the corners on both sides of an edge that two faces share.
 */
final class Mesh implements ParticleLayout {
    /** A triangle is torn when fewer than two of its edges are springs: larger faces have triangles with only one. */
    private static final int MOST_CORNERS_TO_TEAR = 4;

    /**
     * A side of a face.
     *
     * @param from   the vertex where it begins
     * @param to     the next one
     * @param before the corner before the first
     * @param after  the corner after the second
     * @param line   the line of the face in the file
     */
    private record Side(int from, int to, int before, int after, int line) {
        long edge() {
            return pair(from, to);
        }

        /** @return the other neighbour of one of its ends in the face */
        int beside(int end) {
            return end == from ? before : after;
        }
    }

    private final String id;
    private final Contents contents;
    private final Vector3[] positions;
    private final List<Side> sides;                     // those of one edge are next to each other
    private final double[] shares;                      // in the area, which each face shares among its corners

    /**
     * @param id       the shape's name
     * @param contents the contents of the file
     * @param place    moves a vertex from the file's coordinates to the scene's
     */
    Mesh(String id, Contents contents, UnaryOperator<Vector3> place) {
        this.id = id;
        this.contents = contents;
        positions = contents.vertices().stream().map(place).toArray(Vector3[]::new);
        sides = contents.faces().stream().flatMap(Mesh::sides).sorted(Comparator.comparingLong(Side::edge)).toList();
        double whole = contents.faces().stream().mapToDouble(face -> area(face.corners())).sum();
        shares = new double[positions.length];
        Arrays.fill(shares, contents.faces().isEmpty() ? 1.0 / shares.length : 0);
        for (Polygon face : contents.faces()) {
            double share = area(face.corners()) / face.corners().length / whole;
            Arrays.stream(face.corners()).forEach(n -> shares[n] += share);
        }
    }

    private static Stream<Side> sides(Polygon face) {
        int[] c = face.corners();
        int n = c.length;
        return IntStream.range(0, n).mapToObj(k -> new Side(c[k], c[(k + 1) % n], c[(k + n - 1) % n], c[(k + 2) % n],
                face.line()));
    }

    private static long pair(int a, int b) {
        return (long) Math.min(a, b) << 32 | Math.max(a, b);
    }

    /** The area of a polygon, also of one that is not convex. */
    private double area(int[] corners) {
        Vector3 first = positions[corners[0]];
        Vector3 twice = Vector3.ZERO;
        for (int k = 2; k < corners.length; k++) {
            twice = twice.plus(positions[corners[k - 1]].minus(first).cross(positions[corners[k]].minus(first)));
        }
        return twice.length() / 2;
    }

    /** @return the line of a vertex that has no share of a mass that is shared by area, if there is one */
    Optional<Integer> withoutShare() {
        return IntStream.range(0, shares.length).filter(n -> !(shares[n] > 0)).mapToObj(contents.lineOf()::get)
                .findFirst();
    }

    @Override
    public List<String> remarks() {
        Set<Vector3> taken = new HashSet<>();
        BitSet joined = new BitSet();
        forEachPair(Sort.STRUCTURAL, (from, to) -> {
            joined.set(from);
            joined.set(to);
        });
        return Stream.of(remark("this vertex is at the place of another", IntStream.range(0, positions.length)
                .filter(n -> !taken.add(positions[n])).map(contents.lineOf()::get)),
                remark("this vertex belongs to no face or line", IntStream.range(0, positions.length)
                .filter(n -> !joined.get(n)).map(contents.lineOf()::get)),
                remark("this face and a neighbour are turned to opposite sides", IntStream.range(1, sides.size())
                .filter(k -> sides.get(k).edge() == sides.get(k - 1).edge() && sides.get(k).from
                == sides.get(k - 1).from).map(k -> sides.get(k).line))).flatMap(Optional::stream).toList();
    }

    private Optional<String> remark(String what, IntStream lines) {
        int[] all = lines.toArray();
        return all.length == 0 ? Optional.empty() : Optional.of(contents.source() + ":" + all[0] + ": " + what
                + (all.length == 1 ? "" : ", and " + (all.length - 1) + " more like it"));
    }

    @Override
    public String id() {
        return id;
    }

    @Override
    public long size() {
        return positions.length;
    }

    @Override
    public String idOf(int n) {
        return id + "[" + n + "]";
    }

    @Override
    public Vector3 position(int n) {
        return positions[n];
    }

    @Override
    public double mass(int n, double total) {
        return total * shares[n];
    }

    @Override
    public IntStream numbers(String part) {
        return Optional.ofNullable(contents.groups().get(part)).map(BitSet::stream)
                .orElseGet(() -> find(part).stream().mapToInt(Integer::intValue));
    }

    @Override
    public String parts() {
        return Stream.concat(Stream.of(range()), contents.groups().keySet().stream()).collect(Collectors.joining(", "));
    }

    @Override
    public long pairs(Sort sort) {
        return find(sort).length;
    }

    @Override
    public void forEachPair(Sort sort, Sink sink) {
        for (long pair : find(sort)) {
            sink.spring((int) (pair >> 32), (int) pair);
        }
    }

    private long[] find(Sort sort) {
        return (switch (sort) {
            case STRUCTURAL -> LongStream.concat(sides.stream().mapToLong(Side::edge), contents.lines().stream()
                    .flatMapToLong(line -> IntStream.range(1, line.corners().length)
                    .mapToLong(k -> pair(line.corners()[k - 1], line.corners()[k]))));
            case SHEAR -> contents.faces().stream().flatMapToLong(face -> diagonals(face.corners()));
            case BEND -> IntStream.range(0, sides.size()).boxed().flatMapToLong(this::across);
        }).filter(pair -> pair >> 32 != (int) pair).sorted().distinct().toArray();
    }

    private static LongStream diagonals(int[] corners) {
        return IntStream.range(2, corners.length).boxed().flatMapToLong(k -> IntStream.range(k == corners.length - 1
                ? 1 : 0, k - 1).mapToLong(j -> pair(corners[j], corners[k])));
    }

    /** The pairs of corners beside the edge of a side and beside that of a later one, if they share the edge. */
    private LongStream across(int k) {
        Side own = sides.get(k);
        return sides.subList(k + 1, sides.size()).stream().takeWhile(other -> other.edge() == own.edge())
                .flatMapToLong(other -> LongStream.of(pair(own.before, other.beside(own.from)),
                        pair(own.after, other.beside(own.to))));
    }

    @Override
    public Optional<Surface> surface(int first, List<Sort> sorts) {
        int[] triangles = contents.faces().stream().map(Polygon::corners).flatMapToInt(Surface::triangles)
                .map(n -> first + n).toArray();
        return triangles.length == 0 ? Optional.empty() : Optional.of(new Surface(triangles,
                sorts.contains(Sort.STRUCTURAL) && contents.faces().stream().allMatch(face ->
                face.corners().length <= MOST_CORNERS_TO_TEAR)));
    }
}
