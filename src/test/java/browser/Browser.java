package browser;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.stream.Stream;
import org.openqa.selenium.By;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.OutputType;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.chrome.ChromeDriver;
import org.openqa.selenium.chrome.ChromeDriverService;
import org.openqa.selenium.chrome.ChromeOptions;
import particles.app.run.LabCommand;
import particles.app.student.PageClasses;
import particles.lab.LabBuilder;
import particles.scene.SceneFiles;
import particles.scene.SceneReader;
import particles.spec.ClassNames;

/** The lab's page, opened from the disk in Chromium; with a student's solver in it. */
final class Browser implements AutoCloseable {
    /** Heun's method, as a student might write it. */
    static final String SOLVER = "exercises.HeunSolver";
    private static final String HEUN = """
            package exercises;

            import deSolvers.DEStateSource;
            import deSolvers.FixedStepSolver;

            public final class HeunSolver extends FixedStepSolver {
                @Override
                protected void step(DEStateSource source, double[] s, double deltaT) {
                    double[] k1 = eulerStep(s, deltaT);
                    source.incTime(deltaT);
                    double[] k2 = eulerStep(plus(s, 1, k1), deltaT);
                    for (int i = 0; i < s.length; i++) {
                        s[i] += (k1[i] + k2[i]) / 2;
                    }
                }
            }
            """;
    /** A method that is not finished. */
    static final String UNFINISHED = "exercises.UnfinishedSolver";
    private static final String HALF = """
            package exercises;

            import deSolvers.FixedStepSolver;

            public final class UnfinishedSolver extends FixedStepSolver {
                @Override
                protected void step(deSolvers.DEStateSource source, double[] s, double deltaT) {
                    throw new IllegalStateException("the second half is yet to be written");
                }
            }
            """;
    /** A force law with one key, as a student might write it. */
    static final String EFFECT = "exercises.Lift";
    private static final String LIFT = """
            package exercises;

            import particles.effects.EffectContext;
            import particles.effects.EffectKind;
            import particles.law.ParticleForce;
            import particles.law.Particles;
            import particles.law.Vector3;
            import particles.spec.Key;
            import particles.spec.NumberType;
            import particles.spec.Values;

            public class Lift extends ParticleForce {
                private final double acceleration;

                public Lift(Particles particles, double acceleration) {
                    super(particles);
                    this.acceleration = acceleration;
                }

                @Override
                protected Vector3 getForce(Vector3 position, Vector3 velocity, double mass, double time) {
                    if (acceleration > 1000 && time > 0.1) {
                        throw new IllegalStateException("no wing lifts like that");
                    }
                    return new Vector3(0, mass * acceleration, 0);
                }

                public static final class Keys extends EffectKind {
                    private static final Key<Double> ACCELERATION = NumberType.any("m/s^2").required(
                            "acceleration", "Upward acceleration.");

                    public Keys() {
                        super("exercises.Lift", "Pushes all particles up.", ACCELERATION);
                    }

                    @Override
                    public void build(Values values, EffectContext scene) {
                        scene.add(new Lift(scene.particles(), values.get(ACCELERATION)));
                    }
                }
            }
            """;
    private static final Logger LOG = Logger.getLogger("org.openqa.selenium");
    private static final Duration PATIENCE = Duration.ofMinutes(5);
    private static final int PAUSE = 50;

    private final ChromeDriver driver;

    private Browser(ChromeDriver driver) {
        this.driver = driver;
    }

    /** Builds the page once for all tests: that takes half a minute. */
    private static final class Page {
        private static final Path FILE = build();

        private static Path build() {
            try {
                Path folder = Files.createDirectories(Path.of("build", "tmp", "browserTests"));
                Path exercises = Files.createDirectories(folder.resolve("exercises"));
                Files.writeString(exercises.resolve("HeunSolver.java"), HEUN);
                Files.writeString(exercises.resolve("UnfinishedSolver.java"), HALF);
                Files.writeString(exercises.resolve("Lift.java"), LIFT);
                LabBuilder builder = Class.forName("particles.lab.compile.PageBuilder").asSubclass(LabBuilder.class)
                        .getConstructor().newInstance();
                List<Path> scenes = SceneFiles.list(Path.of("scenes"));
                Path own = Files.createTempDirectory(folder, "lab");
                List<String> solvers = List.of(SOLVER, UNFINISHED);
                Map<Path, String> texts = new LinkedHashMap<>();
                scenes.forEach(file -> texts.put(file, SceneReader.withFiles(file, ClassNames.none(), List.of())));
                String page = builder.build(new LabBuilder.Contents(texts, LabCommand.pictures(scenes),
                        SceneFiles.find(Path.of("scenes"), "2"), "", solvers,
                        PageClasses.compile(solvers, List.of(EFFECT), exercises, own)), own);
                return Files.writeString(folder.resolve("index.html"), page);
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            } catch (ReflectiveOperationException e) {
                throw new LinkageError("the page cannot be built", e);
            }
        }
    }

