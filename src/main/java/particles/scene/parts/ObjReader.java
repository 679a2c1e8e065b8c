package particles.scene.parts;

import static particles.spec.messages.Wording.quote;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.law.Vector3;
import particles.scene.parts.NamedFiles.NamedFile;
import particles.spec.messages.Place;
import particles.spec.messages.Problems;

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
     * A vertex.
     *
     * @param position its position, in the file's own coordinates
     * @param line     its line in the file
     */
    record Vertex(Vector3 position, int line) {
    }

    /**
     * A face, or a part of a line between two vertices.
     *
     * @param corners the numbers of its vertices, from 0; those of a face are counter-clockwise seen from outside
     * @param line    its line in the file
     */
    record Polygon(int[] corners, int line) {
        boolean isFace() {
            return corners.length > 2;
        }
    }

    /**
     * The contents of a file.
     *
     * @param source   its name in messages
     * @param vertices its vertices
     * @param polygons its faces, and the parts of its lines
     * @param groups   the vertices of each group and object
     */
    record Contents(String source, List<Vertex> vertices, List<Polygon> polygons, Map<String, BitSet> groups) {
    }

    private final Contents contents;
    private final int count;
    /** The names that follow the latest {@code g} and {@code o}. */
    private final Map<String, List<String>> names = new HashMap<>();

    private ObjReader(String source, int count) {
        contents = new Contents(source, new ArrayList<>(), new ArrayList<>(), new TreeMap<>());
        this.count = count;
    }

    /** @return the contents of a file, or empty if problems were reported */
    static Optional<Contents> read(NamedFile file, Problems problems) {
        String[] lines = file.text().split("\r\n?|\n");
        int count = (int) Stream.of(lines).filter(line -> line.matches("\\s*v\\s.*")).count();
        if (count == 0) {
            return problems.add(Place.of(file.name()), "no line begins with 'v', so there are no vertices; is this a"
                    + " Wavefront OBJ file?");
        }
        ObjReader reader = new ObjReader(file.name(), count);
        int before = problems.count();
        String begun = "";
        for (int n = 1; n <= lines.length && !problems.isFull(); n++) {
            String line = begun + lines[n - 1].replaceFirst("#.*", "").strip();
            boolean goesOn = line.endsWith("\\");
            begun = goesOn ? line.replace('\\', ' ') : "";
            String mistake = goesOn ? "" : reader.take(line.split("\\s+"), n);
            if (!mistake.isEmpty()) {
                problems.add(new Place(file.name(), n, 1), quote(line) + " " + mistake);
            }
        }
        return problems.count() > before ? Optional.empty() : Optional.of(reader.contents);
    }

    /** Reads a line, and returns what is wrong with it. */
    private String take(String[] words, int line) {
        return switch (words[0]) {
            case "v" -> addVertex(words, line);
            case "f", "l" -> addPolygon(words, line);
            case "g", "o" -> {
                names.put(words[0], List.of(words).subList(1, words.length));
                yield "";
            }
            default -> "";
        };
    }

    /** Adds a vertex, also a wrong one, so that the numbers of the others stay right. */
    private String addVertex(String[] words, int line) {
        Vector3 position = Vector3.at(IntStream.rangeClosed(1, 3)
                .mapToDouble(c -> c < words.length ? number(words[c]) : Double.NaN).toArray(), 0);
        contents.vertices.add(new Vertex(position, line));
        return position.isFinite() ? "" : "is not a vertex; it needs three coordinates, such as 'v 0 0.5 -1'";
    }

    private String addPolygon(String[] words, int line) {
        int[] corners = Stream.of(words).skip(1).mapToInt(this::vertex).toArray();
        if (IntStream.of(corners).anyMatch(vertex -> vertex < 0)) {
            return "names a vertex that is not there; the file has 1 to " + count + ", and -1 is the last one before";
        }
        boolean isFace = words[0].equals("f");
        int least = isFace ? 3 : 2;
        if (IntStream.of(corners).distinct().count() < (isFace ? Math.max(least, corners.length) : least)) {
            return "needs at least " + least + " corners, all different";       // a line may be closed
        }
        for (int k = 0, n = isFace ? corners.length : 2; k + n <= corners.length; k++) {
            contents.polygons.add(new Polygon(Arrays.copyOfRange(corners, k, k + n), line));
        }
        names.values().stream().flatMap(List::stream).map(name -> contents.groups.computeIfAbsent(name,
                key -> new BitSet())).forEach(group -> IntStream.of(corners).forEach(group::set));
        return "";
    }

    /** @return the number of a vertex, from 0, by its own or its negative number; -1 if there is none */
    private int vertex(String word) {
        double number = number(word.split("/", 2)[0]);
        double vertex = number < 0 ? contents.vertices.size() + number : number - 1;
        return vertex < count && vertex == Math.rint(vertex) ? (int) vertex : -1;
    }

    private static double number(String word) {
        try {
            return word.matches("[-+.eE\\d]+") ? Double.parseDouble(word) : Double.NaN;     // Java takes '1d', too
        } catch (NumberFormatException e) {
            return Double.NaN;
        }
    }
}
