package particles.lab;

import java.util.ArrayList;
import java.util.List;

/**
 * The frames of a run so far, in a limited amount of memory: when it is full, every second frame is dropped, and from
 * then on frames are kept half as often.
 */
final class History {
    private final long mostBytes;
    private final List<Frame> frames = new ArrayList<>();
    private long bytes;
    private double interval;

    /** @param mostBytes the memory that it may take (bytes) */
    History(long mostBytes) {
        this.mostBytes = mostBytes;
    }

    /** Whether a moment at this time would be kept. */
    boolean wants(double time) {
        return frames.isEmpty() || time >= last().time() + interval;
    }

    /** Keeps a moment, later than all before, or in place of the latest where that has the same time. */
    void add(Frame frame) {
        if (!frames.isEmpty() && last().time() == frame.time()) {
            bytes -= bytesOf(frames.remove(frames.size() - 1));
        }
        append(frame);
        while (bytes > mostBytes && thin()) {
            // half of them is left
        }
    }

    /** Drops every second moment but the last, if there are more than two. @return whether there were */
    boolean thin() {
        if (frames.size() <= 2) {
            return false;
        }
        List<Frame> kept = new ArrayList<>();
        for (int i = 0; i < frames.size(); i += 2) {
            kept.add(frames.get(i));
        }
        if (frames.size() % 2 == 0) {
            kept.add(last());
        }
        double span = last().time() - frames.get(0).time();
        frames.clear();
        bytes = 0;
        interval = span / (kept.size() - 1) * (1 - 1e-9);
        kept.forEach(this::append);
        return true;
    }

    private void append(Frame frame) {
        bytes += bytesOf(frame);
        frames.add(frame);
    }

    /** What a frame takes after the latest. */
    private long bytesOf(Frame frame) {
        return frame.bytes() + (frames.isEmpty() || last().structure() != frame.structure()
                ? frame.structure().bytes() : 0);
    }

    /** The latest moment. */
    Frame last() {
        return frames.get(frames.size() - 1);
    }

    /** The latest moment kept that is not after this time, or the first. */
    Frame at(double time) {
        int low = 0;
        int high = frames.size() - 1;
        while (low < high) {
            int middle = (low + high + 1) / 2;
            if (frames.get(middle).time() <= time) {
                low = middle;
            } else {
                high = middle - 1;
            }
        }
        return frames.get(low);
    }

    /** The moments kept that are after this time, the earliest first. */
    List<Frame> after(double time) {
        int first = frames.size();
        while (first > 0 && frames.get(first - 1).time() > time) {
            first--;
        }
        return List.copyOf(frames.subList(first, frames.size()));
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
