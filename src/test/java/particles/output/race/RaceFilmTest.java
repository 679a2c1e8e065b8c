package particles.output.race;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.rk4;
import static particles.output.SmallPictures.FRONT;
import static particles.output.SmallPictures.plain;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.Observer;
import particles.ParticleSystem;
import particles.Simulation;
import particles.SimulationException;
import particles.Systems;
import particles.law.Vector3;
import particles.output.TestEffects;
import particles.output.charts.ChartFormat;
import particles.output.charts.ChartWriter;
import particles.output.charts.SolverStyle;
import particles.output.charts.StripChart;
import particles.output.files.OutputFolder;
import particles.output.frames.FrameSetup;
import particles.view.ChartData;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;
import particles.view.ParticleStyle;
import particles.view.Scenery;

class RaceFilmTest {
    private static final int EMPTY = 0xe0e0f0;
    private static final int BALL = 0x404040;

    private static FrameSetup stage() {
        return new FrameSetup(FRONT, plain(0xff0000, 0.3, ParticleStyle.STANDARD), Scenery.NONE, "", "");
    }

    private static Simulation falling(double deltaT, Observer observer) {
        ParticleSystem system = Systems.oneParticle(new Vector3(0, 3, 0), new Vector3(0, 0, 0));
        system.addEffect(TestEffects.gravity(system, 8));
        Simulation simulation = rk4(system, deltaT, 1);
        simulation.addObserver(observer);
        return simulation;
    }

    @Test
    void ghostIsSeenWhereThePictureIsFree() {
        int[] rgb = {EMPTY, 0xff0000, EMPTY, EMPTY};
        GhostLayer.add(rgb, new int[] {BALL, BALL, EMPTY, 0x000000}, new int[] {EMPTY, EMPTY, EMPTY, EMPTY});
        assertEquals(0xe0 + 150 * (0x40 - 0xe0) / 256, rgb[0] >> 16,
                "150/256 of the way from the empty picture to the ghost");
        assertEquals(0xff0000, rgb[1], "what stands in front hides it");
        assertEquals(EMPTY, rgb[2]);
        assertTrue((rgb[3] & 255) < (rgb[0] & 255), "a darker ghost is darker");
    }

    @Test
    void framesAreKeptAsTheyWereDrawnAndTheLastOneStays() {
        PanelFilm film = new PanelFilm(stage(), 48, 64, 5);
        falling(0.25, film.getObserver()).run();
        film.getObserver().close();
        assertEquals(6, film.count());
        int[] first = new int[48 * 64];
        int[] last = new int[48 * 64];
        int[] after = new int[48 * 64];
        film.get(0, first);
        film.get(5, last);
        film.get(99, after);
        assertArrayEquals(last, after);
        int[] backdrop = film.getRenderer().renderBackdrop();
        assertTrue(middle(first, backdrop) < 32 && middle(last, backdrop) > 32, "it falls");
    }

    /** @return the height in the picture of what is not backdrop (pixels from the top) */
    private static double middle(int[] rgb, int[] backdrop) {
        double sum = 0;
        int count = 0;
        for (int p = 0; p < rgb.length; p++) {
            if (rgb[p] != backdrop[p]) {
                sum += p / 48;
                count++;
            }
        }
        return sum / count;
    }

    @Test
    void markStandsOnTheLastPointAndNotBehindTheEndOfALine() {
        Series series = new Series("rk4", Mark.LINE, new double[] {0, 1, 2}, new double[] {5, 6, 7});
        assertEquals(0, StripChart.at(series, 0.5));
        assertEquals(2, StripChart.at(series, 2));
        assertEquals(-1, StripChart.at(series, 2.1));
        assertEquals(-1, StripChart.at(new Series("rk4", Mark.LINE, new double[0], new double[0]), 0));
    }

    /** The one that fails half way is in all frames; the film has those of the reference. */
    @Test
    void filmIsAsLongAsTheReference(@TempDir Path top) throws IOException {
        ChartData strip = new ChartData("", "time (s)", "error", false, true,
                List.of(new Series("rk4", Mark.LINE, new double[] {0, 1}, new double[] {1e-3, 1e-2})));
        int parts;
        try (OutputFolder folder = OutputFolder.open(top.resolve("race")); RaceFilm film = new RaceFilm(2, 1, 5, 10)) {
            falling(0.01, film.watchReference(stage())).run();
            falling(0.25, film.watch("rk4", stage())).run();
            Simulation fails = falling(0.25, film.watch("euler", stage()));
            fails.addObserver(new Observer() {
                @Override
                public void moved(particles.Motion motion) {
                    if (motion.getEndTime() > 0.6) {
                        throw new SimulationException(motion.getEndTime(), 0, "far", null);
                    }
                }
            });
            int[] heard = new int[1];
            try {
                fails.run();
            } catch (SimulationException e) {
                assertEquals(0.75, e.getTime());
            }
            RaceFilm.Head head = new RaceFilm.Head("A fall", "rk4 wins", "grey", List.of(
                    new RaceFilm.Words("rk4", "deltaT = 0.25 s, 16 evaluations", OptionalDouble.empty()),
                    new RaceFilm.Words("euler", "deltaT = 0.25 s, 16 evaluations", OptionalDouble.of(0.75))));
            film.write(folder, head, strip, part -> heard[0]++);
            new ChartWriter(folder, new ChartFormat(false, true)).write("race.png", film.sheet(head, strip));
            parts = heard[0];
        }
        assertEquals(6, parts);
        ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
        try (ImageInputStream in = ImageIO.createImageInputStream(
                Files.newInputStream(top.resolve("race/animation.gif")))) {
            reader.setInput(in);
            assertEquals(6, reader.getNumImages(true));
            assertEquals(List.of(1280, 720), List.of(reader.getWidth(0), reader.getHeight(0)));
        }
        BufferedImage still = ImageIO.read(top.resolve("race/race.png").toFile());
        assertEquals(List.of(1920, 1080), List.of(still.getWidth(), still.getHeight()));
        assertTrue(Files.readString(top.resolve("race/race.svg")).contains("data:image/png"), "with the pictures");
    }

    @Test
    void solversOfOnesOwnHaveALookToo() {
        assertEquals(SolverStyle.of("rk4"), Optional.of(SolverStyle.orGrey("rk4")));
        assertNotEquals(SolverStyle.orGrey("rk4").rgb(), SolverStyle.orGrey("MySolver").rgb());
    }
}
