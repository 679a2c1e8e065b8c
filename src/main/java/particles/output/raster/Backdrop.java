package particles.output.raster;

import deSolvers.text.Digits;
import java.util.List;
import java.util.Optional;
import particles.law.Plane;
import particles.law.Sphere;
import particles.law.Vector3;
import particles.output.raster.CameraProjection.Ray;
import particles.view.Camera;
import particles.view.Scenery;

/**
 * The background of a frame: sky, the scene's planes with grid and shadows, and its spheres. All but the shadows is
 * computed once for a camera. A plane is drawn if the camera is on its outer side. It is moved inwards by the radius of
 * a ball, since the centre of a resting ball is on the plane, so that the drawn ball touches it.
 */
public final class Backdrop {
    private static final float DARKEST_SHADOW = 0.56f;
    /** About this many grid lines in the height of the picture. */
    private static final double LINES = 7;
    /** The widths of grid lines, as parts of their distance. */
    private static final double THIN = 0.016;
    private static final double THICK = 0.034;
    /** Planes fade into the haze within this many heights of the picture. */
    private static final double HAZE = 5;
    /** The column of the shadow map at a pixel without shadows. */
    static final float NO_SHADOWS = -1;

    private final CameraProjection view;
    private final Lighting lighting;
    private final CameraProjection lampView;
    private final Vector3 target;
    private final Vector3 up;
    private final Sky sky;
    /** Those in view. */
    private final List<Plane> planes;
    /** The spacing of grid lines (m). */
    private final double spacing;
    final int width;
    private final int[] colour;
    private final float[] near;
    /** The places of pixels in the shadow map. */
    private final float[] column;
    private final float[] row;

    /** Paints the parts that are the same in every frame; {@code inset} is the radius of a ball (m). */
    public Backdrop(CameraProjection view, Lighting lighting, Scenery scenery, Sky sky, Camera camera, double inset) {
        this.view = view;
        this.lighting = lighting;
        target = camera.target();
        up = camera.up().normalized();
        this.sky = sky;
        int n = view.width * view.height;
        width = view.width;
        colour = new int[n];
        near = new float[n];
        column = new float[n];
        row = new float[n];
        planes = scenery.planes().stream()
                .map(plane -> new Plane(plane.point().minus(plane.normal().times(inset)), plane.normal()))
                .filter(this::isSeen).toList();
        lampView = ShadowMap.view(lighting, camera, view.viewHeight);
        spacing = Digits.roundStep(view.viewHeight / LINES).doubleValue();
        for (int y = 0; y < view.height; y++) {
            for (int x = 0; x < width; x++) {
                paint(x, y);
            }
        }
        for (Sphere sphere : scenery.spheres()) {
            new BackdropSphere(view, lighting, sphere, inset).paint(colour, near, column);
        }
    }

    /** @return an empty shadow map, if the lamp shines on a visible plane; each thread has its own */
    public Optional<ShadowMap> newShadows() {
        List<Plane> lit = planes.stream().filter(this::isLit).toList();
        return lit.isEmpty() ? Optional.empty() : Optional.of(new ShadowMap(lampView, lighting, lit));
    }

    private boolean isLit(Plane plane) {
        return lighting.lamp.dot(plane.normal()) > 0.05;
    }

    private boolean isSeen(Plane plane) {
        return view.perspective ? plane.distance(view.eye) > 0
                : plane.normal().dot(view.back) > 0;
    }

