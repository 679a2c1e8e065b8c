package particles.scene.parts;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.IntPredicate;
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

    private final String id;
    private final Contents contents;
    private final List<Polygon> faces;
    private final Vector3[] positions;
    private final double[] shares;                      // in the area, which each face shares among its corners

    /**
     * @param id       the shape's name
     * @param contents the contents of the file
     * @param place    moves a vertex from the file's coordinates to the scene's
     */
    Mesh(String id, Contents contents, UnaryOperator<Vector3> place) {
        this.id = id;
        this.contents = contents;
        faces = contents.polygons().stream().filter(Polygon::isFace).toList();
        positions = contents.vertices().stream().map(vertex -> place.apply(vertex.position())).toArray(Vector3[]::new);
        double whole = faces.stream().mapToDouble(this::area).sum();
        shares = new double[positions.length];
        Arrays.fill(shares, faces.isEmpty() ? 1.0 / shares.length : 0);
        for (Polygon face : faces) {
            double share = area(face) / face.corners().length / whole;
            IntStream.of(face.corners()).forEach(n -> shares[n] += share);
        }
    }

    /** The area of a polygon, also of one that is not convex. */
    private double area(Polygon face) {
        int[] c = face.corners();
        Vector3 first = positions[c[0]];
        return IntStream.range(2, c.length).mapToObj(k -> positions[c[k - 1]].minus(first)
                .cross(positions[c[k]].minus(first))).reduce(Vector3.ZERO, Vector3::plus).length() / 2;
    }

    /** @return the line of a vertex that has no share of a mass that is shared by area, if there is one */
    Optional<Integer> withoutShare() {
        return linesOf(n -> !(shares[n] > 0)).boxed().findFirst();
    }

    /** @return the lines of these vertices */
    private IntStream linesOf(IntPredicate which) {
        return IntStream.range(0, positions.length).filter(which).map(n -> contents.vertices().get(n).line());
    }

    @Override
    public List<String> remarks() {
        Set<Vector3> taken = new HashSet<>();
        BitSet joined = new BitSet();
        contents.polygons().forEach(polygon -> IntStream.of(polygon.corners()).forEach(joined::set));
        Set<Long> sides = new HashSet<>();
        return Stream.of(remark("this vertex is at the place of another", linesOf(n -> !taken.add(positions[n]))),
                remark("this vertex belongs to no face or line", linesOf(n -> !joined.get(n))),
                remark("this face and a neighbour are turned to opposite sides", faces.stream().flatMapToInt(face ->
                pairs(face.corners(), 1, 1).filter(side -> !sides.add(side)).mapToInt(side -> face.line()))))
                .flatMap(Optional::stream).toList();
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
            case STRUCTURAL -> contents.polygons().stream().flatMapToLong(polygon -> pairs(polygon.corners(), 1, 1));
            case SHEAR -> faces.stream().map(Polygon::corners).flatMapToLong(c -> pairs(c, 2, c.length - 2));
            case BEND -> beside().stream().flatMapToLong(c -> pairs(c, 1, c.length - 1));
        }).map(pair -> Math.min(pair, turned(pair))).filter(pair -> pair != turned(pair)).sorted().distinct().toArray();
    }

    /** The pairs of corners that are this many steps apart round a polygon, both numbers in one. */
    private static LongStream pairs(int[] corners, int least, int most) {
        int n = corners.length;
        return IntStream.rangeClosed(least, most).boxed().flatMapToLong(step -> IntStream.range(0, n)
                .mapToLong(k -> pair(corners[k], corners[(k + step) % n])));
    }

    private static long pair(int from, int to) {
        return (long) from << 32 | to;
    }

    private static long turned(long pair) {
        return Long.rotateLeft(pair, 32);
    }

    /** For each end of each edge, the corners next to it in the faces that share the edge. */
    private Collection<int[]> beside() {
        Map<Long, int[]> beside = new HashMap<>();
        for (Polygon face : faces) {
            int[] c = face.corners();
            int n = c.length;
            for (int k = 0; k < 2 * n; k++) {
                int step = k < n ? 1 : n - 1;
                beside.merge(pair(c[k % n], c[(k + step) % n]), new int[] {c[(k + n - step) % n]}, Mesh::joined);
            }
        }
        return beside.values();
    }

    private static int[] joined(int[] a, int[] b) {
        return IntStream.concat(IntStream.of(a), IntStream.of(b)).toArray();
    }

    @Override
    public Optional<Surface> surface(int first, List<Sort> sorts) {
        int[] triangles = faces.stream().flatMapToInt(face -> Surface.triangles(face.corners())).map(n -> first + n)
                .toArray();
        return triangles.length == 0 ? Optional.empty() : Optional.of(new Surface(triangles,
                sorts.contains(Sort.STRUCTURAL)
                && faces.stream().allMatch(face -> face.corners().length <= MOST_CORNERS_TO_TEAR)));
    }
}