    /** @return the page's file */
    static Path page() {
        return Page.FILE;
    }

    /**
     * Opens the page.
     *
     * @param width  of the window (pixels)
     * @param height of the window
     * @throws IllegalStateException where Chromium or its driver is missing
     */
    static Browser open(int width, int height) {
        LOG.setLevel(Level.SEVERE);                     // it warns that it does not know the newest Chromium
        ChromeOptions options = new ChromeOptions();
        options.setBinary(program("chromium"));
        options.addArguments("--headless=new", "--no-sandbox", "--disable-dev-shm-usage",
                "--enable-unsafe-swiftshader", "--force-prefers-reduced-motion");    // scenes wait for Start
        ChromeDriverService service = new ChromeDriverService.Builder().usingDriverExecutable(program("chromedriver"))
                .usingAnyFreePort().build();
        Browser browser = new Browser(new ChromeDriver(service, options));
        browser.driver.manage().window().setSize(new Dimension(width, height));
        browser.driver.manage().timeouts().scriptTimeout(Duration.ofMinutes(5));
        browser.go(page().toUri().toString());
        return browser;
    }

    /** Goes to an address of the page, even if it differs from the present one only after #. */
    void go(String address) {
        driver.get("about:blank");
        driver.get(address);
        awaitFirstScene();
    }

    /** Loads the page again; the driver may go on before the old page has gone. */
    void reload() {
        script("window.old = true;");
        driver.navigate().refresh();
        await("new page", () -> (Boolean) script("return !window.old;"));
        awaitFirstScene();
    }

    private void awaitFirstScene() {
        await("the first scene", () -> (Boolean) script("return Boolean(window.lab?.view.facts);"));
    }

    private static File program(String name) {
        return Stream.of(System.getenv("PATH").split(File.pathSeparator)).map(folder -> new File(folder, name))
                .filter(File::canExecute).findFirst()
                .orElseThrow(() -> new IllegalStateException("there is no " + name
                        + " here; on Debian: sudo apt-get install chromium chromium-driver"));
    }

    /** Waits until something is so. */
    void await(String what, Condition condition) {
        long end = System.nanoTime() + PATIENCE.toNanos();
        while (!condition.holds()) {
            if (System.nanoTime() > end) {
                throw new AssertionError("still no " + what + " after " + PATIENCE.toSeconds() + " s; the page says: "
                        + text("message") + text("errors") + "; it shows "
                        + script("return [window.lab?.view.facts?.title, document.body.className, location.hash]"));
            }
            sleep(PAUSE);
        }
    }

    /** Something that becomes true. */
    interface Condition {
        boolean holds();
    }

    static void sleep(int milliseconds) {
        try {
            Thread.sleep(milliseconds);
        } catch (InterruptedException e) {
            throw new LinkageError("the page cannot be built", e);
        }
    }

    WebElement element(String id) {
        return driver.findElement(By.id(id));
    }

    String text(String id) {
        return element(id).getText();
    }

    double number(String id) {
        return Double.parseDouble(text(id).replaceAll("[^0-9.e-]+$", ""));
    }

    void click(String id) {
        element(id).click();
    }

    /** Chooses an entry of a list. */
    void choose(String id, String value) {
        script("const list = document.getElementById(arguments[0]); list.value = arguments[1];"
                + " list.dispatchEvent(new Event('change'));", id, value);
    }

    /** Opens one of the page's scenes and waits until it is there. */
    void openScene(String name) {
        script("window.before = window.lab.view.facts;");
        choose("scene", name + ".yaml");
        await(name, () -> (Boolean) script("return window.lab.view.facts !== window.before;"));
    }

    Object script(String script, Object... arguments) {
        return driver.executeScript(script, arguments);
    }

    /** A script that calls its last argument with its result. */
    Object later(String script, Object... arguments) {
        return driver.executeAsyncScript(script, arguments);
    }

    /** Saves what is seen. */
    void screenshot(String name) {
        try {
            Files.write(page().resolveSibling(name + ".png"), driver.getScreenshotAs(OutputType.BYTES));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    ChromeDriver driver() {
        return driver;
    }

    @Override
    public void close() {
        driver.quit();
    }
}
