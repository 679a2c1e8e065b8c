package browser;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.logging.Level;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.openqa.selenium.interactions.Actions;
import org.openqa.selenium.interactions.PointerInput;
import org.openqa.selenium.logging.LogType;

/** Opens the page for each test, and fails where the page reports an error of its own. */
abstract class LabPageTestCase {
    private static final String WORDS = """
            const element = id => document.getElementById(id), text = id => element(id).innerText.trim();
            const number = id => parseFloat(text(id)), value = id => element(id).value;
            const {view, energy, phase} = window.lab, state = view.moment?.state;
            const caption = () => document.querySelector('figcaption').textContent;
            const scene = () => document.querySelector('.CodeMirror').CodeMirror.getValue();
            """;
    Browser page;

    @BeforeEach
    void open() {
        page = Browser.open(1280, 900);
    }

    @AfterEach
    void closeWithoutMistakes() {
        List<String> mistakes = page.driver().manage().logs().get(LogType.BROWSER).getAll().stream()
                .filter(entry -> entry.getLevel() == Level.SEVERE).map(Object::toString).toList();
        page.close();
        assertEquals(List.of(), mistakes);
    }

    /** Waits until a script's expression holds; text(id), number(id) and value(id) are an element's. */
    void until(String expression) {
        page.await(expression, () -> (Boolean) page.script(WORDS + "return Boolean(" + expression + ");"));
    }

    double value(String expression) {
        return ((Number) page.script(WORDS + "return " + expression + ";")).doubleValue();
    }

    void edit(String from, String to) {
        page.script("""
                const code = document.querySelector('.CodeMirror').CodeMirror; const text = \
                code.getValue().replace(arguments[0], arguments[1]); code.replaceRange(text, {line: 0, ch: 0}, \
                {line: code.lineCount(), ch: 0}, '+input');""", from, to);
    }

    /** Presses a pointer on a particle; what it does next is added. A note above it may just have moved the picture. */
    Actions hold(PointerInput.Kind kind, int particle) {
        until("view.camera.camera.aspect === view.element.clientWidth / view.element.clientHeight");
        String place = "view.onScreen(" + particle + ")";
        return new Actions(page.driver()).setActivePointer(kind, "pointer").moveToLocation(
                (int) value("element('view').getBoundingClientRect().left + " + place + "[0]"),
                (int) value("element('view').getBoundingClientRect().top + " + place + "[1]")).clickAndHold();
    }

    void setStep(String seconds) {
        page.script("const step = document.getElementById('deltaTNumber'); step.value = arguments[0];"
                + " step.dispatchEvent(new Event('change'));", seconds);
        page.await("deltaT = " + seconds, () -> page.text("steps").equals("0")
                && ((Number) page.script("return window.lab.view.facts.deltaT;")).doubleValue()
                == Double.parseDouble(seconds));
    }

    void runToTheEnd() {
        page.choose("speed", "5");
        page.choose("atEnd", "stop");
        page.click("start");
        page.await("the end", () -> page.text("start").equals("Start") && page.number("steps") > 0);
    }

    /** The total energy at the end over that at the start. */
    double energyRatio() {
        return ((Number) page.script("""
                const data = window.lab.energy.data[1];
                return data[data.length - 1] / data[0];
                """)).doubleValue();
    }
}
