package particles.teaching.effects;

import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;
import particles.ParticleSystem;
import particles.law.Effect;
import particles.law.Effect.Trait;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;

/**
 * Finds a force whose direction contradicts the law's name or description. If the energy has the wrong sign too, no
 * other check notices it.
 */
final class NamedDirection {
    private static final double FAR = 100;
    private static final double[] NEARER = {10, 3, 1};
    private static final double FAST = 100;
    private static final double BELOW = -2;
    private static final Pattern DOWN = Pattern.compile("gravity|weight");
    private static final Pattern FLOOR = Pattern.compile("floor|(?<!back)ground");
    private static final Pattern SPRING = Pattern.compile("spring|hooke|elastic|rubber|tether|bungee");
    private static final Pattern TOWARDS = Pattern.compile("attract|gravit|pulls? [a-z ]*(towards?|together)");
    private static final Pattern AWAY = Pattern.compile("repel|repuls|away from|apart|centrifugal");
    private static final Pattern AGAINST = Pattern.compile("drag|friction|damp|viscous|viscosity|resist|brake");
    private static final Pattern TURNED = Pattern.compile("anti|negative|invers|revers");

    private final ParticleSystem system;
    private final Effect effect;
    private final boolean signed;
    private final String words;
    private final double[] start;
    private final int n;

    private NamedDirection(ParticleSystem system, Effect effect, EffectLaw law, double[] state) {
        this.system = system;
        this.effect = effect;
        signed = law.signed();
        words = (effect.getName() + " " + effect.getClass().getSimpleName() + " " + law.sentence())
                .toLowerCase(Locale.ROOT);
        start = state;
        n = state.length;
    }

    /**
     * @param system the particles
     * @param effect the effect, made for them
     * @param law    the law, with its description
     * @param state  a state with positions and velocities of order 1
     * @return the mistake; empty if the force has the direction that the words say, or they say nothing
     */
    static Optional<Finding> finding(ParticleSystem system, Effect effect, EffectLaw law, double[] state) {
        NamedDirection named = new NamedDirection(system, effect, law, state);
        return TURNED.matcher(named.words).find() ? Optional.empty() : named.wrong().map(text
                -> new Finding(Kind.METHOD, text + ": the sign is wrong, in the force"
                + (effect.getTraits().contains(Trait.CONSERVATIVE) ? " and in the potential energy" : "")));
    }

    private boolean says(Pattern meaning) {
        return meaning.matcher(words).find();
    }

    private Optional<String> wrong() {
        boolean uniform = isUniform();
        if (says(DOWN) && uniform && !signed && total(force(at(1, 0)), 1) > 0) {
            return Optional.of("gravity pulls down, and this force points up");
        }
        if (says(FLOOR) && !signed && total(force(below()), 1) < 0) {
            return Optional.of("a floor pushes up what is below it, and this force pulls it further down");
        }
        boolean away = says(AWAY);
        boolean spring = says(SPRING);
        if ((spring || says(TOWARDS)) && !away && !uniform && outwards() > 0) {
            return Optional.of(spring ? "a spring pulls back when it is stretched, and this force pushes further apart"
                    : "what attracts pulls closer, and this force pushes away");
        }
        if (away && !spring && !says(TOWARDS) && !uniform && outwards() < 0) {
            return Optional.of("what repels pushes apart, and this force pulls closer");
        }
        return says(AGAINST) && powerOfSpeed() > 0
                ? Optional.of("damping pushes against the velocity, and this force along it") : Optional.empty();
    }

    private double[] force(double[] at) {
        double[] force = new double[n];
        effect.addForces(at, 0, force);
        return force;
    }

    /** @return the state with all positions and all velocities multiplied */
    private double[] at(double positions, double velocities) {
        double[] state = start.clone();
        for (int k = 0; k < n; k++) {
            state[k] *= k % 6 < 3 ? positions : velocities;
        }
        return state;
    }

    private double[] below() {
        double[] state = at(1, 0);
        for (int y = 1; y < n; y += 6) {
            state[y] = BELOW;
        }
        return state;
    }

    private static double total(double[] force, int axis) {
        double total = 0;
        for (int k = 3 + axis; k < force.length; k += 6) {
            total += force[k];
        }
        return total;
    }

    private boolean isUniform() {
        double[] near = force(at(1, 0));
        double[] far = force(at(FAR, 0));
        for (int k = 0; k < n; k++) {
            if (Math.abs(near[k] - far[k]) > 1e-9 * Math.abs(near[k])) {
                return false;
            }
        }
        return true;
    }

    /** The sum of F . x, far out or, of pairs that only reach less far, as far as they do. */
    private double outwards() {
        double sum = outwards(FAR);
        boolean internal = effect.getTraits().contains(Trait.INTERNAL);
        for (int k = 0; sum == 0 && internal && k < NEARER.length; k++) {
            sum = outwards(NEARER[k]);
        }
        return sum;
    }

    private double outwards(double scale) {
        double[] state = at(scale, 0);
        double[] force = force(state);
        double sum = 0;
        for (int k = 0; k < n; k += k % 6 == 2 ? 4 : 1) {
            sum += system.getParticles().isFixed(k / 6) ? 0 : force[k + 3] * state[k];
        }
        return sum;
    }

    /** The power of the velocity-dependent part of the force in fast motion. */
    private double powerOfSpeed() {
        double[] fast = at(1, FAST);
        double[] force = force(fast);
        double[] rest = force(at(1, 0));
        double sum = 0;
        for (int k = 3; k < n; k += k % 6 == 5 ? 4 : 1) {
            sum += (force[k] - rest[k]) * fast[k];
        }
        return sum;
    }
}
