package particles.output.files;

import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.util.function.IntToLongFunction;
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
 * in s, m and m/s, ids quoted by RFC 4180 where needed, lines ended by {@code \n}, UTF-8. It records the solver's own
 * states after rules have acted, never interpolated ones: the first, every stride-th after it, and the last. Other
 * observers do not change the file.
 */
public final class TrajectoryWriter implements Observer, AutoCloseable {
    /** The file's name. */
    public static final String FILE = "trajectory.csv";
    private static final String HEADER = "time,particle,x,y,z,vx,vy,vz\n";

    private final IntToLongFunction stride;
    private final OutputFile file;
    private final PrintWriter out;          // the file below it throws its errors itself
    private final StringBuilder line = new StringBuilder();
    private long step;
    private long written = -1;              // the last step of which the beginning was written; -1 before the first
    private boolean open = true;
    private ParticleSystem unwritten;       // whose present state is not in the file yet

    /**
     * For runs with births and deaths: the stride adapts to the number of particles.
     *
     * @param folder the output folder
     * @param stride the stride for this number of particles, 1 or more
     * @throws OutputException if the file cannot be written
     */
    public TrajectoryWriter(OutputFolder folder, IntToLongFunction stride) {
        this.stride = stride;
        file = folder.create(FILE);
        out = new PrintWriter(file, false, StandardCharsets.UTF_8);
        out.write(HEADER);
    }

    /**
     * Returns the stride that gives about this many lines. The limit also holds if the number of particles changes, as
     * each record of n lines comes at least n steps / lines steps after the previous one.
     *
     * @param steps     the steps of the run
     * @param particles their number now
     * @param lines     the largest number of lines
     * @return 1 or more; depends on nothing but the arguments
     */
    public static long strideFor(double steps, int particles, long lines) {
        return Math.max(1, (long) Math.ceil(steps * particles / lines));
    }

    @Override
    public void started(ParticleSystem system) {
        unwritten = system;
    }

    /** The beginning of a step is the end of the previous one after its rules. */
    @Override
    public void moved(Motion motion) {
        if (written < 0 || step - written >= stride.applyAsLong(motion.getSystem().getParticles().count())) {
            written = step;
            write(motion.getSystem(), motion.getStartState(), motion.getStartTime());
        }
        step++;
    }

    @Override
    public void finished(ParticleSystem system) {
        close();
    }

    /** Ends the file with the last state, also if the run ends early. */
    @Override
    public void close() {
        if (!open) {
            return;
        }
        if (unwritten != null) {
            write(unwritten, unwritten.getOwnState(), unwritten.getTime());
        }
        open = false;
        out.flush();
        file.commit();
    }

    /** Writes a state; a broken file is not committed. */
    private void write(ParticleSystem system, double[] state, double time) {
        Particles particles = system.getParticles();
        String t = Numbers.shortest(time);
        try {
            for (int i = 0, x = 0; i < particles.count(); i++, x += Particles.STRIDE) {
                line.setLength(0);
                line.append(t).append(',').append(quoted(particles.id(i)));
                for (int c = x; c < x + Particles.STRIDE; c++) {
                    line.append(',').append(Numbers.shortest(state[c]));
                }
                out.append(line.append('\n'));
            }
        } catch (OutputException e) {
            open = false;
            throw e;
        }
    }

    /** @return a field as RFC 4180 says: quoted, with doubled quotes, if it has a comma, quote or line break */
    public static String quoted(String field) {
        boolean isPlain = true;
        for (int k = 0; k < field.length(); k++) {      // no stream, since each line asks
            isPlain &= ",\"\n\r".indexOf(field.charAt(k)) < 0;
        }
        return isPlain ? field : '"' + field.replace("\"", "\"\"") + '"';
    }
}
