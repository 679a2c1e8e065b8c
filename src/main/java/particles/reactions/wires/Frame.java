package particles.reactions.wires;

import particles.law.Vector3;

/**
 * Three orthogonal unit vectors.
 *
 * @param axis   the given direction
 * @param first  across it
 * @param second across both
 */
record Frame(Vector3 axis, Vector3 first, Vector3 second) {

    /** Completes a direction, starting from the coordinate axis that is farthest from it. */
    static Frame around(Vector3 direction) {
        Vector3 axis = direction.normalized();
        double x = Math.abs(axis.x());
        double y = Math.abs(axis.y());
        double z = Math.abs(axis.z());
        Vector3 far = x <= y && x <= z ? new Vector3(1, 0, 0) : y <= z ? new Vector3(0, 1, 0) : new Vector3(0, 0, 1);
        Vector3 first = axis.cross(far).normalized();
        return new Frame(axis, first, axis.cross(first));
    }
}
