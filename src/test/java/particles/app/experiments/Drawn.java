package particles.app.experiments;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import particles.experiments.runs.FittedLine;

/**
 * What the CSV file beside a picture says of one of its quantities: for each series the points, in the order of the
 * file. On charts of work the errors of a line are shown again, by points that are fitted or bars up to medians.
 *
 * @param title    the chart's title
 * @param quantity the label of its y axis
 * @param series   by name the points
 */
record Drawn(String title, String quantity, Map<String, List<double[]>> series) {
    private static final Pattern CELL = Pattern.compile("(?<=^|,)(?:\"[^\"]*\"|[^,\"])*");
    /** Ends the name of a series that shows the points of another one again. */
    static final String AGAIN = " again";
    private static final int BAR = 3;

    /** @return the charts of a file; those with the same title and quantity, as on panels, are one */
    static List<Drawn> read(Path csv) throws IOException {
        Map<String, Drawn> charts = new LinkedHashMap<>();
        List<String> lines = Files.readAllLines(csv);
        for (String line : lines.subList(1, lines.size())) {
            List<String> cells = cells(line);
            Map<String, List<double[]>> all = charts.computeIfAbsent(cells.get(4), quantity ->
                    new Drawn(cells.get(0), quantity, new LinkedHashMap<>())).series();
            double[] point = {Double.parseDouble(cells.get(3)), Double.parseDouble(cells.get(5))};
            String name = cells.get(1);
            boolean again = cells.get(2).startsWith("evaluations of") && (all.containsKey(name + AGAIN)
                    || Double.isFinite(point[1]) && all.getOrDefault(name, List.of()).stream().anyMatch(known ->
                    Arrays.equals(known, point)));
            all.computeIfAbsent(name + (again ? AGAIN : ""), first -> new ArrayList<>()).add(point);
            if (cells.get(2).startsWith("CPU time") && Double.isNaN(point[0])) {
                List<double[]> points = all.get(name);          // a gap is behind each bar of two points
                List<double[]> bar = points.subList(points.size() - BAR, points.size());
                all.computeIfAbsent(name + AGAIN, first -> new ArrayList<>()).addAll(bar);
                bar.clear();
            }
        }
        return List.copyOf(charts.values());
    }

    private static List<String> cells(String line) {
        return CELL.matcher(line).results().map(cell -> cell.group().replace("\"", "")).toList();
    }

    /** @return the points of a solver's first series that can be drawn */
    List<double[]> of(String solver) {
        return withGaps(solver).stream().filter(point -> Double.isFinite(point[0]) && Double.isFinite(point[1]))
                .toList();
    }

    private List<double[]> withGaps(String solver) {
        return series.entrySet().stream().filter(one -> one.getKey().equals(solver)
                || one.getKey().startsWith(solver + ",")).findFirst().orElseThrow(() ->
                new AssertionError(solver + " is not drawn, but said in '" + title + "'")).getValue();
    }

    /** @return the exponent of y as a power of x by least squares of logarithms, from an x on */
    double exponent(String solver, double from) {
        return FittedLine.exponent(of(solver).stream().filter(point -> point[0] >= from).toList(), p -> p[0],
                p -> p[1]);
    }

    /** @return the least x at which the line through the points is at y or below, on logarithmic axes */
    double crossing(String solver, double y) {
        return crossing(withGaps(solver), withGaps(solver), y);
    }

    /** @return the same at the ends of the bars, on the same piece of the line, or 5 % more if there are none */
    double most(String solver, double y) {
        List<double[]> bars = series.get(solver + AGAIN);
        return bars == null || bars.stream().allMatch(point -> Double.isFinite(point[0])) ? 1.05 * crossing(solver, y)
                : crossing(withGaps(solver), IntStream.range(0, bars.size() / BAR).mapToObj(k ->
                        bars.get(BAR * k + 1)).toList(), y);
    }

    private static double crossing(List<double[]> line, List<double[]> told, double y) {
        double least = Double.POSITIVE_INFINITY;
        double there = Double.POSITIVE_INFINITY;
        for (int k = 0; k < line.size(); k++) {
            double[] from = line.get(Math.max(0, k - 1));
            double[] to = line.get(k);
            double crossed = Math.log(from[1] / y) / Math.log(from[1] / to[1]);
            for (double part : new double[] {crossed, to[1] <= y ? 1 : Double.NaN}) {
                double x = from[0] * Math.pow(to[0] / from[0], part);
                if (part > 0 && part <= 1 && x < least) {
                    least = x;
                    double begin = told.get(Math.max(0, k - 1))[0];
                    there = begin * Math.pow(told.get(k)[0] / begin, part);
                }
            }
        }
        return there;
    }
}
