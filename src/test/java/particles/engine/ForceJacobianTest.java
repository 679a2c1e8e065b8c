package particles.engine;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.addGravity;
import static particles.Systems.springs;

import deSolvers.implicit.ForceJacobian;
import deSolvers.linear.SolverWork;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import particles.ParticleSystem;
import particles.Systems;
import particles.effects.springs.SpringForce;
import particles.law.Effect;
import particles.law.Effect.Trait;
import particles.law.Obstacle;
import particles.law.Particles;
import particles.law.Plane;
import particles.law.Scales;
import particles.law.Sphere;
import particles.law.Vector3;
import particles.reactions.ContactModes.Mode;
import particles.reactions.ContactSurface;
import particles.reactions.ContactSurface.Friction;
import particles.reactions.RestingContacts;

/** The force derivatives of a particle system against central differences, on random systems. */
class ForceJacobianTest {
    private static final int N = 8;

    /** Random particles in a cube of 2 m, moving at up to 3 m/s, the first one fixed. */
    private static ParticleSystem particles(Random random) {
        ParticleSystem system = new ParticleSystem();
        for (int i = 0; i < N; i++) {
            Vector3 velocity = i == 0 ? Vector3.ZERO : vector(random, 3);
            system.addParticle("p" + i, 0.5 + random.nextDouble(), vector(random, 1), velocity, i == 0);
        }
        addGravity(system);
        return system;
    }

    private static Vector3 vector(Random random, double size) {
        return new Vector3(size * (2 * random.nextDouble() - 1), size * (2 * random.nextDouble() - 1),
                size * (2 * random.nextDouble() - 1));
    }

    private static void addSprings(ParticleSystem system, Random random, double damping) {
        SpringForce springs = springs(system);
        for (int i = 0; i < N; i++) {
            for (int j = 0; j < i; j++) {
                springs.addSpring(i, j, 100 * random.nextDouble(), 2 * random.nextDouble(), damping);
            }
        }
    }

    private static RestingContacts contacts(ParticleSystem system, Friction friction, Mode mode, Obstacle one,
            Obstacle other) {
        RestingContacts contacts = new RestingContacts(system,
                List.of(new ContactSurface("one", one, 0, friction, 0.01),
                new ContactSurface("other", other, 0, friction, 0.01)));
        for (int i = 0; i < N; i++) {
            contacts.getContacts().getModes().set(0, i, i % 3 == 0 ? Mode.FREE : mode);
            contacts.getContacts().getModes().set(1, i, i % 2 == 0 ? Mode.FREE : mode);
        }
        system.addReaction(contacts);
        return contacts;
    }

    /** Gives scales to all particles but the first two; the axis of the third begins at the fixed one. */
    private static void addScales(ParticleSystem system) {
        Scales[] scales = new Scales[N];
        for (int i = 2; i < N; i++) {
            scales[i] = new Scales(i == 2 ? 0 : i - 1, i, 0.6, 2.5, 1.5);
        }
        ((RestingContacts) system.getReactions().get(0)).getContacts().setScales(scales);
    }

    /** J w by central differences, from Richardson's extrapolation of two. */
    private static double[] differences(ParticleSystem system, double[] w) {
        double[] result = new double[w.length];
        double[] half = difference(system, w, 2e-4);
        double[] whole = difference(system, w, 4e-4);
        for (int i = 0; i < w.length; i++) {
            result[i] = (4 * half[i] - whole[i]) / 3;
        }
        return result;
    }

    private static double[] difference(ParticleSystem system, double[] w, double delta) {
        double[] state = new double[w.length];
        double[] ahead = new double[w.length];
        double[] behind = new double[w.length];
        system.getState(state);
        double[] moved = new double[w.length];
        for (int sign = -1; sign <= 1; sign += 2) {
            for (int i = 0; i < w.length; i++) {
                moved[i] = state[i] + sign * delta * w[i];
            }
            system.setState(moved);
            system.getStateDerivative(sign < 0 ? behind : ahead);
        }
        system.setState(state);
        for (int i = 0; i < w.length; i++) {
            ahead[i] = (ahead[i] - behind[i]) / (2 * delta);
        }
        return ahead;
    }

    /** J w by the force derivatives, of particles that can move. */
    private static double[] product(ParticleSystem system, double... w) {
        ForceJacobian jacobian = new ForceJacobian(new SolverWork(), w.length, system::getStateDerivative);
        double[] slope = new double[w.length];
        system.getStateDerivative(slope);
        jacobian.setUp(system, system.getOwnState(), slope, false);
        double[] force = new double[w.length / 2];
        jacobian.multiply(coordinates(w, 0), coordinates(w, 3), force);
        double[] product = new double[w.length];
        for (int i = 0; i < force.length; i++) {
            int x = 6 * (i / 3) + i % 3;
            product[x] = w[x + 3];
            product[x + 3] = force[i] * system.getInverseMass(i / 3);
        }
        return product;
    }

    private static double[] coordinates(double[] w, int from) {
        return IntStream.range(0, w.length / 2).mapToDouble(i -> w[6 * (i / 3) + i % 3 + from]).toArray();
    }

