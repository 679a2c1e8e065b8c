package deSolvers.rungeKutta;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import java.lang.reflect.Field;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Every tableau of every solver in the catalogue fulfils the order conditions of its order, one for each rooted tree
 * (Hairer, N&oslash;rsett, Wanner, section II.2), and not all of those of the next.
 */
class OrderConditionsTest {
    private static final int[] TREES_OF_ORDER = {0, 1, 1, 2, 4, 9, 20};

    /** A rooted tree as the list of the trees that hang from its root. */
    private record Tree(List<Tree> branches) {
        int order() {
            return 1 + branches.stream().mapToInt(Tree::order).sum();
        }

        double density() {
            return branches.stream().mapToDouble(Tree::density).reduce(order(), (x, y) -> x * y);
        }

        /** The elementary weights of the tree at each stage. */
        double[] stages(ButcherTableau tableau) {
            double[] product = new double[tableau.getStages()];
            Arrays.fill(product, 1);
            for (Tree branch : branches) {
                double[] inner = branch.stages(tableau);
                for (int i = 0; i < product.length; i++) {
                    double sum = 0;
                    for (int j = 0; j < i; j++) {
                        sum += tableau.row(i)[j] * inner[j];
                    }
                    product[i] *= sum;
                }
            }
            return product;
        }
    }

    /** All trees of up to an order, smaller ones first; a tree's branches stand in the order of this list. */
    private static List<Tree> trees(int order) {
        List<Tree> all = new ArrayList<>();
        for (int n = 1; n <= order; n++) {
            List<Tree> ofThisOrder = new ArrayList<>();
            hang(all, 0, n - 1, new ArrayList<>(), ofThisOrder);
            assertEquals(TREES_OF_ORDER[n], ofThisOrder.size(), "trees of order " + n);
            all.addAll(ofThisOrder);
        }
        return all;
    }

    private static void hang(List<Tree> smaller, int from, int left, List<Tree> branches, List<Tree> result) {
        if (left == 0) {
            result.add(new Tree(List.copyOf(branches)));
        }
        for (int i = from; i < smaller.size(); i++) {
            if (smaller.get(i).order() <= left) {
                branches.add(smaller.get(i));
                hang(smaller, i, left - smaller.get(i).order(), branches, result);
                branches.remove(branches.size() - 1);
            }
        }
    }

    private static Map<String, ButcherTableau> tableaux() throws ReflectiveOperationException {
        Map<String, ButcherTableau> found = new LinkedHashMap<>();
        for (SolverInfo info : SolverCatalog.all()) {
            for (Field field : SolverCatalog.create(info.name()).getClass().getDeclaredFields()) {
                if (field.getType() == ButcherTableau.class) {
                    field.setAccessible(true);
                    found.put(info.name() + "." + field.getName(), (ButcherTableau) field.get(null));
                }
            }
        }
        return found;
    }

    /** The largest deviation from a condition of an order; products of ten rounded fractions leave some 1e-16. */
    private static double largestMiss(ButcherTableau tableau, int line, int order) {
        double largest = 0;
        for (Tree tree : trees(order)) {
            if (tree.order() == order) {
                double[] stages = tree.stages(tableau);
                double[] weights = tableau.weights(line);
                double sum = 0;
                for (int i = 0; i < stages.length; i++) {
                    sum += weights[i] * stages[i];
                }
                largest = Math.max(largest, Math.abs(sum - 1 / tree.density()));
            }
        }
        return largest;
    }

    @ParameterizedTest
    @CsvSource({"step-doubling.RK4, 0, 4", "dormand-prince.TABLEAU, 0, 5", "dormand-prince.TABLEAU, 1, 4"})
    void everyTableauHasItsOrder(String name, int line, int order) throws ReflectiveOperationException {
        assertEquals(Set.of("step-doubling.RK4", "dormand-prince.TABLEAU"), tableaux().keySet());
        ButcherTableau tableau = tableaux().get(name);
        for (int p = 1; p <= order; p++) {
            assertEquals(0, largestMiss(tableau, line, p), 1e-14, name + ", weights " + line + ", order " + p);
        }
        assertFalse(largestMiss(tableau, line, order + 1) < 1e-5, name + " has a higher order");
    }

    @Test
    void theRowsOfEveryTableauSumToItsNodes() throws ReflectiveOperationException {
        tableaux().forEach((name, tableau) -> {
            for (int i = 0; i < tableau.getStages(); i++) {
                double sum = 0;
                for (int j = 0; j < i; j++) {
                    sum += tableau.row(i)[j];
                }
                assertEquals(tableau.node(i), sum, 1e-14, name + ", stage " + i);
            }
        });
    }
}
