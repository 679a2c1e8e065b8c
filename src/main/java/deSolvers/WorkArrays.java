package deSolvers;

import java.util.Arrays;

/**
 * The arrays that a step works with. They are made once and lent one by one; when the next step begins, all are free
 * again.
 */
final class WorkArrays {
    private double[][] arrays = {};
    private int lent;
    private int n;

    /** Takes all arrays back and lends the first; arrays of another length are dropped. */
    double[] first(int n) {
        if (n != this.n) {
            arrays = new double[0][];
            this.n = n;
        }
        lent = 0;
        return next();
    }

    /** An array that no other call returns until the next step begins; its entries are arbitrary. */
    double[] next() {
        if (lent == arrays.length) {
            arrays = Arrays.copyOf(arrays, lent + 1);
            arrays[lent] = new double[n];
        }
        return arrays[lent++];
    }
}
