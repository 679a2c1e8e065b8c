package particles.app.experiments;

import java.io.IOException;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVRecord;
import particles.experiments.grid.Grid;
import particles.experiments.grid.Grid.Row;
import particles.experiments.grid.GridCharts;
import particles.experiments.grid.Measure;
import particles.output.files.OutputException;
import particles.output.report.TableText;

/**
 * A CSV file to which each row is added as soon as it is there, so that a sweep that was stopped goes on. Its name has
 * a digest of the scene and the measures; each part of a sweep has a file of its own.
 */
final class RowFile implements AutoCloseable {
    private final Grid grid;
    private final List<Measure> measures;
    private final Path file;
    private final Writer writer;

    private RowFile(Grid grid, List<Measure> measures, Path file, Writer writer) {
        this.grid = grid;
        this.measures = measures;
        this.file = file;
        this.writer = writer;
    }

    /**
     * Opens a file to add rows.
     *
     * @param known the rows that it has already, which are written anew: the last one may have been cut off
     */
    static RowFile open(Path file, Grid grid, List<Measure> measures, Iterable<Row> known) {
        try {
            Files.createDirectories(file.getParent());
            RowFile opened = new RowFile(grid, measures, file, Files.newBufferedWriter(file));
            opened.write(opened.lines(List.of()).get(0));
            known.forEach(opened::add);
            return opened;
        } catch (IOException e) {
            throw new OutputException(file, "write", e);
        }
    }

    /** Adds a row, which is in the file when this returns. */
    synchronized void add(Row row) {
        try {
            write(lines(List.of(row)).get(1));
        } catch (IOException e) {
            throw new OutputException(file, "write", e);
        }
    }

    private void write(String line) throws IOException {
        writer.write(line + "\n");
        writer.flush();
    }

    private List<String> lines(List<Row> rows) {
        return TableText.csv(new GridCharts(grid, measures, rows).table());
    }

    /**
     * @param folder a folder with files of rows, itself or in its folders
     * @param name   the beginning of their names
     * @return the rows by their points
     */
    static Map<List<String>, Row> read(Path folder, String name, Grid grid, List<Measure> measures) {
        Map<List<String>, Row> rows = new LinkedHashMap<>();
        if (!Files.isDirectory(folder)) {
            return rows;
        }
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.filter(one -> one.getFileName().toString().startsWith(name)).sorted().toList()) {
                String text = Files.readString(file, StandardCharsets.UTF_8);
                String whole = text.substring(0, text.lastIndexOf('\n') + 1);
                for (CSVRecord line : CSVFormat.RFC4180.parse(new StringReader(whole)).getRecords().stream().skip(1)
                        .toList()) {
                    Row row = row(line, grid.axes().size(), measures.size());
                    rows.put(row.at(), row);
                }
            }
        } catch (IOException | UncheckedIOException e) {
            throw new OutputException(folder, "read the rows in", e instanceof IOException io ? io
                    : ((UncheckedIOException) e).getCause());
        }
        return rows;
    }

    private static Row row(CSVRecord line, int axes, int measures) {
        List<String> cells = new ArrayList<>(line.toList());
        return new Row(cells.subList(0, axes), IntStream.range(axes, axes + measures).mapToObj(k ->
                Double.valueOf(cells.get(k))).toList(), cells.get(axes + measures));
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
