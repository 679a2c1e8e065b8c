package particles.view;

import deSolvers.catalog.SolverInfo;
import java.util.List;
import java.util.Optional;

/**
 * The look of a series, the same in all charts.
 *
 * @param rgb     its colour on white, 0xRRGGBB
 * @param variant the number of its dashes and of the shape of its points; 0 is a solid line with discs
 * @param solver  the solver of the catalogue that it belongs to
 */
public record Look(int rgb, int variant, Optional<SolverInfo> solver) {
    private static final int GREY = 0x555555;
    /**
     * The colours of M. Okabe and K. Ito, "Color Universal Design" (2008), which are distinct for people with any kind
     * of colour vision; their yellow is left out, since it is too pale on white.
     */
    private static final List<Integer> COLOURS = List.of(0x000000, 0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7, 0xe69f00,
            0x56b4e9);

    /** A solver of one's own. */
    public static final Look OWN = new Look(GREY, 0, Optional.empty());
    /** The exact solution, or an accurate one. */
    public static final Look REFERENCE = new Look(GREY, 1, Optional.empty());
    /** A mark of no solver, such as the start of a path. */
    public static final Look MARK = new Look(GREY, 2, Optional.empty());
    /** A run without a result. */
    public static final Look FAILURE = new Look(0xb20000, 0, Optional.empty());
    /** Energy that drives a system. */
    public static final Look DRIVEN = new Look(0x6a3d9a, 0, Optional.empty());
    /** Any other work. */
    public static final Look WORK = new Look(0x2f7f8f, 0, Optional.empty());
    /** Numerical error. */
    public static final Look ERROR = new Look(0xb3261e, 0, Optional.empty());

    /** @return the look of a solver */
    public static Look of(SolverInfo solver) {
        return new Look(solver.look().rgb(), solver.look().variant(), Optional.of(solver));
    }

    /** @return the k-th look of a chart without solvers; the first is black */
    public static Look number(int k) {
        return new Look(COLOURS.get(k % COLOURS.size()), k, Optional.empty());
    }

    /** @return whether it is the look of the exact solution; the first equals of a record loads 77 classes */
    public boolean isReference() {
        return rgb == REFERENCE.rgb && variant == REFERENCE.variant;
    }

    /** @return the same with other dashes and points */
    public Look variant(int other) {
        return new Look(rgb, other, solver);
    }
}
