package particles.effects;

import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.effects.springs.SpringForce;
import particles.law.Effect;
import particles.law.Obstacle;
import particles.law.Particles;
import particles.law.Vector3;

/** The scene under construction, as needed to build an effect. */
public interface EffectContext {

    /** @return the particles */
    Particles particles();

    /** @return the radius that the scene gives a particle's ball (m), if it gives any */
    default Optional<Double> ownRadius(int particle) {
        return Optional.empty();
    }

    /** @return where a particle is at the start (m) */
    Vector3 position(int particle);

    /** @return all springs */
    SpringForce springs();

    /**
     * @param shape  the id of a shape
     * @param family the name of a family of its springs, such as {@code structural}
     * @param part   a part of the shape, such as {@code top}, in which both ends have to be
     * @return the indices of its springs
     */
    IntStream springs(String shape, String family, Optional<String> part);

    /** @return the wind, {@link Wind#STILL} unless the scene has one */
    Wind wind();

    /** @return the forces that were added so far; here none */
    default Stream<Effect> effects() {
        return Stream.empty();
    }

    /** @param effect a force to act on the particles */
    void add(Effect effect);

    /** @param wind the wind for drag effects that are built after this */
    void setWind(Wind wind);

    /** @param solid a solid to be drawn */
    void show(Obstacle solid);

    /** @param g an acceleration of every particle (m/s&sup2;), used for the scene's energy scale */
    default void noteAcceleration(Vector3 g) {
    }

    /** @param speed a speed that particles may reach, in wind for example (m/s), used for the scene's energy scale */
    default void noteSpeed(double speed) {
    }
}
