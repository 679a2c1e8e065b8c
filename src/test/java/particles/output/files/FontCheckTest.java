package particles.output.files;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static particles.Systems.rk4;
import static particles.Texts.assertStarts;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.ParticleSystem;
import particles.Simulation;
import particles.Systems;
import particles.app.ChildProgram;
import particles.law.Vector3;
import particles.output.charts.ChartFormat;
import particles.output.charts.ChartPage;
import particles.output.charts.ChartWriter;
import particles.output.frames.FrameObserver;
import particles.output.frames.FrameRenderer;
import particles.output.frames.FrameRenderer.FrameSetup;
import particles.output.frames.FrameSink;
import particles.view.Axis;
import particles.view.Camera;
import particles.view.Chart;
import particles.view.Panel;
import particles.view.RenderOptions;
import particles.view.Scenery;

/** On a machine without fonts, frames have no text and a chart is one clear error. */
class FontCheckTest {
    @TempDir
    Path top;

    /** The program of a child process: a JVM looks for fonts only once. */
    public static final class Drawing {
        private Drawing() {
        }

        /** @param args the output folder */
        public static void main(String[] args) {
            try (OutputFolder folder = OutputFolder.open(Path.of(args[0]))) {
                ParticleSystem system = Systems.oneParticle(Vector3.ZERO, Vector3.ZERO);
                FrameRenderer renderer = new FrameRenderer(new FrameSetup(
                        Camera.around(Vector3.ZERO, Vector3.ZERO, 1.5), RenderOptions.STANDARD,
                        Scenery.NONE, "title", "caption"), 90, 60, 2);
                Simulation simulation = rk4(system, 0.1, 0);
                try (FrameObserver frames = new FrameObserver(renderer, 25, List.of(FrameSink.png(folder, 90, 60)))) {
                    simulation.addObserver(frames);
                    simulation.run();
                }
                for (int k = 0; k < 2; k++) {
                    try {
                        new ChartWriter(folder, ChartFormat.PAGE).write("chart.png",
                                ChartPage.of(Panel.of("t", List.of(new Chart(Axis.TIME, Axis.TIME, List.of()))),
                                        ChartFormat.PAGE));
                    } catch (OutputException e) {
                        System.out.println(e.getMessage());
                    }
                }
            }
        }
    }

    @Test
    void withoutFontsThereAreFramesAndOneClearLine() throws IOException, InterruptedException {
        assumeTrue(System.getProperty("os.name").equals("Linux"), "fonts are hidden by a setting of fontconfig");
        Path none = Files.writeString(top.resolve("fonts.conf"), "<?xml version=\"1.0\"?><fontconfig></fontconfig>");
        Path home = Files.createDirectory(top.resolve("home"));         // Java keeps a list of fonts there
        ChildProgram child = new ChildProgram(top.resolve("lines.txt"))
                .environment("FONTCONFIG_FILE", none.toString()).jvm("-Duser.home=" + home);
        ChildProgram.End end = child.end(child.startJava("-cp", System.getProperty("java.class.path"),
                Drawing.class.getName(), top.resolve("out").toString()));
        assertEquals(0, end.code(), end.lines());
        List<String> lines = end.lines().lines().filter(line -> !line.startsWith("Fontconfig ")).toList();
        assertEquals(2, lines.size(), end.lines());
        String chart = top.resolve("out").resolve("chart.png").toString();
        for (String line : lines) {
            assertStarts(line, "cannot draw " + chart + ": Java finds no font on this machine");
        }
        assertTrue(Files.size(top.resolve("out/frames/frame-00000.png")) > 0);
    }

    @Test
    void thisMachineHasFonts() {
        assertTrue(FontCheck.isAvailable(), "the tests of charts need one");
    }
}
