package particles.scene.parts;

import java.util.Optional;
import particles.effects.SharedKeys;
import particles.law.Plane;
import particles.law.Vector3;
import particles.rules.Emitter;
import particles.rules.KillPlane;
import particles.rules.ParticleResampler;
import particles.rules.SpringTear;
import particles.spec.Key;
import particles.spec.NumberType;
import particles.spec.Values;
import particles.spec.VectorType;

/** The rules by which springs end and particles begin and end; {@link RuleKind#ALL} lists them. */
final class BirthAndDeath {
    private BirthAndDeath() {
    }

    private static final Key<Double> STRAIN = Key.required("strain", NumberType.positive(""),
            "The stretch over the rest length beyond which a spring tears: 0.5 at one and a half times its rest"
            + " length.");

    static final RuleKind TEAR = new RuleKind("tear", "Springs that are stretched too far are gone.", STRAIN) {
        @Override
        public void build(Values values, SceneAssembly assembly) {
            assembly.add(new SpringTear(assembly.springs(), values.get(STRAIN)));
        }

        @Override
        public boolean needsSprings() {
            return true;
        }
    };

    private static final Key<String> ID = Key.required("id", ParticleDescription.NEW_ID,
            "Its name, with which its particles' ids begin: fountain[0], fountain[1] ...; no particle or shape has"
            + " it.");
    private static final Key<Vector3> POSITION = Key.required("position", VectorType.of("m"),
            "Where particles begin (m).");
    private static final Key<Double> RADIUS = Key.withDefault("radius", NumberType.notNegative("m"), 0.0,
            "How far from there at most (m).");
    private static final Key<Vector3> DIRECTION = Key.withDefault("direction", VectorType.notZero(""),
            new Vector3(0, 1, 0),
            "Where they go; of any length.");
    private static final Key<Double> SPREAD = Key.withDefault("spread", NumberType.between(0, 180, "degrees"), 0.0,
            "The largest angle between a particle's direction and that (degrees).");
    private static final Key<Double> SPEED = Key.required("speed", NumberType.notNegative("m/s"),
            "How fast they go (m/s).");
    private static final Key<Double> RATE = Key.required("rate", NumberType.between(1e-6, 1e6, "1/s"),
            "How many are born in a second (1/s).");
    private static final Key<Double> MASS = Key.withDefault("mass", NumberType.positive("kg"), 1.0,
            "The mass of each (kg).");
    private static final Key<Double> LIFETIME = Key.optional("lifetime", NumberType.positive("s"),
            "How long each lives (s); for ever where it is not given.");

    static final RuleKind EMITTER = new RuleKind("emitter", "A source of particles.", ID, POSITION, RADIUS, DIRECTION,
            SPREAD, SPEED,
            RATE, MASS, LIFETIME, SharedKeys.SEED) {
        @Override
        public void build(Values values, SceneAssembly assembly) {
            double lifetime = values.find(LIFETIME).orElse(Double.POSITIVE_INFINITY);
            assembly.add(new Emitter(new Emitter.Nozzle(values.get(ID), values.get(POSITION), values.get(RADIUS),
                    values.get(DIRECTION), StrictMath.toRadians(values.get(SPREAD)), values.get(SPEED),
                    values.get(RATE),
                    values.get(MASS), lifetime, values.get(SharedKeys.SEED))));
            if (lifetime < Double.POSITIVE_INFINITY) {
                assembly.letDie();
            }
            assembly.noteSpeed(values.get(SPEED));
            assembly.noteBirths(values.get(RATE) * values.get(MASS));
        }

        @Override
        public double alive(Values values, double deltaT, double duration) {
            // the dead are taken away at the end of a step, when those of the whole step are born already
            return values.get(RATE) * Math.min(duration, values.find(LIFETIME).orElse(duration) + deltaT);
        }

        @Override
        public Optional<Key<String>> newIds() {
            return Optional.of(ID);
        }
    };

    private static final Key<Vector3> POINT = Key.required("point", VectorType.of("m"), "Any point of the plane (m).");
    private static final Key<Vector3> NORMAL = Key.withDefault("normal", VectorType.notZero(""), new Vector3(0, 1, 0),
            "The side on which particles live; of any length.");

    static final RuleKind KILL = new RuleKind("kill", "Particles that get behind a plane are gone.", POINT, NORMAL) {
        @Override
        public void build(Values values, SceneAssembly assembly) {
            assembly.add(new KillPlane(new Plane(values.get(POINT), values.get(NORMAL))));
        }

        @Override
        public boolean removes() {
            return true;
        }
    };

    private static final Key<String> SAMPLE_ID = Key.withDefault("id", ParticleDescription.NEW_ID, "sample",
            "The name with which the ids of new particles begin; no particle, shape or emitter has it.");
    private static final Key<Double> FARTHEST = Key.required("farthest", NumberType.positive("m"),
            "A particle that has no other within this distance becomes two (m).");
    private static final Key<Double> CLOSEST = Key.withDefault("closest", NumberType.between(0.01, 0.49, ""), 0.3,
            "Two that are closer than this part of the farthest distance become one.");
    private static final Key<Double> LIGHTEST = Key.required("lightest", NumberType.positive("kg"),
            "No particle becomes lighter than this by becoming two (kg).");

    static final RuleKind SAMPLES = new RuleKind("samples", "Particles merge and split so that they are spread evenly.",
            FARTHEST,
            CLOSEST, LIGHTEST, SAMPLE_ID, SharedKeys.SEED) {
        @Override
        public void build(Values values, SceneAssembly assembly) {
            double farthest = values.get(FARTHEST);
            assembly.add(new ParticleResampler(values.get(SAMPLE_ID), assembly.springs(),
                    farthest * values.get(CLOSEST), farthest,
                    values.get(LIGHTEST), values.get(SharedKeys.SEED)));
        }

        @Override
        public Optional<Key<String>> newIds() {
            return Optional.of(SAMPLE_ID);
        }
    };
}
