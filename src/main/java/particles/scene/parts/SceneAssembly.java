package particles.scene.parts;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.ParticleSystem;
import particles.Rule;
import particles.effects.EffectContext;
import particles.effects.Wind;
import particles.effects.springs.SpringForce;
import particles.law.AnchorMotion;
import particles.law.Effect;
import particles.law.Obstacle;
import particles.law.Particles;
import particles.law.Plane;
import particles.law.Sphere;
import particles.law.Vector3;
import particles.reactions.ContactSurface;
import particles.rules.Collisions;
import particles.rules.Deaths;
import particles.view.Scenery;
import particles.view.Scenery.CurveView;
import particles.view.Scenery.Surface;

/** A scene under construction: effects and rules are added to it and share its wind, surfaces and totals. */
public final class SceneAssembly implements EffectContext {
    private final ParticleSystem system;
    private final SpringForce springs;
    private final ParticleIndex index;
    private final List<Rule> rules = new ArrayList<>();
    private boolean mortal;
    private double births;
    private final List<ContactSurface> surfaces = new ArrayList<>();
    private final List<Obstacle> solids = new ArrayList<>();
    private final List<CurveView> wires = new ArrayList<>();
    private Optional<Collisions.Balls> balls = Optional.empty();
    private Optional<Collisions> collisions = Optional.empty();
    private Wind wind = Wind.STILL;
    private Vector3 acceleration = Vector3.ZERO;
    private double speed;

    /** Starts with a system, its springs and the index of its particles. */
    public SceneAssembly(ParticleSystem system, SpringForce springs, ParticleIndex index) {
        this.system = system;
        this.springs = springs;
        this.index = index;
    }

    @Override
    public SpringForce springs() {
        return springs;
    }

    @Override
    public IntStream springs(String shape, String family, Optional<String> part) {
        return index.springs(shape, family, part);
    }

    @Override
    public Vector3 position(int particle) {
        return Vector3.at(system.getOwnState(), Particles.STRIDE * particle);
    }

    /** @return the initial position of the particle with this known id (m) */
    Vector3 positionOf(String id) {
        return index.position(id);
    }

    /** Turns the fixed particle with this known id into a moving anchor. */
    void move(String id, AnchorMotion motion) {
        system.moveAnchor(index.find(id).orElseThrow(), motion);
    }

    /** @param rule a rule that acts after contacts, in the order of the scene */
    void add(Rule rule) {
        rules.add(rule);
    }

    /** Adds the rule for lifetimes, once for any number of emitters. */
    void letDie() {
        mortal = true;
    }

    /** @return the rules besides contacts; the rule for lifetimes comes last */
    public List<Rule> rules() {
        List<Rule> all = new ArrayList<>(rules);
        if (mortal) {
            all.add(Deaths.ofAge());
        }
        return all;
    }

    /** @param massRate the mass of births per second (kg/s); for the energy scale */
    void noteBirths(double massRate) {
        births += massRate;
    }

    @Override
    public Particles particles() {
        return system.getParticles();
    }

    @Override
    public Optional<Double> ownRadius(int particle) {
        return index.particle(system.getParticles().id(particle)).radius();
    }

    @Override
    public Stream<Effect> effects() {
        return system.getEffects().stream();
    }

    @Override
    public void add(Effect effect) {
        system.addEffect(effect);
    }

    void set(Collisions.Balls balls) {
        this.balls = Optional.of(balls);
    }

    /** @param rule the rule for collisions */
    public void set(Collisions rule) {
        collisions = Optional.of(rule);
    }

    /** @return the law of impact, if particles are hard balls */
    public Optional<Collisions.Balls> getBalls() {
        return balls;
    }

    /** The rule for collisions, once it is built; empty if particles are points. */
    Optional<Collisions> getCollisions() {
        return collisions;
    }

    void add(ContactSurface surface) {
        surfaces.add(surface);
        show(surface.obstacle());
    }

    @Override
    public void show(Obstacle solid) {
        solids.add(solid);
    }

    /** @param wire a wire to be drawn */
    public void show(CurveView wire) {
        wires.add(wire);
    }

    /** @return everything to draw, with the given surfaces */
    public Scenery scenery(List<Surface> surfaces) {
        return new Scenery(surfaces, solids(Plane.class), solids(Sphere.class), wires);
    }

    private <T> List<T> solids(Class<T> type) {
        return solids.stream().filter(type::isInstance).map(type::cast).toList();
    }

    /** @return the surfaces of contact rules */
    public List<ContactSurface> getSurfaces() {
        return surfaces;
    }

    @Override
    public void setWind(Wind wind) {
        this.wind = wind;
    }

    @Override
    public Wind wind() {
        return wind;
    }

    @Override
    public void noteAcceleration(Vector3 g) {
        acceleration = acceleration.plus(g);
    }

    @Override
    public void noteSpeed(double fastest) {
        speed = Math.max(speed, fastest);
    }

    /**
     * @param duration the duration of the run (s), over 0
     * @return the kinetic energy to expect, by the system at its start and all that was noted (J), over 0
     */
    public double energyEstimate(double duration) {
        return new EnergyEstimate(system, duration).joules(acceleration, speed, births);
    }
}
