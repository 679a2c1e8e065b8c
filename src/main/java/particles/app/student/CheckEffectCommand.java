package particles.app.student;

import java.util.List;
import java.util.NoSuchElementException;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;
import particles.app.student.Check.Checked;
import particles.law.Effect;
import particles.law.Particles;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.effects.EffectCheck;
import particles.teaching.effects.EffectSample;
import particles.teaching.effects.ForceDirection;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/**
 * {@code gradle checkEffect -Peffect=exercises.MyGravity}: checks whether a force law has the properties that it
 * declares.
 */
@Command(name = CheckEffectCommand.NAME,
        description = "Checks a force law: whether it has the properties that it claims.")
public final class CheckEffectCommand extends CheckCommand {
    /** The name of the command. */
    public static final String NAME = "checkEffect";

    @Option(names = "--effect", paramLabel = "NAME", required = true, description = "An effect's name, as in scenes;"
            + " springs or damped-springs; or the class of your own.")
    private String effect;

    @Override
    Check check() {
        return new Check(NAME, effect, "");
    }

    /** Checks the effect of this name or class; runs its code. */
    static Checked checked(String subject) {
        try {
            Function<Particles, Effect> law = particles -> EffectSample.create(subject, particles,
                    new StudentClasses());
            Effect made = law.apply(EffectSample.system().getParticles());
            List<Finding> findings = EffectCheck.check(law);
            boolean right = findings.stream().noneMatch(Finding::isWrong);
            if (right && PlainRuns.differ(run -> EffectCheck.check(particles -> {
                run.run();
                return law.apply(particles);
            }), before -> PlainRuns.effect(law, before))) {
                findings = List.of(new Finding(Kind.FAILURE, "outside this check, or after many calls, its forces"
                        + " differ from those in this check"));
            }
            return new Checked(made.getClass().getSimpleName(), "The effect '" + made.getName() + "' claims "
                    + claims(made.getTraits()) + "." + (right ? ForceDirection.of(law) : ""), findings);
        } catch (NoSuchElementException | IllegalArgumentException e) {
            return new Checked(subject, e);
        }
    }

    private static String claims(Set<Effect.Trait> traits) {
        return traits.isEmpty() ? "no property"
                : new TreeSet<>(traits).stream().map(Enum::name).collect(Collectors.joining(", "));
    }
}
