package particles.app.experiments;

import java.io.IOException;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVRecord;
import particles.experiments.grid.Grid.Row;
import particles.output.files.OutputException;
import particles.spec.messages.InvalidInputException;

/**
 * A CSV file to which each row is added as soon as it is there, so that a sweep that was stopped goes on. Its name
 * contains a digest of all that decides the rows but the values of the axes, so that a longer list of values can go on
 * with it; each part of a sweep has a file of its own.
 */
final class RowFile implements AutoCloseable {
    private final Path file;
    private final Writer writer;

    private RowFile(Path file, Writer writer) {
        this.file = file;
        this.writer = writer;
    }

    /** Opens a file to add rows. Its own rows stay, except the last one if it was cut off. */
    static RowFile open(Path file) {
        try {
            Files.createDirectories(file.getParent());
            try (FileChannel bytes = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
                bytes.truncate(whole(file).getBytes(StandardCharsets.UTF_8).length);
            }
            return new RowFile(file, Files.newBufferedWriter(file, StandardOpenOption.APPEND));
        } catch (IOException e) {
            throw new OutputException(file, "write", e);
        }
    }

    /** The lines of a file that are whole. */
    private static String whole(Path file) throws IOException {
        String text = Files.readString(file);
        return text.substring(0, text.lastIndexOf('\n') + 1);
    }

    /** Adds a row, which is in the file when this returns. */
    synchronized void add(Row row) {
        try {
            List<Object> cells = new ArrayList<>(row.at());
            cells.addAll(row.measured());
            cells.add(row.end());
            CSVFormat.RFC4180.printRecord(writer, cells.toArray());
            writer.flush();
        } catch (IOException e) {
            throw new OutputException(file, "write", e);
        }
    }

    /**
     * @param folder a folder with files of rows, itself or in its folders
     * @param name   the beginning of their names
     * @param axes   the number of axes
     * @param cells  the number of cells in a row: axes, measures and the end
     * @return the rows by their points
     * @throws InvalidInputException if a file has a line that is no row
     */
    static Map<List<String>, Row> read(Path folder, String name, int axes, int cells) {
        Map<List<String>, Row> rows = new LinkedHashMap<>();
        if (!Files.isDirectory(folder)) {
            return rows;
        }
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.filter(one -> one.getFileName().toString().startsWith(name)).sorted().toList()) {
                for (CSVRecord line : CSVFormat.RFC4180.parse(new StringReader(whole(file))).getRecords()) {
                    Row row = row(line.toList(), axes, cells).orElseThrow(() -> new InvalidInputException(file
                            + ": row " + line.getRecordNumber() + " is none of this sweep; remove it, or the file"));
                    rows.put(row.at(), row);
                }
            }
        } catch (IOException | UncheckedIOException e) {
            throw new OutputException(folder, "read the rows in", e instanceof IOException io ? io
                    : ((UncheckedIOException) e).getCause());
        }
        return rows;
    }

    private static Optional<Row> row(List<String> line, int axes, int cells) {
        try {
            return line.size() != cells ? Optional.empty() : Optional.of(new Row(line.subList(0, axes),
                    line.subList(axes, cells - 1).stream().map(Double::valueOf).toList(), line.get(cells - 1)));
        } catch (NumberFormatException e) {
            return Optional.empty();
        }
    }

    @Override
    public void close() {
        try {
            writer.close();
        } catch (IOException e) {
            throw new OutputException(file, "write", e);
        }
    }
}
