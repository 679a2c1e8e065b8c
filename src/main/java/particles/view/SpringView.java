package particles.view;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Read-only view of springs, for pictures and messages. */
public interface SpringView {
    /** @return the number of springs */
    int springCount();

    /** @return the index of the particle at the first end of spring s */
    int from(int s);

    /** @return the index of the particle at the second end of spring s */
    int to(int s);

    /** @return the length at which spring s exerts no force (m) */
    double restLength(int s);

    /** @return the force per unit of stretch of spring s (N/m) */
    double stiffness(int s);

    /** @return the force per unit of stretching rate of spring s (N s/m) */
    double damping(int s);

    /**
     * A copy of all springs and rods of a run at one time.
     *
     * @param from       the particle at the first end of each
     * @param to         the particle at the second end
     * @param restLength the rest length (m)
     * @param stiffness  the stiffness (N/m); infinite for a rod
     */
    record SpringList(int[] from, int[] to, double[] restLength, double[] stiffness) {
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
}
