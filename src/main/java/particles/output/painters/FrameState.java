package particles.output.painters;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import particles.law.Particles;
import particles.law.Vector3;
import particles.output.raster.CameraProjection;
import particles.output.raster.CameraProjection.Place;
import particles.view.SpringList;

/**
 * A snapshot of a running simulation, so that a frame can be drawn in another thread.
 *
 * @param time      the simulated time (s)
 * @param state     the positions and velocities, in the layout of the system's state
 * @param structure the springs, and the particles apart from where they are
 * @param trail     earlier positions, the latest sample first
 * @param notes     the lines below the title; the first one is a warning
 */
public record FrameState(double time, double[] state, FrameStructure structure, List<TrailSample> trail,
        List<String> notes) {

    /** @return the number of particles */
    public int particles() {
        return structure.ids().length;
    }

    /** @return the springs and rods */
    public SpringList springs() {
        return structure.springs();
    }

    /** @return whether particle i is fixed */
    public boolean isFixed(int i) {
        return structure.fixed()[i];
    }

    /** @return the position of particle i (m) */
    public Vector3 place(int i) {
        return Vector3.at(state, Particles.STRIDE * i);
    }

    /** @return the velocity of particle i (m/s) */
    public Vector3 velocity(int i) {
        return Vector3.at(state, Particles.STRIDE * i + 3);
    }

    /** @return where a camera sees each particle */
    Place[] places(CameraProjection view) {
        return IntStream.range(0, particles()).mapToObj(i -> view.place(place(i))).toArray(Place[]::new);
    }

    /** @return where particle i was at the samples of the trail, back to the first one without it (m) */
    public List<Vector3> path(int i) {
        List<Vector3> path = new ArrayList<>();
        int at = i;
        for (TrailSample sample : trail) {
            at = sample.index(structure.ids()[i], at);
            if (at < 0) {
                break;
            }
            float[] places = sample.places();
            path.add(new Vector3(places[3 * at], places[3 * at + 1], places[3 * at + 2]));
        }
        return path;
    }
}
