package particles.teaching.sources;

import deSolvers.SecondOrderStateSource;

/** A source of positions and velocities in space, whose accelerations do not depend on velocities. */
interface SecondOrderSource extends SecondOrderStateSource {
    @Override
    default int getDimension() {
        return 3;
    }

    @Override
    default boolean accelerationDependsOnVelocity() {
        return false;
    }
}
