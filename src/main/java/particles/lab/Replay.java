package particles.lab;

import deSolvers.text.Digits;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import particles.Observer;
import particles.energy.EnergyLedgerRecorder;
import particles.lab.Frame.Structure;
import particles.scene.Scene;
import particles.spec.JsonText;

/** A run recorded for the lab's page, which shows it without computing anything. */
public final class Replay {
    /** The file's name. */
    public static final String FILE = "replay.html";
    /** The largest page (bytes), and the memory for the states of a run. */
    private static final int MOST_BYTES = 10_000_000;
    private static final long MEMORY = 64_000_000;

    private final Scene scene;
    private final FrameRecorder recorder;

    /**
     * @param scene  a scene that is about to run
     * @param ledger the energy ledger of its run
     */
    public Replay(Scene scene, EnergyLedgerRecorder ledger) {
        this.scene = scene;
        recorder = new FrameRecorder(scene, ledger, MEMORY);
    }

    /** @return records the run; to be called after the energy ledger */
    public Observer getRecorder() {
        return recorder;
    }

    /** @return says which states were left out, if some were */
    public Optional<String> thinning() {
        double interval = recorder.getHistory().getInterval();
        return interval > 0 ? Optional.of("states closer than " + Digits.few(interval)
                + " s are left out, to stay below 10 MB") : Optional.empty();
    }

    /**
     * @param file    the scene file's name
     * @param text    its text
     * @param failure why the run ended early; empty if it did not
     * @return the page; where it would be too large, every second state is left out until it is not
     */
    public String page(String file, String text, String failure) {
        return page(file, text, failure, MOST_BYTES);
    }

    String page(String file, String text, String failure, int mostBytes) {
        try {
            String scenes = PageParts.scene(file, text, " data-first=\"\"");
            while (true) {
                String page = PageParts.page("const RECORDED = " + recorded(failure) + ";\n"
                        + PageParts.own("recorded.js"), scenes, List.of());
                if (page.length() <= mostBytes || !recorder.getHistory().thin()) {
                    return page;
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private String recorded(String failure) {
        List<Frame> frames = recorder.getHistory().after(Double.NEGATIVE_INFINITY);
        Map<Structure, Integer> structures = new LinkedHashMap<>();
        frames.forEach(frame -> structures.putIfAbsent(frame.structure(), structures.size()));
        String floats = Session.base64(Stream.concat(structures.keySet().stream().map(Structure::numbers),
                frames.stream().flatMap(frame -> Stream.of(frame.energies(), frame.state()))).toList());
        Map<String, Object> facts = SceneFacts.of(scene, recorder);
        facts.put("numbers", List.of());
        facts.put("recorded", thinning().orElse(""));
        return JsonText.compact(JsonText.map("facts", facts,
                "ids", structures.keySet().stream().map(structure -> List.of(structure.ids())).toList(),
                "lengths", structures.keySet().stream().map(structure -> structure.numbers().length).toList(),
                "times", frames.stream().map(Frame::time).toList(),
                "steps", frames.stream().map(frame -> frame.account().steps()).toList(),
                "evaluations", frames.stream().map(frame -> frame.account().evaluations()).toList(),
                "structureOf", frames.stream().map(frame -> structures.get(frame.structure())).toList(),
                "failure", failure, "floats", floats));
    }
}
