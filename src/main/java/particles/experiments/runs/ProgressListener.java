package particles.experiments.runs;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiFunction;
import java.util.function.Function;

/** Receives the progress of an experiment. */
public interface ProgressListener {

    /**
     * @param part the part that is done, 0 to 1
     * @param what the present task, such as {@code rk4 on the pendulum}
     */
    void reached(double part, String what);

    /** @return receives the progress of a task that is a part of this one */
    default ProgressListener part(double from, double to) {
        return (part, what) -> reached(from + (to - from) * part, what);
    }

    /**
     * Does a task for each item, one after the other.
     *
     * @param items the items
     * @param name  names an item
     * @param task  the task
     * @return the results
     */
    default <T, R> List<R> each(List<T> items, Function<T, String> name, Function<T, R> task) {
        return parts(items, (item, part) -> {
            part.reached(0, name.apply(item));
            return task.apply(item);
        });
    }

    /**
     * Does a task for each item, one after the other.
     *
     * @param items the items
     * @param task  the task, which receives the progress of its part
     * @return the results
     */
    default <T, R> List<R> parts(List<T> items, BiFunction<T, ProgressListener, R> task) {
        List<R> results = new ArrayList<>();
        for (T item : items) {
            double done = results.size();
            results.add(task.apply(item, part(done / items.size(), (done + 1) / items.size())));
        }
        return results;
    }

    /**
     * Does a task for each item, several at a time. The tasks must not share anything that one of them changes.
     *
     * @param items the items
     * @param name  names an item that is done
     * @param task  the task; an exception of it ends all
     * @return the results, in the order of the items
     */
    default <T, R> List<R> onAllCores(List<T> items, Function<T, String> name, Function<T, R> task) {
        AtomicInteger done = new AtomicInteger();
        ClassLoader classes = Thread.currentThread().getContextClassLoader();      // it finds a student's classes
        return items.parallelStream().map(item -> {
            Thread worker = Thread.currentThread();
            ClassLoader before = worker.getContextClassLoader();
            worker.setContextClassLoader(classes);
            try {
                R result = task.apply(item);
                synchronized (done) {
                    reached(done.incrementAndGet() / (double) items.size(), name.apply(item));
                }
                return result;
            } finally {
                worker.setContextClassLoader(before);
            }
        }).toList();
    }
}
