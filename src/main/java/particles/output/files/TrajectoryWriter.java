package particles.output.files;

import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.law.Particles;

/**
 * Writes {@code trajectory.csv} while the run goes on: one line for each particle and recorded time,
 * <pre>
 * time,particle,x,y,z,vx,vy,vz
 * 0.0,bob,1.0,0.0,0.0,0.0,0.0,0.0
 * </pre>
 * in s, m and m/s, ids quoted as RFC 4180 says where they need it, lines ended by {@code \n}, UTF-8. Recorded are the
 * solver's own states, after rules have acted, never interpolated ones: the first, every stride-th after it, and the
 * last. The bytes depend on the trajectory alone, whatever else observes the run.
 */
public final class TrajectoryWriter implements Observer, AutoCloseable {
    /** The file's name. */
    public static final String FILE = "trajectory.csv";
    private static final String HEADER = "time,particle,x,y,z,vx,vy,vz\n";

    private final long stride;
    private final OutputFile file;
    private final Writer out;
    private long step;
    private boolean open = true;
    private ParticleSystem unwritten;       // whose present state is not in the file yet

    /**
     * @param folder where the file goes
     * @param stride every how many steps a state is written, 1 or more
     * @throws OutputException if the file cannot be written
     */
    public TrajectoryWriter(OutputFolder folder, long stride) {
        if (stride < 1) {
            throw new IllegalArgumentException("the stride has to be 1 or more, not " + stride);
        }
        this.stride = stride;
        file = folder.create(FILE);
        out = new OutputStreamWriter(file, StandardCharsets.UTF_8);
        attempt(() -> out.write(HEADER));
    }

    /**
     * Keeps every stride fine enough and every file small enough: the stride with which about this many lines come out.
     *
     * @param steps     the steps of the run
     * @param particles its particles
     * @param lines     how many lines are wanted at most
     * @return 1 or more; depends on nothing but the arguments
     */
    public static long strideFor(double steps, int particles, long lines) {
        return Math.max(1, (long) Math.ceil(steps * particles / lines));
    }

    @Override
    public void started(ParticleSystem system) {
        unwritten = system;
    }

    /** The beginning of a step is the end of the one before it, with all that rules did there. */
    @Override
    public void moved(Motion motion) {
        if (step % stride == 0) {
            write(motion.getSystem(), motion.getStartState(), motion.getStartTime());
        }
        step++;
    }

    @Override
    public void finished(ParticleSystem system) {
        close();
    }

    /** Ends the file with the state that was reached: that is a whole file, too, when a run has to end early. */
    @Override
    public void close() {
        if (!open) {
            return;
        }
        if (unwritten != null) {
            write(unwritten, unwritten.getOwnState(), unwritten.getTime());
        }
        open = false;
        attempt(out::flush);
        file.commit();
    }

    private void write(ParticleSystem system, double[] state, double time) {
        Particles particles = system.getParticles();
        String t = Numbers.shortest(time);
        attempt(() -> {
            for (int i = 0, x = 0; i < particles.count(); i++, x += Particles.STRIDE) {
                out.write(t);
                out.write(',');
                out.write(quoted(particles.id(i)));
                for (int c = x; c < x + Particles.STRIDE; c++) {
                    out.write(',');
                    out.write(Numbers.shortest(state[c]));
                }
                out.write('\n');
            }
        });
    }

    /** RFC 4180: a field with a comma, a quote or a line break stands in quotes, and its own quotes are doubled. */
    static String quoted(String field) {
        for (int i = 0; i < field.length(); i++) {
            char c = field.charAt(i);
            if (c == ',' || c == '"' || c == '\n' || c == '\r') {
                return '"' + field.replace("\"", "\"\"") + '"';
            }
        }
        return field;
    }

    @FunctionalInterface
    private interface Action {
        void run() throws IOException;
    }

    /**
     * The file tells its own troubles, so that none is left for the writer around it. A broken file is not committed.
     */
    private void attempt(Action action) {
        try {
            action.run();
        } catch (OutputException e) {
            open = false;
            throw e;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
