package particles.scene.parts;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import particles.law.Vector3;
import particles.scene.parts.NamedFiles.NamedFile;
import particles.spec.messages.Place;
import particles.spec.messages.Problems;
import particles.spec.messages.Wording;

/**
 * Reads the polygons of a Wavefront OBJ file: vertices {@code v}, faces {@code f}, lines {@code l}, and the groups
 * {@code g} and objects {@code o} that they belong to. Everything else, such as textures, normals and materials, is
 * left out.
 *
 * <p>The library for this format, de.javagl:obj 0.4.0, reads positions in single precision, leaves out lines and
 * objects, and does not say where a mistake is.
 */
final class ObjReader {
    /**
     * A face or a line.
     *
     * @param corners the numbers of its vertices, from 0
     * @param line    its line in the file
     */
    record Polygon(int[] corners, int line) {
    }

    /**
     * The contents of a file.
     *
     * @param source   its name in messages
     * @param vertices the positions, in the file's own coordinates
     * @param lineOf   the line of each vertex
     * @param faces    the faces, counter-clockwise seen from outside
     * @param lines    the lines of two or more vertices
     * @param groups   the vertices of each group and object
     */
    record Contents(String source, List<Vector3> vertices, List<Integer> lineOf, List<Polygon> faces,
            List<Polygon> lines, Map<String, BitSet> groups) {
    }

    private final Contents contents;
    private final Problems problems;
    private final int count;
    /** The names that follow the latest {@code g} and {@code o}. */
    private final Map<String, List<String>> names = new HashMap<>();

    private ObjReader(String source, int count, Problems problems) {
        contents = new Contents(source, new ArrayList<>(), new ArrayList<>(), new ArrayList<>(), new ArrayList<>(),
                new TreeMap<>());
        this.count = count;
        this.problems = problems;
    }

    /** @return the contents of a file, or empty if problems were reported */
    static Optional<Contents> read(NamedFile file, Problems problems) {
        String[] lines = file.text().split("\r\n?|\n");
        int count = (int) Stream.of(lines).filter(line -> line.strip().matches("v\\s.*")).count();
        if (count == 0) {
            return problems.add(Place.of(file.name()), "no line begins with 'v', so there are no vertices; is this a"
                    + " Wavefront OBJ file?");
        }
        ObjReader reader = new ObjReader(file.name(), count, problems);
        int before = problems.count();
        String line = "";
        for (int n = 1; n <= lines.length && !problems.isFull(); n++) {
            line += lines[n - 1].replaceFirst("#.*", "").strip();
            if (line.endsWith("\\")) {
                line = line.replace('\\', ' ');         // it goes on
                continue;
            }
            reader.take(line, n);
            line = "";
        }
        return problems.count() > before ? Optional.empty() : Optional.of(reader.contents);
    }

    private void take(String line, int n) {
        String[] words = line.split("\\s+");
        String mistake = switch (words[0]) {
            case "v" -> addVertex(words, n);
            case "f" -> addPolygon(words, n, 3, contents.faces);
            case "l" -> addPolygon(words, n, 2, contents.lines);
            case "g", "o" -> {
                names.put(words[0], List.of(words).subList(1, words.length));
                yield "";
            }
            default -> "";
        };
        if (!mistake.isEmpty()) {
            problems.add(new Place(contents.source, n, 1), Wording.quote(line) + " " + mistake);
        }
    }

    /** Adds a vertex, also a wrong one, so that the numbers of the others stay right; returns what is wrong. */
    private String addVertex(String[] words, int line) {
        double[] position = new double[3];
        for (int c = 0; c < 3; c++) {
            position[c] = c + 1 < words.length ? coordinate(words[c + 1]) : Double.NaN;
        }
        contents.vertices.add(Vector3.at(position, 0));
        contents.lineOf.add(line);
        return contents.vertices.get(contents.vertices.size() - 1).isFinite() ? ""
                : "is not a vertex; it needs three coordinates, such as 'v 0 0.5 -1'";
    }

    private static double coordinate(String word) {
        try {
            return Double.parseDouble(word);
        } catch (NumberFormatException e) {
            return Double.NaN;
        }
    }

    private String addPolygon(String[] words, int line, int least, List<Polygon> polygons) {
        int[] corners = Stream.of(words).skip(1).mapToInt(this::vertex).toArray();
        if (Arrays.stream(corners).anyMatch(vertex -> vertex < 0)) {
            return "names a vertex that is not there; the file has 1 to " + count + ", and -1 is the last one before";
        }
        if (Arrays.stream(corners).distinct().count() < (least == 2 ? 2 : Math.max(least, corners.length))) {
            return "needs at least " + least + " corners, all different";       // a line may be closed
        }
        polygons.add(new Polygon(corners, line));
        names.values().stream().flatMap(List::stream).forEach(name -> Arrays.stream(corners)
                .forEach(contents.groups.computeIfAbsent(name, key -> new BitSet())::set));
        return "";
    }

    /** @return the number of a vertex, from 0, by its own or its negative number; -1 if there is none */
    private int vertex(String word) {
        try {
            int number = Integer.parseInt(word.split("/", 2)[0]);
            int vertex = number < 0 ? contents.vertices.size() + number : number - 1;
            return vertex < count ? vertex : -1;
        } catch (NumberFormatException e) {
            return -1;
        }
    }
}