    private static double deviation(ParticleSystem system, Random random) {
        double[] w = random.doubles(6 * N, -1, 1).toArray();
        Arrays.fill(w, 0, 6, 0);                        // the first particle is fixed
        double[] before = new double[6 * N];
        double[] after = new double[6 * N];
        system.getState(before);
        double[] product = product(system, w);
        system.getState(after);
        assertArrayEquals(before, after, "the state stays");
        double[] expected = differences(system, w);
        double deviation = 0;
        double size = 0;
        for (int i = 0; i < 6 * N; i++) {
            deviation = Math.max(deviation, Math.abs(product[i] - expected[i]));
            size = Math.max(size, Math.abs(expected[i]));
        }
        return deviation / size;
    }

    /**
     * With springs, on two planes; on a ball and in a hollow, where the normal turns; sliding on, turned round within
     * the step, from rest, and where friction stops a particle within the step.
     */
    @ParameterizedTest
    @EnumSource(Friction.Law.class)
    void contactIsExact(Friction.Law law) {
        Obstacle[][] pairs = {{Plane.ground(0), new Plane(Vector3.ZERO, new Vector3(1, 1, 0.5))},
            {new Sphere(new Vector3(0.2, -2, 0.1), 2, false), new Sphere(new Vector3(-0.3, 2.5, 0), 3, true)}};
        for (int k = 0; k < 240; k++) {
            Random random = new Random(k / 8);
            ParticleSystem system = particles(random);
            addSprings(system, random, k % 3 == 0 ? 20 : 0.5);
            RestingContacts contacts = contacts(system, new Friction(law, 0.3, 0.4, 1e-3),
                    k % 2 == 0 ? Mode.SLIDING : Mode.STICKING, pairs[k / 4 % 2][0], pairs[k / 4 % 2][1]);
            // where contacts may pull, there is no friction
            contacts.getContacts().setHolding(k / 2 % 2 == 0 && k / 8 % 4 < 2);
            if (k % 5 < 2) {
                addScales(system);
            }
            begin(system, contacts, k / 8 % 4, random);
            assertTrue(system.hasExactJacobian());
            assertBelow(1e-10, deviation(system, random), "case " + k);         // measured 6.5e-11, of differences
        }
    }

    /** Begins a step, in which particles have then slid on or turned round, or started from rest, or may stop. */
    private static void begin(ParticleSystem system, RestingContacts contacts, int how, Random random) {
        double[] state = system.getOwnState();
        double[] now = state.clone();
        for (int v = 9; v < state.length && how > 0; v += 6) {
            for (int c = v; c < v + 3; c++) {
                state[c] = how == 2 ? 0 : state[c] + 3 * random.nextGaussian();
            }
        }
        if (how > 0) {
            contacts.getContacts().beginStep();
        }
        for (int i = 1; i < N && how == 3; i++) {
            contacts.getContacts().stopAfter(i, 0.01 + random.nextDouble());
        }
        System.arraycopy(now, 0, state, 0, state.length);
    }

    /** With an effect without known derivatives, products are differences, and blocks are those of the others. */
    @Test
    void anEffectWithoutDerivativesIsDifferentiatedNumerically() {
        for (int seed = 0; seed < 30; seed++) {
            Random random = new Random(seed);
            ParticleSystem system = particles(random);
            addSprings(system, random, 0.5);
            system.addEffect(new CubicDrag(system.getParticles()));
            assertFalse(system.hasExactJacobian());
            assertTrue(deviation(system, random) < 1e-5, "seed " + seed);       // measured 1.4e-6: half the digits
        }
    }

    /** An inactive reaction leaves the blocks exact. */
    @Test
    void aReactionThatIsNotActiveDoesNotMatter() {
        ParticleSystem system = particles(new Random(1));
        RestingContacts contacts = new RestingContacts(system, List.of());
        system.addReaction(contacts);
        assertFalse(contacts.isActive());
        assertTrue(system.hasExactJacobian());
    }

    /** A spring of length 0 counts as one of rest length 0, and all lengths give finite blocks. */
    @Test
    void springsOfAnyLengthHaveFiniteBlocks() {
        for (double length : new double[] {0, 1e-300, 1e-139, 1e-100, 1, 1e100, 1e150, 1e300}) {
            ParticleSystem system = Systems.row(2);
            system.getOwnState()[6] = length;
            SpringForce springs = springs(system);
            springs.addSpring(0, 1, 3, 0, 0.5);
            assertArrayEquals(new double[] {0, 0, 0, -3, 0, 0, 0, 0, 0, 3, 0, 0},
                    product(system, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), "length " + length);
            assertArrayEquals(new double[] {0, 0, 0, 0, 0, -3, 0, 0, 0, 0, 0, 3},
                    product(system, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0), "length " + length);
        }
    }

    /** F = -|v|^2 v, without its derivative. */
    private record CubicDrag(Particles particles) implements Effect {
        @Override
        public String getName() {
            return "cubic drag";
        }

        @Override
        public Set<Trait> getTraits() {
            return Set.of(Trait.DISSIPATIVE);
        }

        @Override
        public void addForces(double[] state, double time, double[] force) {
            for (int v = 3; v < force.length; v += Particles.STRIDE) {
                double square = state[v] * state[v] + state[v + 1] * state[v + 1] + state[v + 2] * state[v + 2];
                for (int c = v; c < v + 3; c++) {
                    force[c] -= square * state[c];
                }
            }
        }

        @Override
        public boolean dependsOnVelocity() {
            return true;
        }
    }
}
