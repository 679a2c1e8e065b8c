package particles.lab;

import java.util.List;
import java.util.NavigableMap;
import java.util.TreeMap;

/**
 * The frames of a run so far, in a limited amount of memory: when it is full, every second frame is dropped, and from
 * then on frames are kept half as often.
 */
final class History {
    private final long mostBytes;
    private final NavigableMap<Double, Frame> frames = new TreeMap<>();     // by time
    private long bytes;
    private double interval;

    /** @param mostBytes the memory that it may take (bytes) */
    History(long mostBytes) {
        this.mostBytes = mostBytes;
    }

    /** Whether a moment at this time would be kept. */
    boolean wants(double time) {
        return frames.isEmpty() || time >= frames.lastKey() + interval;
    }

    /** Keeps a moment, later than all before, or in place of the latest where that has the same time. */
    void add(Frame frame) {
        if (frames.containsKey(frame.time())) {
            bytes -= bytesOf(frames.remove(frame.time()));
        }
        append(frame);
        while (bytes > mostBytes && thin()) {
            // half of them is left
        }
    }

    /**
     * Drops every second moment but the last, if there are more than two.
     *
     * @return whether there were
     */
    boolean thin() {
        List<Frame> all = List.copyOf(frames.values());
        int last = all.size() - 1;
        if (last < 2) {
            return false;
        }
        frames.clear();
        bytes = 0;
        for (int i = 0; i < last; i += 2) {
            append(all.get(i));
        }
        append(all.get(last));
        interval = (frames.lastKey() - frames.firstKey()) / (frames.size() - 1) * (1 - 1e-9);
        return true;
    }

    private void append(Frame frame) {
        bytes += bytesOf(frame);
        frames.put(frame.time(), frame);
    }

    /** What a frame takes after the latest. */
    private long bytesOf(Frame frame) {
        return frame.bytes() + (frames.isEmpty() || last().structure() != frame.structure()
                ? frame.structure().bytes() : 0);
    }

    /** The latest moment. */
    Frame last() {
        return frames.lastEntry().getValue();
    }

    /** The latest moment kept that is not after this time, or the first. */
    Frame at(double time) {
        return frames.floorEntry(Math.max(time, frames.firstKey())).getValue();
    }

    /** The moments kept that are after this time, the earliest first. */
    List<Frame> after(double time) {
        return List.copyOf(frames.tailMap(time, false).values());
    }

    /** The shortest time between two moments kept (s); 0 if all are. */
    double getInterval() {
        return interval;
    }

    /** About how much memory it takes. */
    long getBytes() {
        return bytes;
    }
}
