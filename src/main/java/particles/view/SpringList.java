package particles.view;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * A copy of all springs and rods of a run at one time.
 *
 * @param from       the particle at the first end of each
 * @param to         the particle at the second end
 * @param restLength the rest length (m)
 * @param stiffness  the stiffness (N/m); infinite for a rod
 */
public record SpringList(int[] from, int[] to, double[] restLength, double[] stiffness) {
    /** No springs. */
    public static final SpringList NONE = of(Stream.of());

    /**
     * @param parts the effects and reactions of a run; those that are springs or rods count
     * @return a copy of them
     */
    public static SpringList of(Stream<?> parts) {
        List<SpringView> views = views(parts).toList();
        return new SpringList(
                views.stream().flatMapToInt(view -> numbers(view).map(view::from)).toArray(),
                views.stream().flatMapToInt(view -> numbers(view).map(view::to)).toArray(),
                views.stream().flatMapToDouble(view -> numbers(view).mapToDouble(view::restLength)).toArray(),
                views.stream().flatMapToDouble(view -> numbers(view).mapToDouble(view::stiffness)).toArray());
    }

    /**
     * @param parts the effects and reactions of a run
     * @return how many springs and rods are in them, without a copy
     */
    public static int count(Stream<?> parts) {
        return views(parts).mapToInt(SpringView::springCount).sum();
    }

    private static Stream<SpringView> views(Stream<?> parts) {
        return parts.filter(SpringView.class::isInstance).map(SpringView.class::cast);
    }

    private static IntStream numbers(SpringView view) {
        return IntStream.range(0, view.springCount());
    }

    /** @return how many there are */
    public int count() {
        return from.length;
    }

    /** @return whether spring s is a rod */
    public boolean isRigid(int s) {
        return stiffness[s] == Double.POSITIVE_INFINITY;
    }
}
