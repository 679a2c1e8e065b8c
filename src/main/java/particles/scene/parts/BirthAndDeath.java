package particles.scene.parts;

import particles.effects.SharedKeys;
import particles.law.Plane;
import particles.law.Vector3;
import particles.rules.Deaths;
import particles.rules.Emitter;
import particles.rules.ParticleResampler;
import particles.rules.SpringTear;
import particles.spec.Key;
import particles.spec.NumberType;
import particles.spec.VectorType;

/** The rules for torn springs and for birth and death of particles; {@link RuleCatalog#ALL} lists them. */
public final class BirthAndDeath {
    private BirthAndDeath() {
    }

    private static final Key<Double> STRAIN = NumberType.positive("").required("strain",
            "A spring tears at this strain, stretch divided by rest length: 0.5 means at 1.5 times its rest length.");

    public static final RuleKind TEAR = new RuleKind("tear", "Removes springs that are stretched too far.",
            (values, assembly) -> assembly.add(new SpringTear(assembly.springs(), values.get(STRAIN))), STRAIN);

    static final Key<String> ID = ParticleDescription.NEW_ID.required("id",
            "Its name, with which its particles' ids begin: fountain[0], fountain[1] ... It must differ from the"
            + " ids of particles and shapes.");
    private static final Key<Vector3> POSITION = VectorType.of("m").required("position",
            "The point where particles are born (m).");
    private static final Key<Double> RADIUS = NumberType.notNegative("m").withDefault("radius", 0.0,
            "The largest distance from that point at birth (m).");
    private static final Key<Vector3> DIRECTION = VectorType.notZero("").withDefault("direction", new Vector3(0, 1, 0),
            "The direction in which they start; its length does not matter.");
    private static final Key<Double> SPREAD = NumberType.between(0, 180, "degrees").withDefault("spread", 0.0,
            "The largest angle between a particle's velocity and the direction (degrees).");
    private static final Key<Double> SPEED = NumberType.notNegative("m/s").required("speed",
            "Their speed at birth (m/s).");
    static final Key<Double> RATE = NumberType.positive("1/s").required("rate",
            "The number of particles born per second (1/s).");
    private static final Key<Double> MASS = NumberType.positive("kg").withDefault("mass", 1.0,
            "The mass of each (kg).");
    static final Key<Double> LIFETIME = NumberType.positive("s").optional("lifetime",
            "The lifetime of each (s); unlimited if left out.");

    static final RuleKind EMITTER = new RuleKind("emitter", "A source of particles. A hard ball is born once there"
            + " is room for it.", (values, assembly) -> {
        double lifetime = values.find(LIFETIME).orElse(Double.POSITIVE_INFINITY);
        Emitter.Jet jet = new Emitter.Jet(values.get(POSITION), values.get(RADIUS), values.get(DIRECTION),
                StrictMath.toRadians(values.get(SPREAD)), values.get(SPEED));
        assembly.add(new Emitter(new Emitter.Nozzle(values.get(ID), jet, values.get(RATE), values.get(MASS),
                lifetime, values.get(SharedKeys.SEED)), assembly::getCollisions));
        if (lifetime < Double.POSITIVE_INFINITY) {
            assembly.letDie();
        }
        assembly.noteSpeed(values.get(SPEED));
        assembly.noteBirths(values.get(RATE) * values.get(MASS));
    }, ID, POSITION, RADIUS, DIRECTION, SPREAD, SPEED, RATE, MASS, LIFETIME, SharedKeys.SEED);

    private static final Key<Vector3> POINT = VectorType.of("m").required("point", "Any point of the plane (m).");
    private static final Key<Vector3> NORMAL = VectorType.notZero("").withDefault("normal", new Vector3(0, 1, 0),
            "A vector to the side where particles survive; its length does not matter.");

    public static final RuleKind KILL = new RuleKind("kill", "Removes particles that get behind a plane.",
            (values, assembly) -> assembly.add(Deaths.behind(new Plane(values.get(POINT), values.get(NORMAL)))),
            POINT, NORMAL);

    static final Key<String> SAMPLE_ID = ParticleDescription.NEW_ID.withDefault("id", "sample",
            "The ids of new particles begin with this name. It must differ from the ids of"
            + " particles, shapes and emitters.");
    private static final Key<Double> FARTHEST = NumberType.positive("m").required("farthest",
            "A particle with no other within this distance splits in two (m).");
    private static final Key<Double> CLOSEST = NumberType.between(0.01, 0.49, "").withDefault("closest", 0.3,
            "Two particles closer than this fraction of 'farthest' merge.");
    private static final Key<Double> LIGHTEST = NumberType.positive("kg").required("lightest",
            "No split makes a particle lighter than this (kg).");

    public static final RuleKind SAMPLES = new RuleKind("samples",
            "Merges and splits particles to keep them evenly spaced.",
            (values, assembly) -> assembly.add(new ParticleResampler(values.get(SAMPLE_ID), assembly.springs(),
                    values.get(FARTHEST) * values.get(CLOSEST), values.get(FARTHEST), values.get(LIGHTEST),
                    values.get(SharedKeys.SEED))),
            FARTHEST, CLOSEST, LIGHTEST, SAMPLE_ID, SharedKeys.SEED);
}
