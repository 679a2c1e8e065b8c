package particles.app.student;

import java.util.List;
import java.util.NoSuchElementException;
import java.util.TreeSet;
import particles.ParticleSystem;
import particles.law.Effect;
import particles.output.report.ResultPage;
import particles.teaching.Finding.Kind;
import particles.teaching.Finding;
import particles.teaching.effects.EffectCheck;
import particles.teaching.effects.EffectSample;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code gradle checkEffect -Peffect=exercises.MyGravity}: whether a force law keeps what it claims. */
@Command(name = CheckEffectCommand.NAME,
        description = "Checks a force law: whether it keeps what it claims, and what is wrong with it.")
public final class CheckEffectCommand extends CheckCommand {
    static final String NAME = "checkEffect";

    @Option(names = "--effect", paramLabel = "NAME", required = true, description = "An effect's name, as in scenes;"
            + " springs or damped-springs; or the class of your own.")
    private String effect;

    @Override
    String name() {
        return NAME;
    }

    @Override
    String subject() {
        return "--effect=" + effect;
    }

    @Override
    Checked check() {
        ParticleSystem system = EffectSample.system();
        String title;
        List<Finding> findings;
        try {
            Effect made = EffectSample.create(effect, system.getParticles(), new StudentClasses());
            findings = EffectCheck.check(system, made);
            title = made.getClass().getSimpleName() + ": the effect '" + made.getName() + "' claims "
                    + new TreeSet<>(made.getTraits());
        } catch (NoSuchElementException | IllegalArgumentException e) {
            title = effect + " cannot be checked.";
            findings = List.of(new Finding(Kind.FAILURE, String.valueOf(e.getMessage())));
        }
        return new Checked(title, findings, new ResultPage(NAME, title, paragraphs(findings), List.of(), List.of()));
    }
}
