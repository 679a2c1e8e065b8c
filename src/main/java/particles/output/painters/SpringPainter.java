package particles.output.painters;

import java.util.Optional;
import particles.law.Vector3;
import particles.output.raster.CameraProjection;
import particles.output.raster.CameraProjection.Place;
import particles.output.raster.Colours;
import particles.output.raster.RoundShapes;
import particles.view.RenderOptions;
import particles.view.SpringView.SpringList;

/**
 * Draws springs, coloured by their strain: as coils if they are few or soft, as straight tubes if they are many. Rods,
 * and springs between fixed particles, are drawn as bars, and springs without stiffness as thin
 * lines.
 */
public record SpringPainter(RoundShapes shapes, RenderOptions look, DrawnSizes sizes) {
    private static final int ROD = 0x6c7683;
    private static final int SEGMENTS_A_TURN = 18;
    /**
     * The straight piece at either end of a coil, and the point at which it has its full width, as fractions of the
     * length.
     */
    private static final double STRAIGHT = 0.07;
    private static final double WIDE = 0.11;
    /** The lift of springs, as a fraction of the picture's height. */
    private static final double LIFT = 0.004;

    /** @return whether any spring with strain is visible so far */
    boolean paint(FrameState state, Place[] places, VisibilityFilter shown) {
        boolean seen = false;
        SpringList springs = state.springs();
        for (int s = 0; s < springs.count(); s++) {
            if (shown.spring(springs.from()[s], springs.to()[s])) {
                seen |= paint(state, places, s);
            }
        }
        return seen;
    }

    private boolean paint(FrameState state, Place[] places, int s) {
        SpringList springs = state.springs();
        int a = springs.from()[s];
        int b = springs.to()[s];
        Optional<Integer> own = look.colours().springs();
        double stiffness = springs.stiffness()[s];
        if (stiffness == 0) {
            shapes.tube(lifted(places[a]), lifted(places[b]), sizes.tube(stiffness), own.orElse(ROD));
            return false;
        }
        if (springs.isRigid(s) || state.isFixed(a) && state.isFixed(b)) {
            shapes.tube(places[a], places[b], sizes.rod(), ROD);
            return false;
        }
        Vector3 from = state.place(a);
        Vector3 whole = state.place(b).minus(from);
        double length = whole.length();
        double rest = springs.restLength()[s];
        double strain = rest > 0 ? (length - rest) / rest : length > 0 ? look.strainRange() : 0;
        int rgb = own.orElseGet(() -> Colours.ofStrain(strain, look.strainRange()));
        boolean seen = sizes.isCoil(state, s) && length > 4 * sizes.wire() && rest > 0
                ? paintCoil(from, whole, rest, rgb)
                : shapes.tube(lifted(places[a]), lifted(places[b]), sizes.tube(stiffness), rgb);
        return seen && own.isEmpty();
    }

    /** The place of an end, a little nearer, so that a surface spanned by springs does not hide half of each. */
    private Place lifted(Place at) {
        double near = shapes.view().nearness(at.depth() - LIFT * shapes.view().viewHeight);
        return new Place(at.x(), at.y(), at.depth(), at.scale(), near, at.visible());
    }

    /** Draws a helix from particle to particle; the number of turns does not change with length. */
    private boolean paintCoil(Vector3 from, Vector3 whole, double rest, int rgb) {
        Vector3 along = whole.normalized();
        // two directions across, the first of them as far as possible towards the viewer
        CameraProjection view = shapes.view();
        Vector3 towards = Math.abs(along.dot(view.back)) > 0.999 ? view.right : view.back;
        Vector3 first = towards.minus(along.times(along.dot(towards))).normalized();
        Vector3 second = along.cross(first);
        int turns = (int) Math.max(4, Math.min(16, Math.rint(rest / (1.5 * sizes.coil()))));
        int segments = turns * SEGMENTS_A_TURN;
        Place[] helix = new Place[segments + 1];
        for (int k = 0; k <= segments; k++) {
            double t = (double) k / segments;
            double inside = Math.min(t, 1 - t);
            double radius = sizes.coil() * Math.max(0, Math.min(1, (inside - STRAIGHT) / (WIDE - STRAIGHT)));
            double angle = 2 * Math.PI * turns * (t - STRAIGHT) / (1 - 2 * STRAIGHT);
            helix[k] = view.place(from.plus(whole.times(t)).plus(second.times(radius * Math.sin(angle)))
                    .plus(first.times(radius * Math.cos(angle))));
        }
        return shapes.tubes(helix, sizes.wire(), rgb);
    }
}
