package particles.scene;

import java.util.ArrayList;
import java.util.List;
import particles.Effect;
import particles.ParticleSystem;
import particles.Particles;
import particles.Vector3;
import particles.effects.Wind;
import particles.reactions.ContactPlane;

/** A scene's system while effects and rules are being added to it, and what they share. */
final class SceneAssembly {
    private final ParticleSystem system;
    private final List<ContactPlane> planes = new ArrayList<>();
    private Wind wind = Wind.STILL;
    private Vector3 acceleration = Vector3.ZERO;
    private double speed;

    SceneAssembly(ParticleSystem system) {
        this.system = system;
    }

    Particles particles() {
        return system.getParticles();
    }

    void add(Effect effect) {
        system.addEffect(effect);
    }

    void add(ContactPlane plane) {
        planes.add(plane);
    }

    List<ContactPlane> planes() {
        return planes;
    }

    /** @param moving the wind that drag is to ask */
    void blow(Wind moving) {
        wind = moving;
    }

    Wind wind() {
        return wind;
    }

    /** @param g an acceleration that every particle feels (m/s&sup2;); for the energy scale */
    void noteAcceleration(Vector3 g) {
        acceleration = acceleration.plus(g);
    }

    Vector3 acceleration() {
        return acceleration;
    }

    /** @param fastest a speed up to which particles are carried (m/s); for the energy scale */
    void noteSpeed(double fastest) {
        speed = Math.max(speed, fastest);
    }

    double speed() {
        return speed;
    }
}
