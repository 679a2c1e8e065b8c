package deSolvers;

/** Brings a source's clock to exact times, though it can only be told by how much to move. */
final class SourceClock {
    private SourceClock() {
    }

    /**
     * To a time: a difference of two readings may round, but what is left after one move is so small that a second is
     * exact.
     */
    static void moveTo(DEStateSource source, double time) {
        source.incTime(time - source.getTime());
        if (source.getTime() != time) {
            source.incTime(time - source.getTime());
        }
    }

    /** To a time within a step, as near as one move gets. */
    static void moveWithin(DEStateSource source, double start, double offset) {
        double now = source.getTime();
        source.incTime(now == start ? offset : start + offset - now);
    }

    /**
     * To start + deltaT, where a last stage may have left it already. Where the clock still stands at the start one
     * addition does: what is begun next waits for the clock.
     */
    static void moveToEnd(DEStateSource source, double start, double deltaT) {
        double end = start + deltaT;
        double now = source.getTime();
        if (now != end) {
            source.incTime(now == start ? deltaT : end - now);
            if (source.getTime() != end) {
                moveTo(source, end);
            }
        }
    }
}
