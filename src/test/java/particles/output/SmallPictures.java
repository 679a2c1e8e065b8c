package particles.output;

import java.util.IntSummaryStatistics;
import java.util.List;
import java.util.function.DoubleFunction;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.Simulation;
import particles.law.Particles;
import particles.law.Plane;
import particles.law.Sphere;
import particles.law.Vector3;
import particles.output.frames.FrameObserver;
import particles.output.frames.FrameRenderer;
import particles.output.frames.FrameRenderer.FrameSetup;
import particles.output.frames.FrameSink;
import particles.output.painters.FrameState;
import particles.output.painters.FrameState.FrameStructure;
import particles.output.painters.FrameState.TrailSample;
import particles.view.Camera;
import particles.view.ParticleStyle;
import particles.view.ParticleStyle.ParticleMark;
import particles.view.RenderOptions;
import particles.view.RenderOptions.Visibility;
import particles.view.Scenery;
import particles.view.Scenery.CurveView;
import particles.view.Scenery.Surface;
import particles.view.SpringView.SpringList;

/** Small pictures seen from the front, 20 pixels a metre, for tests that count pixels. */
public final class SmallPictures {
    public static final int W = 320;
    public static final int H = 200;
    /** 20 pixels a metre, the origin in the middle. */
    public static final Camera FRONT = new Camera(new Vector3(0, 0, 50), Vector3.ZERO, new Vector3(0, 1, 0), false,
            0, 10);

    private SmallPictures() {
    }

    public static RenderOptions look(ParticleStyle.Kind kind, double radius, double trail) {
        return new RenderOptions(Visibility.ALWAYS, Visibility.ALWAYS, radius, 0.1,
                new RenderOptions.Colours(0x3366cc, 0x202020, 0xff0000, 0x0000ff),
                new ParticleStyle(kind, ParticleStyle.STANDARD.ageColours(), trail, kind == ParticleStyle.Kind.GLOW));
    }

    /** @return balls and springs, the free particles in this colour and the rest black */
    public static RenderOptions plain(int rgb, double radius, ParticleStyle style) {
        return new RenderOptions(Visibility.ALWAYS, Visibility.ALWAYS, radius, 0.1,
                new RenderOptions.Colours(rgb, 0, 0, 0), style);
    }

    public static FrameRenderer renderer(Camera camera, RenderOptions look, Scenery scenery) {
        return new FrameRenderer(new FrameSetup(camera, look, scenery, "", ""), W, H, 2);
    }

    /** Runs a simulation, and gives its frames to a sink. */
    public static void film(Simulation simulation, FrameRenderer renderer, double rate, FrameSink sink) {
        try (FrameObserver frames = new FrameObserver(renderer, rate, List.of(sink))) {
            simulation.addObserver(frames);
            simulation.run();
        }
    }

    /** @return free particles at rest, three coordinates each */
    public static FrameState state(double... positions) {
        return state(0, List.of(), SpringList.NONE, positions);
    }

    /** @return the same at a time, with a trail and springs */
    public static FrameState state(double time, List<TrailSample> trail, SpringList springs, double... positions) {
        int count = positions.length / 3;
        double[] numbers = new double[Particles.STRIDE * count];
        for (int i = 0; i < count; i++) {
            System.arraycopy(positions, 3 * i, numbers, Particles.STRIDE * i, 3);
        }
        String[] ids = IntStream.range(0, count).mapToObj(i -> "p" + i).toArray(String[]::new);
        return new FrameState(time, numbers, new FrameStructure(ids, new boolean[count], springs, new double[count],
                new double[count], new ParticleMark[count]), trail, List.of());
    }

    /** @return a picture of free particles at these places */
    public static int[] picture(Camera camera, RenderOptions look, Scenery scenery, double... positions) {
        return renderer(camera, look, scenery).render(state(positions));
    }

    /** @return a state whose first two particles are joined by a spring */
    public static FrameState spring(double restLength, double stiffness, double... positions) {
        return state(0, List.of(), new SpringList(new int[] {0}, new int[] {1}, new double[] {restLength},
                new double[] {stiffness}), positions);
    }

    /** @return a curve of this length */
    public static CurveView curve(double length, DoubleFunction<Vector3> at) {
        return new CurveView() {
            @Override
            public Vector3 at(double u) {
                return at.apply(u);
            }

            @Override
            public double length() {
                return length;
            }
        };
    }

    /** @return surfaces, planes, spheres and wires to draw */
    public static Scenery scenery(Object... parts) {
        return new Scenery(only(Surface.class, parts), only(Plane.class, parts), only(Sphere.class, parts),
                only(CurveView.class, parts));
    }

    private static <T> List<T> only(Class<T> type, Object... parts) {
        return Stream.of(parts).filter(type::isInstance).map(type::cast).toList();
    }

    /** @return the colour in the middle */
    public static int middle(int[] picture) {
        return picture[H / 2 * W + W / 2];
    }

    public static long count(int[] picture, IntPredicate colour) {
        return IntStream.of(picture).filter(colour).count();
    }

    /** @return how far the pixels' red, green and blue are apart, each from 0 to 255 */
    public static IntSummaryStatistics differences(int[] one, int[] other) {
        return IntStream.range(0, 3 * one.length).map(k -> Math.abs((one[k / 3] >> 8 * (k % 3) & 255)
                - (other[k / 3] >> 8 * (k % 3) & 255))).summaryStatistics();
    }

    /** The number of pixels that differ from the empty picture; edge pixels count partly. */
    public static double area(int[] picture, int[] empty) {
        return IntStream.range(0, picture.length).filter(p -> picture[p] != empty[p]).count();
    }
}
