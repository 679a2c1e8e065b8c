package particles.scene.parts;

import java.util.ArrayList;
import java.util.List;
import particles.spec.Key;
import particles.spec.MappingType;
import particles.spec.NumberType;
import particles.spec.Values;

/**
 * The springs of one sort in a shape, all with the same constants; their rest lengths are the initial distances.
 *
 * @param sort      the pairs of neighbours that they connect
 * @param stiffness k (N/m)
 * @param damping   k_d (N s/m)
 */
public record SpringFamily(Sort sort, double stiffness, double damping) {
    static final Key<Double> STIFFNESS = NumberType.positive("N/m").required("stiffness",
            "k of each of these springs (N/m).");
    static final Key<Double> DAMPING = NumberType.notNegative("N s/m").withDefault("damping", 0.0,
            "k_d of each of these springs (N s/m).");

    /** The pairs of neighbours that are connected. */
    public enum Sort {
        /** Nearest neighbours along each direction: they hold the shape together. */
        STRUCTURAL("structural",
                "Springs between nearest neighbours along each direction: they hold the shape together."),
        /** Diagonals of faces and cells: they keep squares from becoming rhombi. */
        SHEAR("shear", "Springs along the diagonals of squares (and cubes): they keep squares from becoming rhombi."),
        /** Second neighbours along each direction, with one between them: they resist folding. */
        BEND("bend",
                "Springs between second neighbours along each direction, skipping one particle: they resist folding.");

        private final Key<Values> key;

        Sort(String name, String sentence) {
            key = MappingType.of("'" + name + "'", STIFFNESS, DAMPING).optional(name, sentence);
        }

        /** @return the key of this sort of springs */
        Key<Values> key() {
            return key;
        }

        /** @return the same key, described in another way */
        Key<Values> key(String sentence) {
            return key.type().optional(key.name(), sentence);
        }

        /**
         * @return for a lattice of this number of directions, the steps from a particle to its partners, each pair once
         */
        List<int[]> offsets(int dimensions) {
            List<int[]> offsets = new ArrayList<>();
            int all = (int) Math.round(StrictMath.pow(3, dimensions));
            // the half of all steps in {-1, 0, 1} after zero; BEND takes two at once
            for (int code = all / 2 + 1; code < all; code++) {
                int[] offset = new int[dimensions];
                int length = 0;
                for (int d = dimensions - 1, rest = code; d >= 0; d--, rest /= 3) {
                    offset[d] = (rest % 3 - 1) * (this == BEND ? 2 : 1);
                    length += Math.abs(rest % 3 - 1);
                }
                if (length == 1 == (this != SHEAR)) {
                    offsets.add(offset);
                }
            }
            return offsets;
        }
    }

    SpringFamily(Sort sort, Values values) {
        this(sort, values.get(STIFFNESS), values.get(DAMPING));
    }

    /** Receives the springs one by one. */
    public interface Sink {
        /** Takes a spring between two particles, by their numbers in the shape. */
        void spring(int from, int to);
    }
}
