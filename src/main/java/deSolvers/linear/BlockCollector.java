package deSolvers.linear;

import deSolvers.JacobianBlocks;
import deSolvers.JacobianStateSource;
import java.util.Arrays;

/**
 * Takes up the blocks that a source names, each at its place in a pattern. A source names the same pairs in the same
 * order every time; where it does not, the pattern is found anew.
 */
public abstract class BlockCollector implements JacobianBlocks {
    private BlockPattern pattern = new BlockPattern(0, 0, new int[0], new int[0]);
    private int cursor;
    private boolean matches;
    private boolean recording;
    private int[] first = {};
    private int[] second = {};

    /** Makes the arrays for a new {@link #pattern}. */
    abstract void resize();

    /** Sets all values to 0. */
    abstract void clear();

    /** Lets the source name its blocks at its present state. */
    final void fill(JacobianStateSource source, int rows) {
        receive(source, rows);
        if (matches && cursor == pattern.pairs()) {
            return;
        }
        recording = true;
        cursor = 0;
        source.addJacobianBlocks(this);
        recording = false;
        pattern = new BlockPattern(rows, cursor, first, second);
        first = new int[0];
        second = new int[0];
        resize();
        receive(source, rows);
    }

    private void receive(JacobianStateSource source, int rows) {
        clear();
        cursor = 0;
        matches = pattern.rows == rows;
        source.addJacobianBlocks(this);
    }

    /** The number of the pair that is named next, or -1 if it has no place (yet). */
    final int next(int i, int j) {
        if (recording) {
            if (cursor == first.length) {
                first = Arrays.copyOf(first, Math.max(64, 2 * cursor));
                second = Arrays.copyOf(second, Math.max(64, 2 * cursor));
            }
            first[cursor] = i;
            second[cursor] = j;
            cursor++;
            return -1;
        }
        matches = matches && pattern.isPair(cursor, i, j);
        return matches ? cursor++ : -1;
    }

    /** Whether rows have their values, so that they can be transformed. */
    final boolean hasRows() {
        return !recording && matches;
    }

    public final BlockPattern pattern() {
        return pattern;
    }
}