    private void paint(int x, int y) {
        int p = y * width + x;
        Ray ray = view.ray(x + 0.5, y + 0.5);
        double depth = Double.POSITIVE_INFINITY;
        Plane plane = null;
        for (Plane each : planes) {
            double t = depth(each, ray);
            if (t < depth && view.isInFront(t)) {
                depth = t;
                plane = each;
            }
        }
        colour[p] = behind(ray.direction(), y);
        near[p] = Float.NEGATIVE_INFINITY;
        column[p] = NO_SHADOWS;
        if (plane == null) {
            return;
        }
        Vector3 hit = ray.at(depth);
        double way = hit.minus(target).length() / (HAZE * view.viewHeight);
        double haze = 1 - StrictMath.exp(-way * way);
        Vector3 normal = plane.normal();
        float light = 1 + 0.35f * (lighting.light(view.turned(normal)) - lighting.light(view.turned(up)));
        Vector3 axisV = normal.cross(Math.abs(normal.x()) < 0.7 ? new Vector3(1, 0, 0) : new Vector3(0, 0, 1))
                .normalized();
        Vector3 axisU = axisV.cross(normal);
        Vector3 from = hit.minus(plane.point());
        // the distance of two neighbouring pixels on the plane
        Vector3 beside = on(plane, x + 1.5, y + 0.5, hit);
        Vector3 below = on(plane, x + 0.5, y + 1.5, hit);
        double line = 0;
        for (Vector3 axis : List.of(axisU, axisV)) {
            double foot = Math.abs(beside.minus(hit).dot(axis)) + Math.abs(below.minus(hit).dot(axis));
            line = Math.max(line, gridLines(from.dot(axis) / spacing, foot / spacing));
        }
        colour[p] = Colours.mix(Colours.lit(Colours.mix(sky.ground(), sky.line(), line), Math.max(0.5f, light), 0),
                sky.horizon(), haze);
        near[p] = (float) view.nearness(depth);
        CameraProjection.Place seen = lampView.place(hit);
        double seenX = seen.x() / Raster.SAMPLES;
        double seenY = seen.y() / Raster.SAMPLES;
        if (isLit(plane) && haze < 0.9 && ShadowMap.contains(seenX, seenY)) {
            column[p] = (float) seenX;
            row[p] = (float) seenY;
        }
    }

    /**
     * Antialiased grid lines at whole numbers, every fifth one thicker.
     *
     * @param u    the pixel's position in units of the grid
     * @param foot the pixel's width in those units
     * @return the fraction of the pixel that lines cover, 0 to 1; thin lines count less
     */
    static double gridLines(double u, double foot) {
        double f = Math.max(foot, 1e-9);
        return Math.min(1, Math.max(0.75 * covered(u, f, THIN), covered(u / 5, f / 5, THICK / 5)));
    }

    private static double covered(double u, double foot, double line) {
        return (integral(u + foot / 2, line) - integral(u - foot / 2, line)) / foot;
    }

    /** The integral from 0 to u of the function that is 1 on lines of this width around whole numbers, else 0. */
    private static double integral(double u, double line) {
        double cell = Math.floor(u + 0.5);
        return cell * line + Math.max(-line / 2, Math.min(line / 2, u - cell));
    }

    private Vector3 on(Plane plane, double px, double py, Vector3 otherwise) {
        Ray ray = view.ray(px, py);
        double depth = depth(plane, ray);
        return depth < Double.POSITIVE_INFINITY ? ray.at(depth) : otherwise;
    }

    /** The depth at which a ray meets a plane's outer side; infinity if it does not. */
    static double depth(Plane plane, Ray ray) {
        double fall = -ray.direction().dot(plane.normal());
        return fall > 1e-6 ? plane.distance(ray.start()) / fall : Double.POSITIVE_INFINITY;
    }

    /** The colour of the sky: with a ground it has a horizon; without one, it is a screen behind the scene. */
    private int behind(Vector3 ray, int y) {
        if (planes.isEmpty() || !view.perspective) {
            double part = (y + 0.5) / view.height;
            return part < 0.62 ? Colours.mix(sky.top(), sky.horizon(), part / 0.62)
                    : Colours.mix(sky.horizon(), sky.bottom(), (part - 0.62) / 0.38);
        }
        double rise = ray.dot(up) / ray.length();
        return Colours.mix(sky.horizon(), sky.top(), rise / 0.45);
    }

    /** @return the nearness of the plane at pixel p; negative infinity for the sky */
    public float near(int p) {
        return near[p];
    }

    /** Paints the background with the shadows of this frame. */
    public void paint(int[] pixels, Optional<ShadowMap> shadows) {
        System.arraycopy(colour, 0, pixels, 0, colour.length);
        if (shadows.isEmpty()) {
            return;
        }
        ShadowMap map = shadows.get();
        for (int p = 0; p < pixels.length; p++) {
            float covered = column[p] == NO_SHADOWS ? 0 : map.at(column[p], row[p]);
            if (covered > 0) {
                pixels[p] = Colours.lit(pixels[p], 1 - (1 - DARKEST_SHADOW) * covered, 0);
            }
        }
    }

    /**
     * The things of a frame that are drawn already, and hide light and lines that are added behind them.
     *
     * @param raster   the opaque shapes
     * @param backdrop the planes and spheres behind them
     */
    public record Foreground(Raster raster, Backdrop backdrop) {

        /** @return whether a point of this nearness is visible at a pixel */
        public boolean shows(double near, int x, int y) {
            return near > backdrop.near(y * backdrop.width + x) && near > raster.nearAt(x, y);
        }
    }
}
