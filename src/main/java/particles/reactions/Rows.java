package particles.reactions;

import java.util.ArrayList;
import java.util.List;
import particles.reactions.Row.Kind;
import particles.reactions.wires.Curve;

/** The rows of rods, of balls in contact and of wires, in this order. */
final class Rows {
    final List<Row> list = new ArrayList<>();
    private int changes;

    Row get(int row) {
        return list.get(row);
    }

    /** Counts changes of the list. */
    int getChanges() {
        return changes;
    }

    /** Adds the row of a rod or of two balls, in the order of kinds; it keeps this distance (m). */
    void addLink(Kind link, int from, int to, double distance) {
        changes++;
        list.add(begin(Kind.values()[link.ordinal() + 1]), new Row(link, from, to, distance));
    }

    /** Adds the rows of a bead. */
    void addBead(int particle, Curve wire) {
        changes++;
        for (int k = 0; k < Curve.ROWS; k++) {
            list.add(Row.wire(particle, wire, k));
        }
    }

    /** Removes a row. */
    void remove(int row) {
        changes++;
        list.remove(row);
    }

    /** Updates indices after particles were removed; their rows are removed too. */
    void reindex(int[] newIndex) {
        changes++;
        for (Row row : list) {
            row.first = newIndex[row.first];
            row.second = row.second < 0 ? -1 : newIndex[row.second];
        }
        list.removeIf(row -> row.first < 0 || row.second < 0 && row.kind != Kind.WIRE);
    }

    /** The index of the first row of a kind, or of a later one. */
    int begin(Kind from) {
        int r = list.size();
        while (r > 0 && list.get(r - 1).kind.compareTo(from) >= 0) {
            r--;
        }
        return r;
    }
}
