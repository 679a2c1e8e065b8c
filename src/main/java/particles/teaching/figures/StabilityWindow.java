package particles.teaching.figures;

import java.util.List;
import java.util.function.DoubleBinaryOperator;
import java.util.function.LongSupplier;
import particles.experiments.stability.StabilityRegion.Window;

/** Chooses the part of the plane that shows a solver's stability region, and the resolution of its picture. */
final class StabilityWindow {
    private static final double NEAREST = 0.05;
    private static final double FARTHEST = 20;
    private static final double FACTOR = 1.1;
    private static final double STABLE = 1 + 1e-8;
    /** Evaluations that the picture may take: half a second of them. */
    private static final double BUDGET = 1.5e6;
    private static final int MOST_CELLS = 160;
    private static final int FEWEST_CELLS = 24;

    private StabilityWindow() {
    }

    /**
     * Looks from 0 in all directions for places where stable and unstable meet.
     *
     * @param growth      |R| at a point of the plane
     * @param beside      |R| of another method, whose outline is shown too
     * @param evaluations counts the evaluations of the first
     * @param both        whether the plane is that of deltaT lambda; otherwise both coordinates are positive
     * @return a part of the plane with all of these places
     */
    static Window of(DoubleBinaryOperator growth, DoubleBinaryOperator beside, LongSupplier evaluations,
            boolean both) {
        double left = 0;
        double right = 0;
        double top = 0;
        long before = evaluations.getAsLong();
        int looks = 0;
        int directions = both ? 12 : 6;
        for (int k = 0; k <= directions; k++) {
            double cos = StrictMath.cos(Math.PI * k / 12);
            double sin = StrictMath.sin(Math.PI * k / 12);
            for (DoubleBinaryOperator one : List.of(growth, beside)) {
                boolean stable = one.applyAsDouble(NEAREST * cos, NEAREST * sin) <= STABLE;
                for (double size = NEAREST; size < FARTHEST; size *= FACTOR) {
                    looks++;
                    boolean was = stable;
                    stable = one.applyAsDouble(size * cos, size * sin) <= STABLE;
                    if (stable != was) {
                        left = Math.min(left, size * cos);
                        right = Math.max(right, size * cos);
                        top = Math.max(top, size * sin);
                    }
                }
            }
        }
        double size = Math.max(right - left, top);
        if (size == 0) {                                // all stable, or the imaginary axis for an outline
            size = 4;
            left = both ? -size : 0;
            top = size;
        }
        double margin = 0.15 * size;
        left = both ? Math.min(left - margin, -0.4 * size) : 0;
        right = Math.max(right, left + size / 2) + margin;
        top = Math.max(top, size / 2) + margin;
        double each = Math.max(1, 2.0 * (evaluations.getAsLong() - before) / looks);
        double largest = Math.max(right - left, top);
        double cells = Math.sqrt(BUDGET / each * largest * largest / ((right - left) * top));
        double cell = largest / Math.max(FEWEST_CELLS, Math.min(MOST_CELLS, Math.floor(cells)));
        return new Window(left, right, top, cell);
    }
}
