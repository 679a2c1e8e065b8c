package particles;

import particles.law.Particles;

/**
 * A smooth piece of motion: from the state at the beginning of a step to the state at its end, with the cubic Hermite
 * interpolation of the positions in between. Positions and velocities at both ends determine the cubic, so that a frame
 * between two steps needs no evaluation; its error is O(h<sup>4</sup>).
 */
public final class Motion {
    private ParticleSystem system;
    private double startTime;
    private double endTime;
    private double[] startState = {};
    private double[] endState = {};

    void begin(ParticleSystem system) {
        int n = system.getStateSize();
        if (startState.length != n) {
            startState = new double[n];
            endState = new double[n];
        }
        this.system = system;
        System.arraycopy(system.getOwnState(), 0, startState, 0, n);
        startTime = system.getTime();
    }

    void end() {
        System.arraycopy(system.getOwnState(), 0, endState, 0, endState.length);
        endTime = system.getTime();
    }

    /** @return the system that moved; its state is the end of the motion */
    public ParticleSystem getSystem() {
        return system;
    }

    /** @return the time at the beginning (s) */
    public double getStartTime() {
        return startTime;
    }

    /** @return the time at the end (s) */
    public double getEndTime() {
        return endTime;
    }

    /** @return the state at the beginning; read only, valid until the next step begins */
    public double[] getStartState() {
        return startState;
    }

    /** @return the state at the end, before any rule acted; read only, valid until the next step begins */
    public double[] getEndState() {
        return endState;
    }

    /**
     * Interpolates the state: positions by the cubic, velocities by its derivative.
     *
     * @param time  from {@link #getStartTime()} to {@link #getEndTime()} (s)
     * @param state receives the state; of the system's state size
     */
    public void interpolate(double time, double[] state) {
        double h = endTime - startTime;
        if (time >= endTime || h == 0) {
            System.arraycopy(endState, 0, state, 0, endState.length);
            return;
        }
        if (time <= startTime) {
            System.arraycopy(startState, 0, state, 0, startState.length);
            return;
        }
        double u = (time - startTime) / h;
        double rise = u * u * (3 - 2 * u);              // Hermite basis: from 0 to 1, slope 0 at both ends
        double out = u * (1 - u) * (1 - u) * h;         // slope 1 at the beginning
        double in = u * u * (u - 1) * h;                // slope 1 at the end
        double riseRate = 6 * u * (1 - u) / h;
        double outRate = (1 - u) * (1 - 3 * u);
        double inRate = u * (3 * u - 2);
        for (int x = 0; x < endState.length; x += Particles.STRIDE) {
            for (int c = x; c < x + 3; c++) {
                double way = endState[c] - startState[c];
                double v0 = startState[c + 3];
                double v1 = endState[c + 3];
                state[c] = startState[c] + rise * way + out * v0 + in * v1;
                state[c + 3] = riseRate * way + outRate * v0 + inRate * v1;
            }
        }
    }
}
