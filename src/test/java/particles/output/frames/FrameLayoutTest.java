package particles.output.frames;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.app.run.CameraFinder;
import particles.app.student.StudentClasses;
import particles.law.Vector3;
import particles.output.frames.FrameRenderer.FrameSetup;
import particles.output.painters.DrawnSizes;
import particles.output.painters.FrameState;
import particles.output.painters.FrameState.FrameStructure;
import particles.output.painters.VisibilityFilter;
import particles.output.raster.CameraProjection;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.SceneReader;
import particles.scene.format.SceneDescription;
import particles.view.ParticleStyle;
import particles.view.RenderOptions.Visibility;
import particles.view.Scenery.CurveView;
import particles.view.Scenery.Surface;

/** In every scene, near the start, in the middle and at the end: words are clear of bodies, and bodies are seen. */
@Tag("slow")
class FrameLayoutTest {
    private static final int WIDTH = 960;
    private static final int HEIGHT = 540;
    private static final double[] MOMENTS = {0.1, 0.5, 1};

    @ParameterizedTest
    @MethodSource("particles.scene.TestScenes#files")
    void wordsAreClearOfBodiesAndBodiesAreInThePicture(Path file) {
        SceneDescription described = SceneReader.read(file, new StudentClasses());
        Scene scene = SceneBuilder.build(described);
        FrameSetup setup = new FrameSetup(CameraFinder.find(described), described.drawing().look(),
                scene.scenery(), described.title(), described.solver() + ", deltaT = " + described.deltaT() + " s");
        Layout layout = new Layout(setup, scene.simulation().getDuration());
        scene.simulation().addObserver(layout);
        scene.simulation().run();
        assertEquals(List.of(), layout.problems);
    }

    /** Looks at the boxes of what is drawn, without drawing it. */
    private static final class Layout implements Observer {
        private final FrameSetup setup;
        private final double duration;
        private final CameraProjection view;
        private final VisibilityFilter shown;
        private final List<String> problems = new ArrayList<>();
        private DrawnSizes sizes;
        private int next;

        Layout(FrameSetup setup, double duration) {
            this.setup = setup;
            this.duration = duration;
            view = new CameraProjection(setup.camera(), WIDTH, HEIGHT);
            shown = new VisibilityFilter(setup.look(), setup.scenery().surfaces());
        }

        @Override
        public void started(ParticleSystem system) {
            sizes = DrawnSizes.of(state(system, system.getOwnState()), setup.look(), view.viewHeight);
        }

        @Override
        public void moved(Motion motion) {
            if (next < MOMENTS.length && motion.getEndTime() >= MOMENTS[next] * duration * (1 - 1e-9)) {
                next++;
                check(motion.getSystem(), state(motion.getSystem(), motion.getEndState()));
            }
        }

        private FrameState state(ParticleSystem system, double[] numbers) {
            FrameStructure structure = FrameStructure.of(system, setup.look().style().marks());
            return new FrameState(system.getTime(), numbers, structure, List.of(), List.of());
        }

        private void check(ParticleSystem system, FrameState state) {
            boolean springs = setup.look().springs() != Visibility.NEVER && state.springs().count() > 0;
            List<Rectangle2D> words = new FrameText(setup, WIDTH, HEIGHT, 2).boxes(state, springs);
            List<Rectangle2D> labels = new FrameMarks(view, setup.look()).boxes(state, sizes.ball());
            String when = " at t = " + state.time();
            for (int k = 0; k < labels.size(); k++) {
                Rectangle2D label = labels.get(k);
                boolean inside = new Rectangle2D.Double(0, 0, WIDTH, HEIGHT).contains(label);
                note(!inside, "label " + k + " is not in the picture" + when);
                note(words.stream().anyMatch(label::intersects), "label " + k + " meets other words" + when);
                for (int other = 0; other < k; other++) {
                    note(label.intersects(labels.get(other)), "labels " + other + " and " + k + " meet" + when);
                }
            }
            for (int i = 0; i < state.particles(); i++) {
                double[] p = place(state.place(i));
                double radius = !shown.particle(i) ? 0 : p[2] * state.structure().radius(i, sizes.ball());
                String what = system.getParticles().id(i) + when + " at " + Math.round(p[0]) + ", " + Math.round(p[1]);
                Rectangle2D body = new Rectangle2D.Double(p[0] - radius, p[1] - radius, 2 * radius, 2 * radius);
                note(words.stream().anyMatch(box -> box.intersects(body) || box.contains(p[0], p[1])),
                        "words on " + what);
                note(!state.isFixed(i) && (p[0] < 0 || p[0] > WIDTH || p[1] < 0 || p[1] > HEIGHT), "not seen: " + what);
            }
            for (int s = 0; s < state.springs().count(); s++) {
                if (shown.spring(state.springs().from()[s], state.springs().to()[s])) {
                    lineFree(words, state, state.springs().from()[s], state.springs().to()[s], when);
                    lineFree(labels, state, state.springs().from()[s], state.springs().to()[s], when);
                }
            }
            for (CurveView wire : setup.scenery().wires()) {
                double length = Double.isInfinite(wire.length()) ? 40 : wire.length();
                for (double u = -length / 2; u < length / 2; u += 0.02) {
                    Vector3 at = wire.at(u);
                    double[] p = place(at);
                    note(words.stream().anyMatch(box -> box.contains(p[0], p[1])), "words on a wire" + when);
                }
            }
            for (Surface surface : setup.scenery().surfaces()) {
                for (int k = 0; k < surface.triangles().length; k++) {
                    lineFree(words, state, surface.triangles()[k],
                            surface.triangles()[k % 3 == 2 ? k - 2 : k + 1], when);
                }
            }
        }

        private void lineFree(List<Rectangle2D> words, FrameState state, int a, int b, String when) {
            double[] from = place(state.place(a));
            double[] to = place(state.place(b));
            Line2D line = new Line2D.Double(from[0], from[1], to[0], to[1]);
            note(words.stream().anyMatch(line::intersects), "words on the line from " + a + " to " + b + when);
        }

        private double[] place(Vector3 point) {
            CameraProjection.Place place = view.place(point);
            return new double[] {place.x(), place.y(), place.scale()};
        }

        private void note(boolean wrong, String problem) {
            if (wrong && problems.size() < 6) {
                problems.add(problem);
            }
        }
    }
}
