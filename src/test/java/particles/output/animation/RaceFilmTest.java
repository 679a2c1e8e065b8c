package particles.output.animation;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.rk4;
import static particles.output.SmallPictures.FRONT;
import static particles.output.SmallPictures.plain;

import deSolvers.catalog.SolverCatalog;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
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
import particles.output.animation.RaceFilm.PanelFilm;
import particles.output.charts.ChartFormat;
import particles.output.charts.ChartWriter;
import particles.output.charts.StripChart;
import particles.output.files.OutputFolder;
import particles.output.frames.FrameRenderer.FrameSetup;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.Look;
import particles.view.ParticleStyle;
import particles.view.Scenery;
import particles.view.Series;
import particles.view.Series.Mark;

class RaceFilmTest {
    private static final Look RK4 = Look.of(SolverCatalog.info("rk4"));

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
        RaceFilm.addGhost(rgb, new int[] {BALL, BALL, EMPTY, 0x000000}, new int[] {EMPTY, EMPTY, EMPTY, EMPTY});
        assertEquals(0xe0 + 150 * (0x40 - 0xe0) / 256, rgb[0] >> 16,
                "150/256 of the way from the empty picture to the ghost");
        assertEquals(0xff0000, rgb[1], "what stands in front hides it");
        assertEquals(EMPTY, rgb[2]);
        assertTrue((rgb[3] & 255) < (rgb[0] & 255), "a darker ghost is darker");
    }

    @Test
    void framesAreKeptAsTheyWereDrawnAndTheLastOneStays() {
        PanelFilm film = new PanelFilm(stage(), 48, 64, 5);
        falling(0.25, film.observer).run();
        film.observer.close();
        assertEquals(6, film.packed.size());
        int[][] at = new int[100][48 * 64];
        for (int k : new int[] {0, 5, 99}) {
            film.get(k, at[k]);
        }
        assertArrayEquals(at[5], at[99]);
        int[] backdrop = film.renderer.renderBackdrop();
        assertTrue(middle(at[0], backdrop) < 32 && middle(at[5], backdrop) > 32, "it falls");
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

    /** The one that fails half way is in all frames; the film has those of the reference. */
    @Test
    void filmIsAsLongAsTheReference(@TempDir Path top) throws IOException {
        Chart strip = strip();
        int parts;
        try (OutputFolder folder = OutputFolder.open(top.resolve("race")); RaceFilm film = new RaceFilm(2, 1, 5, 10)) {
            falling(0.01, film.watch(Optional.empty(), stage())).run();
            falling(0.25, film.watch(Optional.of(RK4), stage())).run();
            Simulation fails = falling(0.25, film.watch(Optional.of(Look.OWN), stage()));
            fails.addObserver(new Observer() {
                @Override
                public void moved(particles.Motion motion) {
                    if (motion.getEndTime() > 0.6) {
                        throw new SimulationException(motion.getEndTime(), 0, "far", null);
                    }
                }
            });
            int[] heard = new int[1];
            assertEquals(0.75, assertThrows(SimulationException.class, fails::run).getTime());
            RaceFilm.Head head = new RaceFilm.Head("A fall", "grey", List.of(
                    new RaceFilm.Words("rk4", RK4, "0.1 m", "deltaT = 0.25 s, 16 evaluations", OptionalDouble.empty()),
                    new RaceFilm.Words("mine", Look.OWN, "", "deltaT = 0.25 s, 16 evaluations",
                            OptionalDouble.of(0.75))));
            film.write(folder, head, strip, part -> heard[0]++);
            new ChartWriter(folder, new ChartFormat(false, true, false)).write("race.png", film.sheet(head, strip));
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

    /** With room for as many solvers as the command takes; the widths are those measured, in pixels of the page. */
    @Test
    void panelsAreAsWideAsThePageAllowsAndTheChartHasRoom() {
        int[] widths = {465, 462, 390, 306, 306, 228, 228, 192, 192, 192, 192, 180, 180, 180, 147, 147};
        for (int panels = 1; panels <= widths.length; panels++) {
            for (double aspect : new double[] {RacePage.aspect(panels), Math.max(RacePage.aspect(panels), 16.0 / 9)}) {
                RacePage page = RacePage.of(panels, aspect);
                assertTrue(page.panelWidth() >= widths[panels - 1], panels + " panels, " + page);
                assertEquals(aspect, page.panelWidth() / (double) page.panelHeight(), 0.03 * aspect, "a whole width");
                assertTrue(page.strip().getWidth() >= 195 && page.strip().getHeight() >= 156,
                        "14 leave least: " + page);
                assertTrue(new Rectangle(RacePage.WIDTH, RacePage.HEIGHT).contains(page.strip()), page::toString);
            }
        }
        for (double aspect : new double[] {4096 / 16.0, 16 / 4096.0}) {        // the extremes that a scene may have
            try (RaceFilm film = new RaceFilm(16, aspect, 5, 10)) {
                film.watch(Optional.empty(), stage());         // throws if a panel is too small
            }
        }
    }

    @Test
    void panelIsInTheFilmPixelForPixelAndTheAxisHasItsWholeName() {
        Random random = new Random(5);
        StripChart chart = new StripChart(strip());
        for (int count : new int[] {1, 4, 6, 12, 16}) {         // in 2, 3, 4, 5 and 6 columns
            RacePage page = RacePage.of(count, RacePage.aspect(count));
            List<BufferedImage> panels = new ArrayList<>();
            for (int k = 0; k < count; k++) {
                BufferedImage panel = new BufferedImage(RaceFilm.scaled(page.panelWidth()),
                        RaceFilm.scaled(page.panelHeight()), BufferedImage.TYPE_INT_RGB);
                int width = panel.getWidth();
                panel.setRGB(0, 0, width, panel.getHeight(), random.ints((long) width * panel.getHeight()).toArray(), 0,
                        width);
                panels.add(panel);
            }
            BufferedImage film = new BufferedImage(RaceFilm.scaled(RacePage.WIDTH), RaceFilm.scaled(RacePage.HEIGHT),
                    BufferedImage.TYPE_INT_RGB);
            Graphics2D g = film.createGraphics();
            g.scale(RaceFilm.SCALE, RaceFilm.SCALE);
            RaceFilm.Words words = new RaceFilm.Words("rk4", RK4, "", "", OptionalDouble.empty());
            page.draw(g, new RaceFilm.Head("", "", Collections.nCopies(count, words)), 0, panels, chart);
            g.dispose();
            List<Integer> all = pixels(film, 0, film.getHeight());
            for (BufferedImage panel : panels) {        // but for its edge, on which the frame is drawn
                List<Integer> row = pixels(panel, panel.getHeight() / 2, 1).subList(1, panel.getWidth() - 1);
                assertTrue(Collections.indexOfSubList(all, row) >= 0, "one of " + count);
            }
            int[] corner = film.getRGB(RaceFilm.scaled((int) page.strip().getX()),
                    RaceFilm.scaled((int) page.strip().getY()), 40, 5, null, 0, 40);
            assertTrue(Arrays.stream(corner).allMatch(rgb -> rgb == Color.WHITE.getRGB()),
                    "the axis has room for its name beside " + count);
        }
    }

    private static List<Integer> pixels(BufferedImage image, int y, int rows) {
        int width = image.getWidth();
        return Arrays.stream(image.getRGB(0, y, width, rows, null, 0, width)).boxed().toList();
    }

    private static Chart strip() {
        return new Chart(Axis.TIME, Axis.log("|energy error|", "%"),
                List.of(new Series(RK4, "rk4", Mark.LINE, new double[] {0, 1}, new double[] {1e-3, 1e-2})));
    }
}
