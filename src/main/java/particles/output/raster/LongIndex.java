package particles.output.raster;

import java.util.Arrays;

/** A hash table of longs with open addressing that numbers keys 0, 1, 2 ... in the order of insertion. */
public final class LongIndex {
    private static final long EMPTY = -1;
    private static final int SMALLEST = 1 << 10;

    private long[] table = new long[SMALLEST];
    private int[] places = new int[SMALLEST];
    private long[] keys = new long[SMALLEST / 2];
    private int size;

    /** Creates an empty table. */
    public LongIndex() {
        Arrays.fill(table, EMPTY);
    }

    /** Removes all keys. */
    public void clear() {
        Arrays.fill(table, EMPTY);
        size = 0;
    }

    /** @return the number of keys */
    public int size() {
        return size;
    }

    /** @return the key with this number */
    public long key(int number) {
        return keys[number];
    }

    /** @return the key's number, or -1 if it has none */
    public int find(long key) {
        int at = slot(key);
        return table[at] == key ? places[at] : -1;
    }

    /** @param key 0 or more
     *  @return its number, a new one if it has none */
    public int put(long key) {
        int at = slot(key);
        if (table[at] == key) {
            return places[at];
        }
        if (size == keys.length) {
            grow();
            at = slot(key);
        }
        table[at] = key;
        places[at] = size;
        keys[size] = key;
        return size++;
    }

    /** The slot of a key, or its free slot; the table is at most half full, so the search ends. */
    private int slot(long key) {
        int mask = table.length - 1;
        int at = (int) (key * 0x9E3779B97F4A7C15L >>> 40) & mask;
        while (table[at] != key && table[at] != EMPTY) {
            at = at + 1 & mask;
        }
        return at;
    }

    private void grow() {
        table = new long[2 * table.length];
        places = new int[table.length];
        Arrays.fill(table, EMPTY);
        keys = Arrays.copyOf(keys, 2 * keys.length);
        for (int k = 0; k < size; k++) {
            int at = slot(keys[k]);
            table[at] = keys[k];
            places[at] = k;
        }
    }
}
