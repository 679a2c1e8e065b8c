package particles.effects.springs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import particles.ParticleSystem;
import particles.law.Vector3;

/** Against the closed form of the fixed-fixed chain, omega = 2 sqrt(k/m) sin(n pi / (2 (n + 1))). */
class SpringRatesTest {
    private final ParticleSystem system = new ParticleSystem();
    private final SpringForce springs = new SpringForce(system.getParticles());

    private SpringRates chain(int n, double mass, double stiffness, double damping) {
        for (int i = 0; i < n + 2; i++) {
            boolean end = i == 0 || i == n + 1;
            system.addParticle("p" + i, end ? 1e-9 : mass, new Vector3(i, 0, 0), Vector3.ZERO, end);
            if (i > 0) {
                springs.addSpring(i - 1, i, stiffness, 1, damping);
            }
        }
        return SpringRates.of(springs, system.getParticles());
    }

    @Test
    void theBoundOfAChainIsSafeAndNear() {
        SpringRates rates = chain(100, 4, 100, 0);
        double exact = 2 * 5 * Math.sin(100 * Math.PI / 202);       // 9.9988
        assertTrue(rates.omega() >= exact && rates.omega() <= 1.001 * exact, rates.omega() + " for " + exact);
        assertEquals(rates.omega(), rates.fastest(0));
    }

    @Test
    void aSingleMassBetweenTwoWallsIsExact() {
        SpringRates rates = chain(1, 2, 100, 6);
        assertEquals(10, rates.omega(), 1e-14);                     // 2 k / m = 100
        assertEquals(6, rates.dampingRate(), 1e-14);                // 2 k_d / m
        assertEquals(3 + Math.sqrt(109), rates.fastest(0), 1e-13);
        assertEquals(5 + Math.sqrt(125), rates.fastest(4), 1e-13);
    }

    @Test
    void nothingPullsAtAnything() {
        system.addParticle("a", 1, Vector3.ZERO, Vector3.ZERO, true);
        system.addParticle("b", 1, new Vector3(1, 0, 0), Vector3.ZERO, true);
        springs.addSpring(0, 1, 5, 1, 0);
        assertEquals(new SpringRates(-1, 0, 0), SpringRates.of(springs, system.getParticles()));
    }
}
