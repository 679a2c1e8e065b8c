package particles.output;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static particles.output.SmallPictures.FRONT;
import static particles.output.SmallPictures.curve;
import static particles.output.SmallPictures.look;
import static particles.output.SmallPictures.renderer;
import static particles.output.SmallPictures.scenery;
import static particles.output.SmallPictures.spring;
import static particles.output.SmallPictures.state;

import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.Collection;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import particles.law.Plane;
import particles.law.Vector3;
import particles.output.frames.FrameRenderer;
import particles.output.painters.FrameState;
import particles.view.ParticleStyle;
import particles.view.RenderOptions;
import particles.view.RenderOptions.Visibility;
import particles.view.Scenery;
import particles.view.Scenery.CurveView;
import particles.view.Scenery.Surface;

/** A renderer has memory only for layers that a picture shows; all its layers are counted after a frame. */
class OnlyNamedPaintersTest {
    private static final RenderOptions BALLS = look(ParticleStyle.Kind.BALLS, 1, 0);
    // seen from above
    private static final Plane SLOPE = new Plane(new Vector3(0, -3, 0), new Vector3(0, 0.8, 0.6));
    private static final CurveView LINE = curve(Double.POSITIVE_INFINITY, u -> new Vector3(u, 0, 0));

    /** What takes memory for each pixel or particle. */
    private static final Set<String> LAYERS = Set.of("BlobPainter", "GlowPainter", "TrailPainter", "ShadowMap");

    /** A picture, and the layers that it needs. */
    private record Case(String what, RenderOptions look, Scenery scenery, boolean spring, Set<String> layers) {
    }

    static List<Case> cases() {
        RenderOptions noSprings = new RenderOptions(Visibility.ALWAYS, Visibility.NEVER, 1, 0.1,
                new RenderOptions.Colours(1, 2, 3, 4), ParticleStyle.STANDARD);
        return List.of(new Case("balls", BALLS, Scenery.NONE, false, Set.of()),
                new Case("points", look(ParticleStyle.Kind.POINTS, 1, 0), Scenery.NONE, false, Set.of()),
                new Case("blobs", look(ParticleStyle.Kind.BLOBS, 1, 0), Scenery.NONE, false, Set.of("BlobPainter")),
                new Case("glow", look(ParticleStyle.Kind.GLOW, 1, 0), Scenery.NONE, false, Set.of("GlowPainter")),
                new Case("trails", look(ParticleStyle.Kind.BALLS, 1, 0.5), Scenery.NONE, false, Set.of("TrailPainter")),
                new Case("a spring", BALLS, Scenery.NONE, true, Set.of()),
                new Case("a hidden spring", noSprings, Scenery.NONE, true, Set.of()),
                new Case("a surface", BALLS, scenery(new Surface(new int[] {0, 1, 2}, false)),
                        false, Set.of()),
                new Case("a slope", BALLS, scenery(SLOPE), false, Set.of("ShadowMap")),
                new Case("a wire", BALLS, scenery(LINE), false, Set.of()));
    }

    @ParameterizedTest
    @MethodSource("cases")
    void onlyNeededLayersAreCreated(Case shown) throws IllegalAccessException {
        FrameRenderer renderer = renderer(FRONT, shown.look(), shown.scenery());
        double[] places = {0, 0, 0, 2, 0, 0, 0, 2, 0};
        FrameState state = shown.spring() ? spring(2, 0, places) : state(places);
        renderer.render(state);
        Set<Object> parts = Collections.newSetFromMap(new IdentityHashMap<>());
        collect(renderer, parts);
        assertEquals(shown.layers(), parts.stream().map(part -> part.getClass().getSimpleName())
                .filter(LAYERS::contains).collect(Collectors.toSet()), shown.what());
    }

    /** Follows all fields of our own objects, optional values and collections. */
    private static void collect(Object object, Set<Object> seen) throws IllegalAccessException {
        if (object instanceof Optional<?> optional) {
            if (optional.isPresent()) {
                collect(optional.get(), seen);
            }
        } else if (object instanceof Collection<?> several) {
            for (Object each : several) {
                collect(each, seen);
            }
        } else if (object != null && object.getClass().getName().startsWith("particles.output.") && seen.add(object)) {
            for (Field field : object.getClass().getDeclaredFields()) {
                if (!Modifier.isStatic(field.getModifiers()) && !field.getType().isPrimitive()) {
                    field.setAccessible(true);
                    collect(field.get(object), seen);
                }
            }
        }
    }
}
