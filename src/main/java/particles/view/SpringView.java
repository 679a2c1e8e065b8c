package particles.view;

/** Read-only view of springs, for pictures and messages. */
public interface SpringView {
    /** @return the number of springs */
    int springCount();

    /** @return the index of the particle at the first end of spring s */
    int from(int s);

    /** @return the index of the particle at the second end of spring s */
    int to(int s);

    /** @return the length at which spring s exerts no force (m) */
    double restLength(int s);

    /** @return the force per unit of stretch of spring s (N/m) */
    double stiffness(int s);

    /** @return the force per unit of stretching rate of spring s (N s/m) */
    double damping(int s);
}
