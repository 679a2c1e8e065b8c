package particles.experiments.race;

import static particles.view.DataTable.column;

import deSolvers.text.Digits;
import java.util.Arrays;
import java.util.stream.IntStream;
import particles.experiments.energy.DriftCharts;
import particles.experiments.race.Race.Lane;
import particles.experiments.race.Race.Result;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.DataTable;
import particles.view.Series;
import particles.view.Series.Mark;

/** Charts and tables of a race. */
public final class RaceCharts {
    private static final double SMALLEST = 1e-17;

    private RaceCharts() {
    }

    /**
     * @param race the result of the race
     * @return the energy error of each solver over time, with a cross where a solver left the race
     */
    public static Chart energy(Result race) {
        return DriftCharts.sizes(race.lanes().stream().map(Lane::drift).toList()).named("energy-error");
    }

    /**
     * @param race the result of the race
     * @return the distance of each solver from the reference, over time; the root mean square over time at its end
     */
    public static Chart distance(Result race) {
        return new Chart(Axis.TIME, Axis.log("distance from the reference", "m"), race.lanes().stream().flatMap(lane ->
                DriftCharts.toItsEnd(Series.of(lane.look(), lane.label(), Mark.LINE, IntStream.range(1,
                        lane.distance().length).filter(k -> lane.distance()[k] >= SMALLEST).boxed().toList(),
                        k -> race.times()[k], k -> lane.distance()[k]).ending(mean(lane)), lane.drift().outcome()))
                .toList());
    }

    /** @return the distance of a solver from the reference, such as "rms 0.12 m", or when it left the race */
    public static String mean(Lane lane) {
        return lane.left().isPresent() ? "until " + Digits.few(lane.left().getAsDouble()) + " s"
                : Double.isNaN(rms(lane)) ? "" : "rms " + Digits.few(rms(lane)) + " m";
    }

    /**
     * @param race the result of the race
     * @return the scene and the work of each solver
     */
    public static String title(Result race) {
        return Digits.format("%s: equal work, %d evaluations for the whole race", race.scene(),
                race.work());
    }

    /** Root mean square over the frames (m); NaN of a part of the race, or where there is nothing to compare. */
    private static double rms(Lane lane) {
        return lane.left().isPresent() ? Double.NaN : Math.sqrt(Arrays.stream(lane.distance())
                .filter(d -> d >= 0).map(d -> d * d).average().orElse(Double.NaN));
    }

    /**
     * @param race the result of the race
     * @return the table, with a row for each solver
     */
    public static DataTable table(Result race) {
        return DataTable.of("race", "What each solver reached", race.lanes(), column("solver", Lane::label),
                column("deltaT (s)", lane -> lane.drift().setting().deltaT()),
                column("tolerance", 2, lane -> lane.drift().setting().tolerance().orElse(Double.NaN)),
                column("evaluations", lane -> lane.drift().outcome().evaluations()),
                column("distance, rms (m)", 3, RaceCharts::rms),
                column("distance at the end (m)", 3, lane -> lane.left().isPresent() ? Double.NaN
                        : lane.distance()[lane.distance().length - 1]),
                column("largest energy error (%)", 2, lane -> 100 * lane.drift().extreme()),
                column("left the race at (s)", 3, lane -> lane.left().orElse(Double.NaN)),
                column("what went wrong", lane -> lane.drift().outcome().failure().orElse(""))).withoutEmptyColumns();
    }
}
