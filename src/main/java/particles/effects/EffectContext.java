package particles.effects;

import particles.law.Effect;
import particles.law.Obstacle;
import particles.law.Particles;
import particles.law.Vector3;

/** A scene that is being built, as an effect sees it. */
public interface EffectContext {

    /** @return the particles */
    Particles particles();

    /** @return how the air moves */
    Wind wind();

    /** @param effect a force to act on the particles */
    void add(Effect effect);

    /** @param wind how the air moves from now on */
    void setWind(Wind wind);

    /** @param solid a solid to be drawn */
    void show(Obstacle solid);

    /** @param g an acceleration that every particle feels (m/s&sup2;); for the scene's energy scale */
    void noteAcceleration(Vector3 g);

    /** @param speed a speed up to which particles are carried (m/s); for the scene's energy scale */
    void noteSpeed(double speed);
}
