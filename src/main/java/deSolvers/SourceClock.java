package deSolvers;

/** Sets a source's clock to exact times by {@link DEStateSource#incTime}, which can only move it by a difference. */
final class SourceClock {
    private SourceClock() {
    }

    /**
     * Moves the clock to a time. The first move may be off by round-off; the remaining difference is so small that a
     * second move is exact.
     */
    static void moveTo(DEStateSource source, double time) {
        source.incTime(time - source.getTime());
        if (source.getTime() != time) {
            source.incTime(time - source.getTime());
        }
    }

    /** Moves the clock to a time within a step, as near as one move gets. */
    static void moveWithin(DEStateSource source, double start, double offset) {
        double now = source.getTime();
        source.incTime(now == start ? offset : start + offset - now);
    }

    /**
     * Moves the clock to start + deltaT, where the last stage may have left it already. If the clock is still at the
     * start, one addition is enough.
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
