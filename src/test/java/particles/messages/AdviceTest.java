package particles.messages;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.catalog.SolverCatalog;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import particles.SimulationException;
import particles.app.student.StudentClasses;
import particles.scene.Overrides;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.SceneFiles;
import particles.scene.SceneReader;
import particles.scene.format.SceneDescription;

/** Whatever scene blows up with whatever solver: what the message tells to try works. */
@Tag("slow")
class AdviceTest {
    private static final Pattern OPTION = Pattern.compile("--(deltaT|solver)=([^\\s,]+)");
    /** A blow-up needs some steps, and advice that does not help shows within some seconds of simulated time. */
    private static final double MOST_SECONDS = 3;
    private static final int MOST_PARTICLES = 100;
    /** Of the scene's own deltaT: beyond the limit of every explicit solver, in all scenes with springs. */
    private static final double TOO_LONG = 12;

    private static Optional<String> failure(SceneDescription described, Map<String, String> options) {
        Overrides overrides = new Overrides();
        options.forEach((name, value) -> overrides.with(name, value, "--" + name));
        Scene scene = SceneBuilder.build(overrides.applyTo(described));
        try {
            scene.simulation().run();
            return Optional.empty();
        } catch (SimulationException e) {
            return Optional.of(new BlowUpMessage(scene, name -> "--" + name).of(e));
        }
    }

    @Test
    void whatTheMessageTellsToTryWorks() {
        List<String> wrong = new ArrayList<>();
        int blowUps = 0;
        for (Path file : SceneFiles.list(Path.of("scenes"))) {
            SceneDescription described = SceneReader.read(file, new StudentClasses());
            Scene scene = SceneBuilder.build(described);
            if (scene.system().getParticles().count() > MOST_PARTICLES || scene.springs().springCount() == 0) {
                continue;
            }
            for (String solver : SolverCatalog.names()) {
                Map<String, String> options = new TreeMap<>(Map.of("solver", solver,
                        "deltaT", Double.toString(TOO_LONG * described.deltaT()),
                        "duration", Double.toString(Math.min(MOST_SECONDS, described.duration()))));
                Optional<String> first = failure(described, options);
                if (first.isEmpty()) {
                    continue;
                }
                blowUps++;
                String message = first.get();
                assertEquals(3, message.lines().count(), message);
                Matcher advice = OPTION.matcher(message.replaceFirst(", or .*", ""));
                while (advice.find()) {
                    options.put(advice.group(1), advice.group(2));
                }
                Optional<String> second = failure(described, options);
                if (second.isPresent() && second.get().contains("solver=radau")) {      // advised where Newton fails
                    options.put("solver", "radau");
                    second = failure(described, options);
                }
                second.ifPresent(line -> wrong.add(file.getFileName() + ": " + message + "\n-> " + line));
            }
        }
        assertEquals(List.of(), wrong, String.join("\n\n", wrong));
        assertTrue(blowUps >= 30, blowUps + " blow-ups");           // measured: 45
    }
}
