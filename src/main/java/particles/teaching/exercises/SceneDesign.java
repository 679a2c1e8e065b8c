package particles.teaching.exercises;

import deSolvers.catalog.SolverCatalog;
import java.nio.file.InvalidPathException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.DoublePredicate;
import java.util.function.Function;
import java.util.stream.IntStream;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.energy.EnergyHistory;
import particles.energy.EnergyLedger;
import particles.experiments.runs.SceneRun;
import particles.experiments.runs.SceneRun.Outcome;
import particles.law.Particles;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.SceneReader;
import particles.scene.format.SceneDescription;
import particles.spec.messages.InvalidInputException;
import particles.teaching.exercises.Draw.Picks;
import particles.teaching.exercises.Exercise.Mark;

/** The exercise to design a scene: it runs a student's scene file and checks the conditions of the task. */
final class SceneDesign implements Exercise {
    private static final int MOST_PARTICLES = 500;
    private static final double ACCURACY = 0.01;

    /**
     * The conditions of the task.
     *
     * @param particles   the least number of particles that can move
     * @param springs     the least number of springs
     * @param bounces     the least number of impacts that reverse a component of a particle's velocity
     * @param duration    the least duration (s)
     * @param lost        the least part of the energy scale that damping, drag and impacts take
     * @param evaluations the largest number of evaluations of the derivative
     */
    private record Wanted(int particles, int springs, int bounces, double duration, double lost, long evaluations) {
    }

    @Override
    public String title() {
        return "Design a scene";
    }

    private static Wanted wanted(Draw draw) {
        Picks picks = draw.picks();
        int particles = picks.whole(3, 9);
        return new Wanted(particles, particles + picks.whole(0, 4), picks.whole(2, 8), picks.decimal(20, 60, 1),
                picks.decimal(2, 6, 1),
                1000L * picks.whole(20, 60));
    }

    @Override
    public String text(Draw draw) {
        return "Write a scene file of something that falls, bounces and loses its motion by honest physics. The answer"
                + " is the file's path. It is run, and has to do all of this:\n  - " + String.join("\n  - ",
                names(wanted(draw)));
    }

    private static List<String> names(Wanted wanted) {
        return """
                solver: one of the catalogue, and not euler
                at least %s particles that can move, at most %s
                at least %s springs
                duration: at least %s s
                it runs to its end, with at most %s evaluations of the derivative
                at least %s bounces off the ground or another surface
                damping, drag and bounces take at least %s of the energy scale (the largest energy of motion and \
                springs)
                the numerical error of the energy at the end is below %s of that scale
                """.formatted(wanted.particles(), MOST_PARTICLES, wanted.springs(), Draw.text(wanted.duration()),
                wanted.evaluations(), wanted.bounces(), Draw.text(wanted.lost()), ACCURACY).lines().toList();
    }

    @Override
    public Mark mark(Draw draw, String answer, Function<String, byte[]> files) {
        if (answer.isBlank()) {
            return Mark.wrong("The answer is empty; the path of a scene file is wanted, such as my-scene.yaml.");
        }
        Scene scene;
        try {
            SceneDescription description = SceneReader.read(answer.strip().replace('\\', '/'),
                    files.apply(answer.strip()));
            if (!SolverCatalog.names().contains(description.solver())) {
                return Mark.wrong("does not hold: " + names(wanted(draw)).get(0) + " (here: "
                        + description.solver() + ")");
            }
            scene = SceneBuilder.build(description);
        } catch (InvalidInputException e) {
            return new Mark(false, e.getLines());
        } catch (InvalidPathException e) {
            return Mark.wrong("'" + answer.strip() + "' is no path of a file: " + e.getReason());
        }
        return run(wanted(draw), scene);
    }

    private static Mark run(Wanted wanted, Scene scene) {
        Particles particles = scene.system().getParticles();
        long moving = particles.free().count();
        String solver = scene.description().solver();
        double duration = scene.description().duration();
        int springs = scene.springs().springCount();
        Report report = new Report(names(wanted));
        report.hold(!solver.equals("euler"), solver);
        report.hold(moving >= wanted.particles() && moving <= MOST_PARTICLES, moving + " can move");
        report.hold(springs >= wanted.springs(), springs + " springs");
        report.hold(duration >= wanted.duration(), Draw.text(duration) + " s");
        if (moving > MOST_PARTICLES) {
            return report.mark();
        }
        EnergyLedger ledger = new EnergyLedger();
        EnergyHistory history = new EnergyHistory();
        Bounces bounces = new Bounces();
        Outcome outcome = SceneRun.run(scene, wanted.evaluations(), List.of(ledger, history, bounces));
        report.hold(outcome.failure().isEmpty(), outcome.failure().orElse(outcome.evaluations() + " evaluations"));
        if (outcome.failure().isPresent()) {
            return report.mark();
        }
        double scale = history.getScale();
        double taken = -ledger.getWork().values().stream().mapToDouble(joules -> Math.min(0, joules)).sum();
        report.hold(bounces.count >= wanted.bounces(), bounces.count + " bounces");
        report.holdPart(part -> part >= wanted.lost(), taken, scale);
        report.holdPart(part -> Math.abs(part) <= ACCURACY, ledger.getNumericalError(), scale);
        return report.mark();
    }

    /** The conditions that hold and those that do not, in the order of the task. */
    private static final class Report {
        private final List<String> names;
        private final List<String> lines = new ArrayList<>();
        private boolean right = true;

        Report(List<String> names) {
            this.names = names;
        }

        void hold(boolean holds, String found) {
            right &= holds;
            lines.add((holds ? "holds: " : "does not hold: ") + names.get(lines.size()) + " (here: " + found + ")");
        }

        void holdPart(DoublePredicate holds, double energy, double scale) {
            hold(scale > 0 && holds.test(energy / scale), String.format(Locale.ROOT, "%.3g", scale > 0 ? energy / scale
                    : 0));
        }

        /** A condition that could not be checked counts as not met. */
        Mark mark() {
            int found = lines.size();
            names.stream().skip(found).forEach(name -> lines.add("not looked at: " + name));
            return new Mark(right && found == names.size(), lines);
        }
    }

    /** Counts the times that a rule reversed a particle's velocity. */
    private static final class Bounces implements Observer {
        private int count;
        private double[] before = {};

        @Override
        public void moved(Motion motion) {
            before = motion.getEndState().clone();
        }

        @Override
        public void changed(ParticleSystem system, Rule rule) {
            double[] after = system.getOwnState();
            if (!rule.getName().contains("impact") || before.length != after.length) {
                return;
            }
            for (int i = 0; i < after.length; i += Particles.STRIDE) {
                int first = i + Particles.STRIDE / 2;           // of its velocity
                count += IntStream.range(first, i + Particles.STRIDE).anyMatch(k -> before[k] * after[k] < 0) ? 1 : 0;
            }
        }
    }
}
