package particles;

import deSolvers.DESolver;
import deSolvers.problems.Steps;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import particles.effects.springs.SpringForce;
import particles.law.Vector3;

/**
 * A random mass-spring system as plain numbers that can be printed, changed and shrunk.
 *
 * @param balls   at least two
 * @param springs springs between balls; those with equal ends are left out
 */
record RandomSystem(List<Ball> balls, List<Spring> springs) {

    /**
     * @param mass     kg
     * @param position m
     * @param velocity m/s
     */
    record Ball(double mass, Vector3 position, Vector3 velocity) {
    }

    /**
     * @param from       index of a ball, modulo their number
     * @param to         index of another
     * @param stiffness  N/m
     * @param restLength m
     * @param damping    N s/m
     */
    record Spring(int from, int to, double stiffness, double restLength, double damping) {
    }

    private static Arbitrary<Double> numbers(double least, double most) {
        return Arbitraries.doubles().between(least, most).ofScale(2);
    }

    private static Arbitrary<Vector3> vectors(double size) {
        return Combinators.combine(numbers(-size, size), numbers(-size, size), numbers(-size, size)).as(Vector3::new);
    }

    /** @param damping the largest damping of springs (N s/m); the fastest oscillation has omega of about 100/s */
    static Arbitrary<RandomSystem> any(double damping) {
        Arbitrary<Ball> ball = Combinators.combine(numbers(0.1, 10), vectors(2), vectors(1)).as(Ball::new);
        Arbitrary<Spring> spring = Combinators.combine(Arbitraries.integers().between(0, 7),
                Arbitraries.integers().between(0, 7),
                numbers(0, 100), numbers(0, 2), numbers(0, damping)).as(Spring::new);
        return Combinators.combine(ball.list().ofMinSize(2).ofMaxSize(6),
                spring.list().ofMaxSize(10)).as(RandomSystem::new)
                .filter(RandomSystem::isSpread);
    }

    /** Whether all balls begin well apart: a spring's force has a kink at length 0. */
    private boolean isSpread() {
        for (int i = 0; i < balls.size(); i++) {
            for (int j = 0; j < i; j++) {
                if (balls.get(i).position().minus(balls.get(j).position()).length() < 0.5) {
                    return false;
                }
            }
        }
        return true;
    }

    ParticleSystem build() {
        ParticleSystem system = new ParticleSystem();
        for (int i = 0; i < balls.size(); i++) {
            Ball ball = balls.get(i);
            system.addParticle("ball" + i, ball.mass(), ball.position(), ball.velocity(), false);
        }
        SpringForce force = Systems.springs(system);
        for (Spring spring : springs) {
            int from = spring.from() % balls.size();
            int to = spring.to() % balls.size();
            if (from != to) {
                force.addSpring(from, to, spring.stiffness(), spring.restLength(), spring.damping());
            }
        }
        return system;
    }

    /** The same system with each ball changed. */
    RandomSystem with(UnaryOperator<Ball> change) {
        return new RandomSystem(balls.stream().map(change).toList(), springs);
    }

    /** Returns the same system with ball i at place[i] and the springs in the opposite order. */
    RandomSystem permuted(int[] place) {
        List<Ball> moved = new ArrayList<>(balls);
        for (int i = 0; i < place.length; i++) {
            moved.set(place[i], balls.get(i));
        }
        List<Spring> turned = new ArrayList<>();
        for (Spring s : springs) {
            turned.add(0, new Spring(place[s.from() % place.length], place[s.to() % place.length], s.stiffness(),
                    s.restLength(),
                    s.damping()));
        }
        return new RandomSystem(moved, turned);
    }

    /** The state after some steps. */
    static double[] run(ParticleSystem system, DESolver solver, double deltaT, int steps) {
        Steps.make(steps, solver, system, deltaT);
        return system.getStateArray().clone();
    }
}
