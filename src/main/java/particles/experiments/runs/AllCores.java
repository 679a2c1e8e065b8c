package particles.experiments.runs;

import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;

/** Does independent runs of an experiment on all cores. */
public final class AllCores {
    private AllCores() {
    }

    /**
     * Does a task for each of some items, several at a time. The tasks must not share anything that one of them
     * changes.
     *
     * @param items    the items
     * @param task     the task; an exception of it ends all
     * @param progress receives the progress after each item
     * @param what     what to say of an item that is done
     * @param <T>      the type of an item
     * @param <R>      the type of a result
     * @return the results, in the order of the items
     */
    public static <T, R> List<R> map(List<T> items, Function<T, R> task, ProgressListener progress,
            Function<T, String> what) {
        AtomicInteger done = new AtomicInteger();
        return items.parallelStream().map(item -> {
            R result = task.apply(item);
            synchronized (done) {
                progress.reached((double) done.incrementAndGet() / items.size(), what.apply(item));
            }
            return result;
        }).toList();
    }
}
