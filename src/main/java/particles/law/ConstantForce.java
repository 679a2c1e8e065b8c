package particles.law;

/**
 * A force that depends on the particles alone, not on their state or the time, as gravity does. It is evaluated once,
 * and again after particles were added or removed; one that is named after a law that varies is evaluated each time, so
 * that sums keep their order.
 */
public interface ConstantForce extends PerParticleEffect {

    @Override
    default boolean dependsOnVelocity() {
        return false;
    }
}
