package particles.law;

/** The prescribed motion of a moving anchor: a shaken hand, a turning crank. */
public interface AnchorMotion {

    /**
     * Writes the position, velocity and acceleration of the anchor at a time.
     *
     * @param time   t (s)
     * @param values receives nine numbers: position (m), its first derivative (m/s) and its second (m/s&sup2;)
     */
    void at(double time, double[] values);
}
