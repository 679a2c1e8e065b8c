package particles.experiments.grid;

import deSolvers.text.DidYouMean;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import particles.experiments.grid.ParticlePath.Coordinate;
import particles.spec.Setting;
import particles.view.Axis;

/**
 * A quantity that is measured of a run.
 *
 * @param kind       what is measured
 * @param coordinate the coordinate of a particle; of other kinds, x
 * @param subject    the particle or the force; empty if the whole run is measured
 */
public record Measure(Kind kind, Coordinate coordinate, String subject) {
    private static final Pattern OF_PARTICLE = Pattern.compile("(?:(\\w+)\\s+)?(x|y|z|vx|vy|vz|speed)\\s+of\\s+(.+)");
    private static final Pattern OF_FORCE = Pattern.compile("work\\s+of\\s+(.+)");

    /** What can be measured. */
    public enum Kind {
        /** A coordinate at the end. */
        LAST("", ""),
        /** The least value of a coordinate. */
        MIN("min", ""),
        /** Its largest value. */
        MAX("max", ""),
        /** Half the distance between its last two turning points. */
        AMPLITUDE("amplitude", ""),
        /** The mean time from one maximum to the next. */
        PERIOD("period", "s"),
        /** The largest distance of a particle from the reference at the end. */
        ERROR("error", "m"),
        /** The difference of the reference from one with a hundred times the tolerance. */
        REFERENCE_ERROR("error of the reference", "m"),
        /** Kinetic plus potential energy at the end; gravity's potential counts from its lowest value. */
        ENERGY("energy", "J"),
        /** The kinetic energy at the end. */
        KINETIC("kinetic energy", "J"),
        /** Total energy at the start minus that at the end. */
        LOST("energy lost", "J"),
        /** The numerical error of the energy at the end, divided by the energy scale. */
        DRIFT("drift", ""),
        /** The same where it was largest. */
        LARGEST_DRIFT("largest drift", ""),
        /** The work that a force, an impact or a moving anchor did. */
        WORK("work of", "J"),
        /** Evaluations of the derivative. */
        EVALUATIONS("evaluations", ""),
        /** Steps of deltaT. */
        STEPS("steps", ""),
        /** The CPU time of a run without observers. */
        CPU_TIME("CPU time", "s"),
        /** The time of the first impact on a surface or of two balls. */
        FIRST_IMPACT("first impact", "s"),
        /** The number of steps, or parts of steps, that end in an impact. */
        IMPACTS("impacts", ""),
        /** The longest stable deltaT of the solver at the start. */
        STABLE("longest stable deltaT", "s");

        final String words;
        final String unit;

        Kind(String words, String unit) {
            this.words = words;
            this.unit = unit;
        }

        boolean isOfParticle() {
            return ordinal() <= PERIOD.ordinal();
        }

        /** Whether it is a whole number. */
        boolean isCount() {
            return this == EVALUATIONS || this == STEPS || this == IMPACTS;
        }

        /** Whether the solver or its step changes it by orders of magnitude. */
        private boolean isCost() {
            return this == ERROR || this == EVALUATIONS || this == STEPS || this == CPU_TIME || this == STABLE;
        }
    }

    /**
     * @param text measures as they were typed, separated by commas; {@code error} is followed by that of its reference
     * @return one or more measures
     * @throws IllegalArgumentException if one is empty, unknown or there twice
     */
    public static List<Measure> list(String text) {
        List<Measure> all = new ArrayList<>();
        for (String one : Setting.split(text, ',')) {
            if (one.isBlank()) {
                throw new IllegalArgumentException("a measure is empty");
            }
            Measure measure = of(one.strip());
            if (all.contains(measure)) {
                throw new IllegalArgumentException("'" + one.strip() + "' appears twice");
            }
            all.add(measure);
            if (measure.kind == Kind.ERROR) {
                all.add(new Measure(Kind.REFERENCE_ERROR, Coordinate.X, ""));
            }
        }
        return all;
    }

    private static Measure of(String text) {
        Matcher particle = OF_PARTICLE.matcher(text);
        String statistic = particle.matches() && particle.group(1) != null ? particle.group(1) : "";
        for (Kind kind : Kind.values()) {
            if (kind.isOfParticle() && particle.matches() && kind.words.equals(statistic)) {
                Coordinate coordinate = Coordinate.valueOf(particle.group(2).toUpperCase(Locale.ROOT));
                if (kind.ordinal() >= Kind.AMPLITUDE.ordinal() && coordinate.ordinal() >= Coordinate.VX.ordinal()) {
                    throw new IllegalArgumentException(kind.words + " is that of x, y or z");
                }
                return new Measure(kind, coordinate, particle.group(3));
            }
            if (!kind.isOfParticle() && kind != Kind.REFERENCE_ERROR && kind.words.equals(text)) {
                return new Measure(kind, Coordinate.X, "");
            }
        }
        Matcher force = OF_FORCE.matcher(text);
        if (force.matches()) {
            return new Measure(Kind.WORK, Coordinate.X, force.group(1));
        }
        throw new IllegalArgumentException("unknown measure '" + text + "'"
                + DidYouMean.hint(text, known(), "'%s'"::formatted) + " known: " + String.join(", ", known()));
    }

    /** @return the names of the measures, with those of a particle and a force as examples */
    public static List<String> known() {
        return Stream.concat(Stream.of("x of PARTICLE (or y, z, vx, vy, vz, speed)", "max x of PARTICLE",
                "min x of PARTICLE", "amplitude x of PARTICLE", "period x of PARTICLE", "work of FORCE"),
                Arrays.stream(Kind.values()).filter(kind -> !kind.isOfParticle() && kind != Kind.REFERENCE_ERROR
                && kind != Kind.WORK).map(kind -> kind.words)).toList();
    }

    /** @return its name, such as "max x of block" */
    public String name() {
        String of = kind.isOfParticle() ? coordinate.symbol + " of " + subject : subject;
        return (kind.words + " " + of).strip();
    }

    /** @return its unit; may be empty */
    public String unit() {
        return kind.isOfParticle() && kind != Kind.PERIOD ? coordinate.unit : kind.unit;
    }

    /** @return its axis in a chart, logarithmic where the x axis is and it changes by orders of magnitude */
    Axis axis(boolean log) {
        return new Axis(name(), unit(), log && kind.isCost());
    }
}
