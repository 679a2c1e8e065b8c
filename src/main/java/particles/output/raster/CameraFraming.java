package particles.output.raster;

import java.util.List;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.law.Plane;
import particles.law.Vector3;
import particles.view.Camera;

/**
 * Places a default camera: a little from above and from the right, as near as possible with everything in the picture.
 */
public final class CameraFraming {
    private static final double FIELD_OF_VIEW = 35;
    /** The fraction of the picture for the scene; the corners are for text. */
    private static final double FILLED = 0.74;
    /** A scene thinner along an axis than this fraction of its largest extent is flat and seen from the front. */
    private static final double FLAT = 0.05;
    private static final Vector3 UP = new Vector3(0, 1, 0);
    private static final Vector3 FROM_THE_SIDE = new Vector3(0.55, 0.42, 1);
    private static final Vector3 FROM_THE_FRONT = new Vector3(0.22, 0.16, 1);

    private CameraFraming() {
    }

    /**
     * Frames a system at its start with room for its motion: hanging particles may swing around fixed ones, and others
     * may fall to a plane.
     *
     * @param system the system at its start
     * @param planes the ground and other planes
     * @param aspect the width of the pictures divided by their height
     * @return a perspective camera
     */
    public static Camera around(ParticleSystem system, List<Plane> planes, double aspect) {
        Particles particles = system.getParticles();
        double[] state = system.getOwnState();
        Bounds bounds = new Bounds();
        Bounds pegs = new Bounds();
        for (int i = 0, x = 0; i < particles.count(); i++, x += Particles.STRIDE) {
            Vector3 place = new Vector3(state[x], state[x + 1], state[x + 2]);
            bounds.add(place);
            if (particles.isFixed(i)) {
                pegs.add(place);
            }
            for (Plane plane : planes) {
                bounds.add(place.minus(plane.normal().times(plane.distance(place.x(), place.y(), place.z()))));
            }
        }
        if (!pegs.isEmpty()) {
            Vector3 middle = pegs.middle();
            double reach = 0;
            for (int i = 0, x = 0; i < particles.count(); i++, x += Particles.STRIDE) {
                Vector3 place = new Vector3(state[x], state[x + 1], state[x + 2]);
                reach = Math.max(reach, place.minus(middle).length());
            }
            boolean flat = bounds.high.z() - bounds.low.z() <= FLAT * reach;
            bounds.add(middle.plus(new Vector3(reach, 0, 0)));
            bounds.add(middle.minus(new Vector3(reach, reach, flat ? 0 : reach / 2)));
        }
        return bounds.isEmpty() ? around(Vector3.ZERO, Vector3.ZERO, aspect) : around(bounds.low, bounds.high, aspect);
    }

    /**
     * Frames a box.
     *
     * @param low    its lower corner (m)
     * @param high   its upper corner (m)
     * @param aspect the width of the pictures divided by their height
     * @return a perspective camera
     */
    public static Camera around(Vector3 low, Vector3 high, double aspect) {
        Vector3 size = high.minus(low);
        Vector3 middle = low.plus(size.times(0.5));
        double largest = Math.max(size.x(), Math.max(size.y(), size.z()));
        if (!(largest > 0) || !(largest <= 1e100)) {
            largest = 1;
            size = new Vector3(1, 1, 1);
        }
        Vector3 from = (size.z() <= FLAT * largest ? FROM_THE_FRONT : FROM_THE_SIDE).normalized();
        double near = 0.1 * largest;
        double far = 100 * largest / Math.min(1, aspect);
        for (int halving = 0; halving < 60; halving++) {
            double middleWay = (near + far) / 2;
            if (fits(camera(middle, from, middleWay), middle, size, aspect)) {
                far = middleWay;
            } else {
                near = middleWay;
            }
        }
        return camera(middle, from, far);
    }

    private static Camera camera(Vector3 target, Vector3 from, double distance) {
        return new Camera(target.plus(from.times(distance)), target, UP, true, FIELD_OF_VIEW, 0);
    }

    private static boolean fits(Camera camera, Vector3 middle, Vector3 size, double aspect) {
        int height = 1000;
        CameraProjection view = new CameraProjection(camera, (int) Math.ceil(aspect * height), height);
        for (int corner = 0; corner < 8; corner++) {
            double x = middle.x() + size.x() * ((corner & 1) - 0.5);
            double y = middle.y() + size.y() * ((corner >> 1 & 1) - 0.5);
            double z = middle.z() + size.z() * ((corner >> 2 & 1) - 0.5);
            double depth = view.depth(x, y, z);
            double scale = view.scale(depth);
            boolean inside = view.isInFront(depth)
                    && Math.abs(2 * view.x(x, y, z, scale) / view.width - 1) <= FILLED
                    && Math.abs(2 * view.y(x, y, z, scale) / view.height - 1) <= FILLED;
            if (!inside) {
                return false;
            }
        }
        return true;
    }

    /** A box that grows. */
    private static final class Bounds {
        private Vector3 low = new Vector3(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
        private Vector3 high = low.times(-1);

        void add(Vector3 p) {
            low = new Vector3(Math.min(low.x(), p.x()), Math.min(low.y(), p.y()), Math.min(low.z(), p.z()));
            high = new Vector3(Math.max(high.x(), p.x()), Math.max(high.y(), p.y()), Math.max(high.z(), p.z()));
        }

        boolean isEmpty() {
            return low.x() > high.x();
        }

        Vector3 middle() {
            return low.plus(high).times(0.5);
        }
    }
}
