package particles.app.experiments;

import java.io.IOException;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
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
import particles.output.files.Disk;
import particles.output.files.OutputException;
import particles.output.report.TableText;

/**
 * A CSV file to which each row is added as soon as it is there, so that a sweep that was stopped goes on. Its name
 * contains a digest of all that decides the rows but the values of the axes, so that a longer list of values can go on
 * with it; each part of a sweep has a file of its own.
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
     * Opens a file to add rows. Its own rows stay, except the last one if it was cut off.
     *
     * @param known rows of other files that it gets too
     */
    static RowFile open(Path file, Grid grid, List<Measure> measures, List<Row> known) {
        try {
            Files.createDirectories(file.getParent());
            Map<List<String>, Row> rows = Files.exists(file) ? read(file, grid, measures) : new LinkedHashMap<>();
            known.forEach(row -> rows.putIfAbsent(row.at(), row));
            Path part = file.resolveSibling("." + file.getFileName() + ".part");    // a stop leaves the old file
            Files.write(part, TableText.csv(new GridCharts(grid, measures, List.copyOf(rows.values())).table()));
            Disk.REAL.rename(part, file);
            return new RowFile(grid, measures, file, Files.newBufferedWriter(file, StandardOpenOption.APPEND));
        } catch (IOException e) {
            throw new OutputException(file, "write", e);
        }
    }

    /** Adds a row, which is in the file when this returns. */
    synchronized void add(Row row) {
        try {
            writer.write(TableText.csv(new GridCharts(grid, measures, List.of(row)).table()).get(1) + "\n");
            writer.flush();
        } catch (IOException e) {
            throw new OutputException(file, "write", e);
        }
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
                rows.putAll(read(file, grid, measures));
            }
        } catch (IOException | UncheckedIOException e) {
            throw new OutputException(folder, "read the rows in", e instanceof IOException io ? io
                    : ((UncheckedIOException) e).getCause());
        }
        return rows;
    }

    private static Map<List<String>, Row> read(Path file, Grid grid, List<Measure> measures) throws IOException {
        Map<List<String>, Row> rows = new LinkedHashMap<>();
        String text = Files.readString(file, StandardCharsets.UTF_8);
        String whole = text.substring(0, text.lastIndexOf('\n') + 1);
        for (CSVRecord line : CSVFormat.RFC4180.parse(new StringReader(whole)).getRecords().stream().skip(1).toList()) {
            Row row = row(line, grid.axes().size(), measures.size());
            rows.put(row.at(), row);
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
