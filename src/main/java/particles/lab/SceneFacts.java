package particles.lab;

import deSolvers.catalog.SolverCatalog;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.IntStream;
import particles.effects.EffectKind;
import particles.effects.springs.SpringRates;
import particles.law.Vector3;
import particles.scene.Scene;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneFormat;
import particles.spec.JsonText;
import particles.spec.Key;
import particles.spec.Kind.Chosen;
import particles.spec.NumberType;
import particles.spec.VectorType;
import particles.view.ParticleStyle;
import particles.view.ParticleStyle.ParticleMark;
import particles.view.RenderOptions;
import particles.view.Scenery;
import particles.view.Scenery.CurveView;
import particles.view.SpringView;

/** The facts of a scene that the page needs before its first frame. */
final class SceneFacts {
    private static final int WIRE_POINTS = 200;
    /** The length of an endless wire that is drawn to either side of its beginning (m). */
    private static final double WIRE_REACH = 20;

    private SceneFacts() {
    }

    /**
     * @param scene    the scene, before its run
     * @param frames records its run
     * @return the facts by name
     */
    static Map<String, Object> of(Scene scene, FrameRecorder frames) {
        SceneDescription description = scene.description();
        Scenery scenery = scene.scenery();
        SpringView springs = scene.springs();
        SpringRates rates = SpringRates.of(springs, scene.system().getParticles());
        Map<String, Object> facts = JsonText.map("title", description.title(),
                "teaches", description.values().get(SceneFormat.TEACHES), "solver", description.solver(),
                "deltaT", description.deltaT(), "duration", description.duration(),
                "energies", frames.getEnergyNames(), "uniform", frames.getUniform(),
                "look", look(description.drawing().look()),
                "planes", scenery.planes().stream().map(plane -> Map.of("point", vector(plane.point()),
                "normal", vector(plane.normal()))).toList(),
                "spheres", scenery.spheres().stream().map(sphere -> Map.of("centre", vector(sphere.centre()),
                "radius", sphere.radius(), "hollow", sphere.hollow())).toList(),
                "wires", scenery.wires().stream().map(SceneFacts::wire).toList(),
                "surfaces", scenery.surfaces().stream().map(surface -> Map.of("triangles", surface.triangles(),
                "ofSprings", surface.ofSprings())).toList(),
                "remarks", description.remarks(),
                "laws", description.values().get(SceneFormat.EFFECTS).stream().map(SceneFacts::law).toList(),
                "dampings", IntStream.range(0, springs.springCount()).mapToObj(springs::damping).distinct().toList(),
                "limit", limit(description.solver(), rates), "omega", rates.omega(), "damping", rates.dampingRate());
        description.drawing().camera().ifPresent(camera -> facts.put("camera", Map.of(
                "position", vector(camera.position()), "target", vector(camera.target()), "up", vector(camera.up()),
                "perspective", camera.perspective(), "fieldOfView", camera.fieldOfView(), "height", camera.height())));
        description.output().phase().ifPresent(phase -> facts.put("phase", List.of(phase.particle(),
                phase.about().isPresent() ? 0 : phase.axis())));       // the page plots positions only
        return facts;
    }

    /** The name of an effect and its numbers: the key, the value and the unit of each. */
    private static Map<String, Object> law(Chosen<EffectKind> effect) {
        List<List<Object>> numbers = new ArrayList<>();
        for (Key<?> key : effect.kind().getKeys()) {
            Object value = effect.values().find(key).orElse(null);
            if (key.type() instanceof NumberType type && value != null) {
                numbers.add(List.of(key.name(), value, type.unit()));
            } else if (key.type() instanceof VectorType type && value != null) {
                numbers.add(List.of(key.name(), vector((Vector3) value), type.component().unit()));
            }
        }
        return Map.of("name", effect.kind().getName(), "numbers", numbers);
    }

    /** The longest stable step (s), by the springs of the scene; NaN if it is not known or there is none. */
    private static double limit(String name, SpringRates rates) {
        return SolverCatalog.find(name).filter(solver -> !solver.adaptive() && rates.omega() > 0)
                .map(solver -> solver.limit(rates.dampingRate() > 0) / rates.fastest(0)).orElse(Double.NaN);
    }

    private static Map<String, Object> look(RenderOptions look) {
        ParticleStyle style = look.style();
        Map<String, Object> marks = JsonText.map();
        style.marks().forEach(mark -> marks.put(mark.particle(), mark(mark)));
        return JsonText.map("particles", name(look.particles()), "springs", name(look.springs()),
                "radius", look.particleRadius(), "strainRange", look.strainRange(), "colours",
                List.of(look.colours().particle(), look.colours().fixed(), look.colours().front(),
                look.colours().back()),
                "springColour", look.colours().springs().orElse(-1), "background",
                look.colours().background().orElse(-1),
                "kind", name(style.kind()), "ageColours", style.ageColours(), "trail", style.trail(),
                "night", style.night(), "arrows", style.arrows(), "marks", marks);
    }

    private static Map<String, Object> mark(ParticleMark mark) {
        Map<String, Object> facts = JsonText.map("radius", mark.radius(), "label", mark.label());
        mark.colour().ifPresent(colour -> facts.put("colour", colour));
        mark.trail().ifPresent(trail -> facts.put("trail", trail));
        return facts;
    }

    private static String name(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT);
    }

    private static List<Double> wire(CurveView wire) {
        boolean endless = Double.isInfinite(wire.length());
        double from = endless ? -WIRE_REACH : 0;
        double step = (endless ? 2 * WIRE_REACH : wire.length()) / WIRE_POINTS;
        List<Double> points = new ArrayList<>();
        for (int i = 0; i <= WIRE_POINTS; i++) {
            points.addAll(vector(wire.at(from + i * step)));
        }
        return points;
    }

    static List<Double> vector(Vector3 v) {
        return List.of(v.x(), v.y(), v.z());
    }
}
