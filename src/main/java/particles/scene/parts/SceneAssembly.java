package particles.scene.parts;

import java.util.ArrayList;
import java.util.Collections;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import particles.ParticleSystem;
import particles.Rule;
import particles.effects.EffectContext;
import particles.effects.Wind;
import particles.effects.springs.SpringForce;
import particles.law.AnchorMotion;
import particles.law.Effect;
import particles.law.Effect.Trait;
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
    private Wind wind = Wind.STILL;
    private Vector3 acceleration = Vector3.ZERO;
    private double speed;

    /** Starts with a system, its springs and the index of its particles. */
    public SceneAssembly(ParticleSystem system, SpringForce springs, ParticleIndex index) {
        this.system = system;
        this.springs = springs;
        this.index = index;
    }

    SpringForce getSprings() {
        return springs;
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
    public void add(Effect effect) {
        system.addEffect(effect);
    }

    void set(Collisions.Balls balls) {
        this.balls = Optional.of(balls);
    }

    /** @return the law of impact, if particles are hard balls */
    public Optional<Collisions.Balls> getBalls() {
        return balls;
    }

    /** @return the radius with which a particle touches solids (m); 0 for a point */
    double radius(int particle) {
        return balls.isPresent() ? balls.get().radii()[particle] : 0;
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
    void show(CurveView wire) {
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
     * Estimates the kinetic energy to expect, before the run; many times more means that it blew up. The estimate is
     * the largest of
     * <ul>
     * <li>kinetic energy plus the energy that springs and other forces store at the start;</li>
     * <li>the energy that gravity can supply: the sum of m g (H + g T&sup2;/2), with H the extent of all particles
     *     along g and T the duration, since everything may fall for as long as the run lasts;</li>
     * <li>the energy that wind, emitters and moving anchors can supply: the sum of m w&sup2;/2, with w the largest of
     *     their speeds, over all particles, including those born during the run;</li>
     * <li>the energy that laws without a declared energy can supply, as a student's own may be: the sum of F&sup2;
     *     T&sup2;/(2 m), with F the force at the start.</li>
     * </ul>
     * If all four are 0, nothing in the scene causes motion. The estimate is then the kinetic energy with which every
     * particle would cross the scene once during the run, the sum of m (L/T)&sup2;/2 with L the scene's extent, or 1 m
     * if that is 0. Fixed particles do not count, except for H and L; if all are fixed it is 1 J.
     *
     * @param duration the duration of the run (s), over 0
     * @return the estimate by the system at its start and all that was noted (J), over 0
     */
    public double energyEstimate(double duration) {
        double mass = particles().freeMass() + births * duration;
        if (mass == 0) {
            return 1;
        }
        double[] state = system.getOwnState();
        double[] ownForces = new double[state.length];
        double atStart = system.getKineticEnergy(state);
        for (Effect effect : system.getEffects()) {
            if (!Trait.isUniform(effect)) {
                atStart += Math.abs(effect.getPotentialEnergy(state, system.getTime()));
            }
            if (Collections.disjoint(effect.getTraits(), Trait.OF_ENERGY)) {
                effect.addForces(state, system.getTime(), ownForces);
            }
        }
        double g = acceleration.length();
        double height = acceleration.isZero() ? 0 : extent(acceleration.normalized());
        double byGravity = mass * g * (height + g * duration * duration / 2);
        double byWind = mass * speed * speed / 2;
        double byOwnLaws = particles().sumOfFree(i -> {
            Vector3 f = Vector3.at(ownForces, Particles.STRIDE * i + 3);
            return f.dot(f) * duration * duration / 2 * particles().getInverseMasses()[i];
        });
        double scale = Math.max(Math.max(atStart, byOwnLaws), Math.max(byGravity, byWind));
        return scale > 0 ? scale : crossing(mass, duration);
    }

    private double crossing(double mass, double duration) {
        double extent = Stream.of(new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1))
                .mapToDouble(this::extent).max().orElseThrow();
        double crossing = (extent > 0 ? extent : 1) / duration;
        return Math.max(Double.MIN_NORMAL, mass * crossing * crossing / 2);
    }

    private double extent(Vector3 direction) {
        DoubleSummaryStatistics along = particles().along(system.getOwnState(), direction);
        return along.getMax() - along.getMin();
    }
}
