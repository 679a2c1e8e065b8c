package particles.scene.format;

import java.util.List;
import particles.effects.EffectCatalog;
import particles.effects.EffectKind;
import particles.scene.parts.ConstraintDescription;
import particles.scene.parts.ParticleDescription;
import particles.scene.parts.RodDescription;
import particles.scene.parts.RuleKind;
import particles.scene.parts.ShapeKind;
import particles.scene.parts.SpringDescription;
import particles.scene.parts.WireKind;
import particles.spec.Chosen;
import particles.spec.Key;
import particles.spec.KindType;
import particles.spec.ListType;
import particles.spec.MappingType;
import particles.spec.NameType;
import particles.spec.NumberType;
import particles.spec.TextType;
import particles.spec.Values;
import particles.spec.WholeNumberType;
import particles.spec.documents.JsonSchema;
import particles.spec.documents.Reference;

/** The format of scene files. The reader, its messages, the JSON Schema and the reference tables all follow from it. */
public final class SceneFormat {
    public static final Key<String> TITLE = Key.required("title", TextType.prose(),
            "What the scene shows, in a few words.");
    public static final Key<String> TEACHES = Key.required("teaches", TextType.prose(),
            "What it teaches, in a sentence or two.");
    public static final Key<Values> SOLVER = Key.required("solver", SolverFormat.TYPE,
            "The method that solves the equations of motion.");
    public static final Key<Double> DELTA_T = Key.required("deltaT", NumberType.positive("s"), "The time step (s).");
    public static final Key<Double> DURATION = Key.required("duration", NumberType.notNegative("s"), "How long the run"
            + " lasts (s).");
    public static final Key<Integer> THREADS = Key.optional("threads", new WholeNumberType(1, 64), "How many threads"
            + " evaluate the forces of a large system; by default one for each processor. The result is the"
            + " same, bit for bit.");
    public static final Key<List<Values>> PARTICLES = Key.withDefault("particles", ListType.of("a particle",
            ParticleDescription.TYPE),
            List.of(), "Particles, one by one; they pass through each other.");
    public static final Key<List<Chosen<ShapeKind>>> SHAPES = Key.withDefault("shapes",
            ListType.of("a shape", new KindType<>("shape", ShapeKind.ALL)), List.of(),
                    "Many particles and springs at once.");
    public static final Key<List<Values>> SPRINGS = Key.withDefault("springs",
            ListType.of("a spring", SpringDescription.TYPE),
            List.of(),
            "Springs between any two particles.");
    public static final Key<List<Values>> RODS = Key.withDefault("rods", ListType.of("a rod", RodDescription.TYPE),
            List.of(),
            "Rigid rods between any two particles, as long as their initial distance.");
    public static final Key<List<Chosen<WireKind>>> WIRES = Key.withDefault("wires",
            ListType.of("a wire", new KindType<>("wire", WireKind.ALL)), List.of(), "Wires that particles slide"
                    + " along.");
    public static final Key<Values> CONSTRAINTS = Key.optional("constraints", ConstraintDescription.TYPE,
            "How rods and wires are enforced.");
    public static final Key<List<Chosen<EffectKind>>> EFFECTS = Key.withDefault("effects",
            ListType.of("an effect", new KindType<>("effect", EffectCatalog.ALL)
                    .orByClass(EffectKind.class, "exercises.MyForce")
                    .notToConfuseWith("rule", "rules", RuleKind.ALL)), List.of(),
            "Forces on all particles; only those named here act.");
    public static final Key<List<Chosen<RuleKind>>> RULES = Key.withDefault("rules",
            ListType.of("a rule", new KindType<>("rule", RuleKind.ALL)
                    .notToConfuseWith("effect", "effects", EffectCatalog.ALL)), List.of(),
            "What happens between steps; only rules named here act.");
    public static final Key<String> IMPACT = Key.withDefault("impact",
            NameType.of("kind of impact", List.of("clamp", "exact")),
            "clamp",
            "clamp: after each step, particles below a surface are moved onto it and bounce with the speed they"
                    + " have then, up to deltaT late; in a groove they may keep jumping by about g deltaT^2."
                    + " exact: the step is divided at the impact.");
    public static final Key<Values> CAMERA = Key.optional("camera", CameraFormat.TYPE,
            "Where the scene is seen from; by default so that everything fits into the picture.");
    public static final Key<Values> LOOK = Key.optional("look", RenderFormat.TYPE, "How things are drawn.");
    public static final Key<Values> OUTPUT = Key.optional("output", OutputDescription.TYPE, "Which files are written.");
    public static final Key<Double> BLOW_UP_FACTOR = Key.withDefault("blowUpFactor", NumberType.positive(""), 1e6,
            "The run ends when the kinetic energy exceeds the scene's own energy scale by this factor.");

    public static final MappingType SCENE = MappingType.of("the scene", TITLE, TEACHES, SOLVER, DELTA_T, DURATION,
            PARTICLES,
            SHAPES,
            SPRINGS, RODS, WIRES, CONSTRAINTS, EFFECTS, RULES, IMPACT, CAMERA, LOOK, OUTPUT, BLOW_UP_FACTOR, THREADS);

    private SceneFormat() {
    }

    /**
     * @return the JSON Schema of scene files, by which editors complete and check them:
     *         {@code scenes/scene.schema.json}
     */
    public static String jsonSchema() {
        return JsonSchema.of(SCENE, "A scene of DESolver",
                "Generated from particles.scene.format.SceneFormat; a test keeps the two equal.");
    }

    /**
     * @param heading the beginning of each heading, such as {@code ###}
     * @return the reference of scene files, as Markdown tables
     */
    public static String reference(String heading) {
        return Reference.of(SCENE, heading);
    }
}
