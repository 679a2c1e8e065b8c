package particles;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import particles.law.Particles;

/**
 * A smooth piece of motion: from the state at the beginning of a step to the state at its end, with the cubic Hermite
 * interpolation of the positions in between. Positions and velocities at both ends determine the cubic, so that a frame
 * between two steps needs no evaluation; its error is O(h<sup>4</sup>).
 *
 * <p>A step of an adaptive solver may be far too long for one cubic. It is recorded with the states between its
 * sub-steps: {@link #getPiece} is the motion in one of them.
 */
public final class Motion {
    /** The most numbers that the states between sub-steps may take: 16 MB. */
    private static final int MOST_NUMBERS = 1 << 21;

    private ParticleSystem system;
    private double startTime;
    private double endTime;
    private double[] startState = {};
    private double[] endState = {};
    private final List<Stop> stops = new ArrayList<>();  // between sub-steps, in the order of their times
    private int every;                                  // one in this many sub-steps is kept
    private int passed;                                 // sub-steps since the last one kept
    private boolean adaptive;

    private record Stop(double time, double[] state) {
    }

    void begin(ParticleSystem system) {
        int n = system.getStateSize();
        if (startState.length != n) {
            startState = new double[n];
            endState = new double[n];
        }
        this.system = system;
        System.arraycopy(system.getOwnState(), 0, startState, 0, n);
        startTime = system.getTime();
        stops.clear();
        every = 1;
        passed = 0;
        adaptive = false;
        system.record(Optional.of(this));
    }

    /** Stores the state after a sub-step. When the memory is full, every second state is dropped. */
    void addStop(double[] state, double time) {
        adaptive = true;
        if (++passed < every) {
            return;
        }
        passed = 0;
        stops.add(new Stop(time, state.clone()));
        if (stops.size() == 2 * Math.max(1, MOST_NUMBERS / 2 / Math.max(1, state.length))) {
            int half = stops.size() / 2;
            for (int k = 0; k < half; k++) {
                stops.set(k, stops.get(2 * k + 1));
            }
            stops.subList(half, 2 * half).clear();
            every *= 2;
        }
    }

    /** Ends the motion at the system's present state. It is called again if an earlier event is found. */
    void end() {
        system.record(Optional.empty());
        System.arraycopy(system.getOwnState(), 0, endState, 0, endState.length);
        endTime = system.getTime();
        stops.removeIf(stop -> stop.time >= endTime);
    }

    /** Shows the motion to the observers whose next time is within it. */
    void showTo(List<Observer> observers) {
        for (Observer observer : observers) {
            if (observer.getNextTime() <= endTime) {
                observer.moved(this);
            }
        }
    }

    /** @return the number of pieces: 1; for an adaptive solver one per sub-step, or per few if there are very many */
    public int getPieces() {
        return stops.size() + 1;
    }

    /** @return whether an adaptive solver made it, which keeps the error of each sub-step within a tolerance */
    public boolean isAdaptive() {
        return adaptive;
    }

    /**
     * @param k from 0 to {@link #getPieces()} - 1, in the order of time
     * @return the motion in one sub-step, or in a few consecutive ones; valid until the next step begins
     */
    public Motion getPiece(int k) {
        if (stops.isEmpty()) {
            return this;
        }
        Motion piece = new Motion();
        piece.system = system;
        piece.adaptive = adaptive;
        Stop start = k == 0 ? new Stop(startTime, startState) : stops.get(k - 1);
        Stop end = k == stops.size() ? new Stop(endTime, endState) : stops.get(k);
        piece.startTime = start.time;
        piece.startState = start.state;
        piece.endTime = end.time;
        piece.endState = end.state;
        return piece;
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
