package particles.scene.format;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import particles.effects.EffectCatalog;
import particles.effects.EffectKind;
import particles.scene.parts.ParticleDescription;
import particles.scene.parts.RuleCatalog;
import particles.scene.parts.RuleKind;
import particles.scene.parts.ShapeKind;
import particles.scene.parts.SpringDescription;
import particles.scene.parts.WireKind;
import particles.spec.Key;
import particles.spec.Kind.Chosen;
import particles.spec.KindType;
import particles.spec.ListType;
import particles.spec.MapType;
import particles.spec.MappingType;
import particles.spec.NameType;
import particles.spec.NumberType;
import particles.spec.TextType;
import particles.spec.Values;

/** The format of scene files. The reader, its messages, the JSON Schema for editors
 * and the reference tables all follow from it. */
public final class SceneFormat {
    public static final Key<String> TITLE = TextType.prose().required("title", "The scene's title, a few words.");
    public static final Key<String> TEACHES = TextType.prose().required("teaches",
            "The lesson of the scene, in a sentence or two.");
    public static final Key<Values> SOLVER = SolverDescription.TYPE.required("solver",
            "The method that solves the equations of motion.");
    public static final Key<Double> DELTA_T = NumberType.positive("s").required("deltaT", "The time step (s).");
    public static final Key<Double> DURATION = NumberType.notNegative("s").required("duration",
            "The duration of the run (s).");
    public static final Key<Integer> THREADS = new NumberType.Whole(1, 64).optional("threads",
            "The number of threads that evaluate the forces of a large system; by default one for each processor."
            + " The result is the same with any number, bit for bit.");
    public static final Key<List<Values>> PARTICLES = ParticleDescription.TYPE.list("particles",
            "Single particles. They collide with each other only if the scene names"
            + " 'repulsion' or 'collisions'.");
    public static final Key<List<Chosen<ShapeKind>>> SHAPES = new KindType<>("shape", ShapeKind.ALL).list("shapes",
            "Ropes, cloths, blocks and meshes: many particles and springs at once.");
    public static final Key<List<Values>> SPRINGS = SpringDescription.TYPE.list("springs",
            "Springs between any two particles.");
    public static final Key<List<Values>> RODS = MappingType.of("a rod", SpringDescription.FROM,
            SpringDescription.TO).list("rods",
            "Rigid rods between any two particles. The length of a rod is the initial distance of its particles.");
    public static final Key<List<Values>> LINES = MappingType.of("a line", SpringDescription.FROM,
            SpringDescription.TO).list("lines",
            "Lines between any two particles: springs that are drawn and exert no force.");
    public static final Key<List<String>> CORNERS = ListType.of("a corner", SpringDescription.ANY_ID)
            .required("corners", "Its corners, three particles or more, counter-clockwise seen from its front.");
    public static final Key<List<Values>> FACES = MappingType.of("a face", CORNERS).shortFor(CORNERS).list("faces",
            "The faces of a shaded surface that any particles span, such as '- [a, b, c]'.");
    public static final Key<List<Chosen<WireKind>>> WIRES = new KindType<>("wire", WireKind.ALL).list("wires",
            "Wires that particles slide along.");
    public static final Key<Values> CONSTRAINTS = MappingType.of("'constraints'",
            SpringDescription.FEEDBACK, SpringDescription.PROJECTION).optional("constraints",
            "How rods and wires are enforced.");
    public static final Key<List<Chosen<EffectKind>>> EFFECTS = new KindType<>("effect", EffectCatalog.ALL,
            Optional.of(EffectKind.class)).list("effects",
            "Force laws besides springs; only laws named here act. Without gravity, for example, nothing falls.");
    public static final Key<List<Chosen<RuleKind>>> RULES = new KindType<>("rule", RuleCatalog.ALL).list("rules",
            "Rules that act between steps, such as bounces; only rules named here act.");
    public static final Key<String> IMPACT = NameType.of("kind of impact", List.of("clamp", "exact"))
            .withDefault("impact", "clamp",
            """
                    exact: each step is divided at the moment of impact. clamp: after each step, particles below a \
                    surface are moved onto it and bounce, so impacts come up to deltaT late. The rule \
                    'collisions' makes it exact.""");
    public static final Key<Values> CAMERA = CameraFormat.TYPE.optional("camera",
            "The position and direction of the camera; by default everything fits into the picture.");
    public static final Key<Values> LOOK = RenderFormat.TYPE.optional("look", "How things are drawn.");
    public static final Key<Values> OUTPUT = OutputDescription.TYPE.optional("output", "Which files are written.");
    public static final Key<Double> BLOW_UP_FACTOR = NumberType.positive("").withDefault("blowUpFactor", 1e6,
            """
                    The run has blown up, and ends, when the kinetic energy is this many times the energy estimated \
                    for the scene before the run. Whatever this number is, gradle run also ends when the numerical \
                    error is 1000 times the rest of the energy.""");

    public static final Key<Map<String, String>> FILES = new MapType<>(TextType.of("the name of a file", "\\S"),
            TextType.contents("its text")).optional("files",
            "The files that the scene names, for a scene in one piece; without this key they are in its folder.");

    public static final MappingType SCENE = MappingType.of("the scene", TITLE, TEACHES, SOLVER, DELTA_T, DURATION,
            PARTICLES,
            SHAPES,
            SPRINGS, RODS, LINES, FACES, WIRES, CONSTRAINTS, EFFECTS, RULES, IMPACT, CAMERA, LOOK, OUTPUT,
            BLOW_UP_FACTOR, THREADS, FILES);

    private SceneFormat() {
    }
}
