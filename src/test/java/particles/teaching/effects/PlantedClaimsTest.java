package particles.teaching.effects;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import particles.law.Effect;
import particles.law.Effect.Trait;
import particles.teaching.Finding;

/** Force laws whose force is right and whose account of it is not, and the other way round. */
class PlantedClaimsTest {

    /** What a law adds to one component of one particle's force. */
    private interface Component {
        double of(double[] state, int k);
    }

    /** The same law for every component of every velocity's place. */
    private static Effect law(Set<Trait> claims, boolean velocities, Component component,
            ToDoubleFunction<double[]> energy,
            ToDoubleFunction<double[]> heat) {
        return new Effect() {
            @Override
            public String getName() {
                return "planted";
            }

            @Override
            public Set<Trait> getTraits() {
                return claims;
            }

            @Override
            public boolean dependsOnVelocity() {
                return velocities;
            }

            @Override
            public void addForces(double[] state, double time, double[] force) {
                for (int k = 3; k < force.length; k += k % 6 == 5 ? 4 : 1) {
                    force[k] += component.of(state, k);
                }
            }

            @Override
            public double getPotentialEnergy(double[] state, double time) {
                return energy.applyAsDouble(state);
            }

            @Override
            public double getDissipatedPower(double[] state, double time) {
                return heat.applyAsDouble(state);
            }
        };
    }

    private static double squares(double[] state, int first) {
        double sum = 0;
        for (int k = first; k < state.length; k += k % 3 == 2 ? 4 : 1) {
            sum += state[k] * state[k];
        }
        return sum;
    }

    private static final Component DRAG = (state, k) -> -0.3 * state[k];
    private static final Component SPRING = (state, k) -> -4 * state[k - 3];
    private static final ToDoubleFunction<double[]> NONE = state -> 0;

    private static void assertFound(Effect effect, String... words) {
        List<String> found = EffectCheck.check(particles -> effect).stream()
                .map(Finding::toString).toList();
        assertEquals(words.length == 0 ? 0 : 1, found.size(), found.toString());
        for (String word : words) {
            assertTrue(found.get(0).contains(word), found.get(0) + " does not contain " + word);
        }
    }

    @Test
    void whatIsAccountedForIsRight() {
        assertFound(law(EnumSet.of(Trait.DISSIPATIVE), true, DRAG, NONE, state -> 0.3 * squares(state, 3)));
        assertFound(law(EnumSet.of(Trait.CONSERVATIVE), false, SPRING, state -> 2 * squares(state, 0), NONE));
    }

    @Test
    void noForceAtAll() {
        assertFound(law(EnumSet.allOf(Trait.class), true, (state, k) -> 0 * state[k], NONE, NONE),
                "not yet: there is no force on any particle");
    }

    /** The sample's first state is looked at when time is 0. */
    @Test
    void aPositionEntryIsWrittenLater() {
        assertFound(new Effect() {
            @Override
            public String getName() {
                return "planted";
            }

            @Override
            public void addForces(double[] state, double time, double[] force) {
                force[4] -= 1;
                force[0] += time > 1 ? 1 : 0;
            }
        }, "is written to entry 0, where the position stands");
    }

    /** The wall is far from where the sample's particles are, and pushes what comes to it. */
    @Test
    void whatActsFarAwayIsALaw() {
        assertFound(law(EnumSet.of(Trait.CONSERVATIVE), false, (state, k) -> wall(state, k), state -> {
            double sum = 0;
            for (int k = 3; k < state.length; k += 6) {
                sum += wall(state, k) * wall(state, k) / 2;
            }
            return sum;
        }, NONE));
    }

    private static double wall(double[] state, int k) {
        return k % 6 == 3 ? Math.max(0, -10 - state[k - 3]) : 0;
    }

    /** Symmetries are claims too, and say nothing of the power. */
    @Test
    void onlyASymmetryIsClaimed() {
        Component pull = (state, k) -> state[k % 3] - state[k - 3];
        assertFound(law(EnumSet.of(Trait.TRANSLATION_INVARIANT), false, pull, NONE, NONE),
                "style: it claims no account of its energy");
    }

    /** It takes 0.3 |v|^2, and says that it takes 0.6 |v|^2; the claim to drive leaves that to the sum of all. */
    @Test
    void powerThatIsAccountedForInPart() {
        assertFound(law(EnumSet.of(Trait.DISSIPATIVE, Trait.DRIVING), true, DRAG, NONE, state -> 0.6 * squares(state,
                3)),
                "a claim does not hold: power: the force does work at -", " W; accounted for are -",
                " W: getPotentialEnergy gives 0 W, getDissipatedPower takes ", " W and getDrivenPower adds 0 W");
    }

    @Test
    void anotherConstantInTheEnergy() {
        assertFound(law(EnumSet.of(Trait.CONSERVATIVE), false, SPRING, state -> 5 * squares(state, 0), NONE),
                "all of it is 2/5 times what it should be");
    }

    @Test
    void randomForces() {
        Random random = new Random(715);
        assertFound(law(EnumSet.noneOf(Trait.class), false, (state, k) -> random.nextDouble(), NONE, NONE),
                "two calls at the same state and time give different forces: something is random");
    }

    @Test
    void aStateThatIsWrittenInto() {
        assertFound(law(EnumSet.noneOf(Trait.class), false, (state, k) -> state[k]++, NONE, NONE),
                "addForces changes the state");
    }
}
