package particles.app.course;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.text.Normalizer;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.apache.commons.csv.CSVRecord;
import particles.spec.SourceText;
import particles.spec.messages.InvalidInputException;

/**
 * The students of a class, from a CSV file: Moodle's list of participants, its grading worksheet, or a list of the
 * lecturer's own. The id, from which a student's numbers come, is in the first of these columns that the list has: ID
 * number, login, e-mail address; else in the first column. A list without a header has the id first, then the name,
 * then other words by which hand-ins are known.
 *
 * @param head     the headers
 * @param students the students by their ids, in the order of the list
 * @param remarks  what a reader of the list may not expect, in lines
 */
record ClassList(List<String> head, Map<String, Student> students, List<String> remarks) {
    /** No list: hand-ins are known by their own names. */
    static final ClassList NONE = new ClassList(List.of(), Map.of(), List.of());

    /** What a column holds, by its header. */
    enum Column {
        ID("id", "student", "id number", "student id", "id-nummer"),
        LOGIN("login", "username", "github_username"),
        MAIL("email", "e-mail", "email address", "e-mail-adresse"),
        NUMBER("identifier"),
        NAME("name", "full name"),
        FIRST("first name", "vorname"),
        LAST("last name", "surname", "nachname"),
        GRADE("grade"),
        MOST("maximum grade");

        private final List<String> headers;

        Column(String... headers) {
            this.headers = List.of(headers);
        }

        /** @return its place in a line of headers; negative if it is not there */
        int place(List<String> head) {
            return IntStream.range(0, head.size()).filter(at -> headers.contains(fold(head.get(at)))).findFirst()
                    .orElse(-1);
        }
    }

    /**
     * A student.
     *
     * @param id     the id
     * @param name   the name; empty if the list has none
     * @param mail   the e-mail address, likewise
     * @param number Moodle's number of the participant, likewise
     * @param cells  the line of the list
     * @param keys   all by which hand-ins may be known, as {@link #key} makes it
     */
    record Student(String id, String name, String mail, String number, List<String> cells, List<String> keys) {
        boolean hasNumber(String wanted) {
            return number.isEmpty() ? cells.contains(wanted) : number.equals(wanted);
        }

        /** How well a name means this student: all of it, or the longest word that it ends in, as assignment-login. */
        int match(String nameKey) {
            return keys.contains(nameKey) ? Integer.MAX_VALUE : keys.stream().filter(nameKey::endsWith).mapToInt(
                    String::length).max().orElse(0);
        }
    }

    /**
     * @param file a CSV file with commas, semicolons or tabs
     * @return the cells of its lines
     * @throws InvalidInputException if it cannot be read
     */
    static List<List<String>> rows(Path file) {
        try {
            String text = SourceText.lenient(Files.readAllBytes(file));
            String first = text.lines().findFirst().orElse("");
            String delimiter = first.matches(".*;.*") ? ";" : first.matches(".*\t.*") ? "\t" : ",";
            try (CSVParser parser = CSVParser.parse(text, CSVFormat.DEFAULT.builder().setDelimiter(delimiter)
                    .setTrim(true).setIgnoreEmptyLines(false).get())) {
                return parser.stream().map(CSVRecord::toList).toList();
            }
        } catch (IOException | UncheckedIOException e) {
            throw new InvalidInputException(file + " cannot be read as a CSV file: " + e.getMessage());
        }
    }

    /**
     * @param file a list of students
     * @return its students
     * @throws InvalidInputException if it cannot be read, or two students have the same id
     */
    static ClassList read(Path file) {
        List<List<String>> rows = rows(file);
        List<String> first = rows.stream().findFirst().orElse(List.of());
        boolean headed = Stream.of(Column.values()).anyMatch(column -> column.place(first) >= 0);
        ClassList list = new ClassList(headed ? first : List.of("id", "name"), new LinkedHashMap<>(),
                new ArrayList<>());
        if (!headed) {
            list.remarks.add(file + " has no header that is known: its first line is a student's, with the id first");
        }
        List<String> twice = new ArrayList<>();
        for (int line = headed ? 1 : 0; line < rows.size(); line++) {
            Student student = list.student(rows.get(line));
            String place = file + ":" + (line + 1) + ": ";
            if (student.id.isEmpty()) {
                student.keys.stream().limit(1).map(any -> place + "left out, since it has no id").forEach(
                        list.remarks::add);
            } else if (list.students.putIfAbsent(fold(student.id), student) != null) {      // null for a new one
                twice.add(place + "the id '" + student.id + "' is in an earlier line, too");
            }
        }
        if (!twice.isEmpty()) {
            throw new InvalidInputException(twice);
        }
        return list;
    }

    private Student student(List<String> cells) {
        int id = Stream.of(Column.ID, Column.LOGIN, Column.MAIL).map(column -> column.place(head)).filter(at -> at >= 0)
                .findFirst().orElse(0);
        String name = cell(cells, Column.NAME);
        String whole = name.isEmpty() ? (cell(cells, Column.FIRST) + " " + cell(cells, Column.LAST)).strip() : name;
        return new Student(id < cells.size() ? cells.get(id) : "", whole, cell(cells, Column.MAIL), cell(cells,
                Column.NUMBER).replaceAll("\\D", ""), cells, Stream.concat(cells.stream(), Stream.of(whole))
                .map(ClassList::key).filter(key -> key.length() > 1).toList());
    }

    /** @return the cell of a line in a column; empty if there is none */
    String cell(List<String> cells, Column column) {
        int at = column.place(head);
        return at >= 0 && at < cells.size() ? cells.get(at) : "";
    }

    /** @return the text without differences of case and of Unicode's forms */
    static String fold(String text) {
        return Normalizer.normalize(text, Normalizer.Form.NFKC).toLowerCase(Locale.ROOT).strip();
    }

    /**
     * A name without accents, signs that Moodle leaves out, and the order of its words: "Berg, Dora" is Dora Berg. It
     * begins with a dash, so that assignment-login ends in the key of the login.
     */
    private static String key(String name) {
        return Stream.of(Normalizer.normalize(fold(name), Normalizer.Form.NFKD).replaceAll("[\\p{M}&<>\"'`|:/]", "")
                .split("[\\s,]+")).sorted().collect(Collectors.joining(" ", "-", ""));
    }

    /**
     * @param handIn the name of a hand-in
     * @return the one student whom its number and its name mean; none if they mean nobody, several, or different ones
     */
    Optional<Student> owner(String handIn) {
        Matcher moodle = Submission.MOODLE.matcher(handIn);
        String name = key(moodle.matches() ? moodle.group(1) : handIn);
        int best = Math.max(1, students.values().stream().mapToInt(student -> student.match(name)).max().orElse(0));
        List<Student> byNumber = students.values().stream().filter(one -> one.hasNumber(Submission.id(handIn)))
                .toList();
        List<Student> byName = students.values().stream().filter(one -> one.match(name) == best).toList();
        List<Student> meant = byNumber.isEmpty() ? byName : byNumber.stream().filter(one -> byName.isEmpty()
                || byName.contains(one)).toList();
        return meant.stream().findFirst().filter(only -> meant.size() == 1);
    }

    /** @return the id of the {@link #owner}; without a list, Moodle's number or the name of the hand-in */
    Optional<String> id(String handIn) {
        return this == NONE ? Optional.of(Submission.id(handIn)) : owner(handIn).map(Student::id);
    }

    /** @return the student of this id; of one who is not in the list, nothing but the id is known */
    Student student(String id) {
        return students.getOrDefault(fold(id), new Student(id, "", "", "", List.of(), List.of()));
    }
}
