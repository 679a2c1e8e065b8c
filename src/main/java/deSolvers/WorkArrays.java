package deSolvers;

import java.util.Arrays;

/** The arrays that a step works with: made once, lent one by one, and all free again when the next step begins. */
final class WorkArrays {
    private double[][] arrays = {};
    private int lent;
    private int n;

    /** Takes all arrays back; arrays of another size are dropped. */
    void begin(int n) {
        if (n != this.n) {
            arrays = new double[0][];
            this.n = n;
        }
        lent = 0;
    }

    /** An array that no other call returns until the next step begins; its entries are arbitrary. */
    double[] next() {
        if (lent == arrays.length) {
            arrays = Arrays.copyOf(arrays, lent + 1);
            arrays[lent] = new double[n];
        }
        return arrays[lent++];
    }

    /** Puts another array in the place of the first one, which was given away. */
    void replaceFirst(double[] array) {
        arrays[0] = array;
    }
}
