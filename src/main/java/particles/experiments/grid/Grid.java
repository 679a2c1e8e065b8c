package particles.experiments.grid;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * All combinations of the values of some axes.
 *
 * @param axes the axes; the last one varies fastest from point to point
 */
public record Grid(List<GridAxis> axes) {

    /**
     * A point with its run's result.
     *
     * @param at       the values of the axes
     * @param measured a number for each measure; NaN where there is none
     * @param end      how the run ended: {@link SceneGrid#WHOLE}, or the reason why it failed
     */
    public record Row(List<String> at, List<Double> measured, String end) {
    }

    /** @return the points, each with a value for each axis */
    public List<List<String>> points() {
        List<List<String>> points = List.of(List.of());
        for (GridAxis axis : axes) {
            points = points.stream().flatMap(point -> axis.values().stream().map(value ->
                    Stream.concat(point.stream(), Stream.of(value)).toList())).toList();
        }
        return points;
    }

    /**
     * @param k from 1 to n
     * @param n the number of parts
     * @return every n-th point, from the k-th on
     */
    public List<List<String>> part(int k, int n) {
        List<List<String>> points = points();
        return IntStream.range(0, points.size()).filter(i -> i % n == k - 1).mapToObj(points::get).toList();
    }

    /** @return a few points in which each value of each axis appears */
    public List<List<String>> sample() {
        List<String> first = axes.stream().map(axis -> axis.values().get(0)).toList();
        List<List<String>> some = new ArrayList<>(List.of(first));
        for (int a = 0; a < axes.size(); a++) {
            for (String value : axes.get(a).values().subList(1, axes.get(a).values().size())) {
                List<String> point = new ArrayList<>(first);
                point.set(a, value);
                some.add(point);
            }
        }
        return some;
    }
}
