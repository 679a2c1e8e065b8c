package particles.teaching.exercises;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.teaching.exercises.ThousandStudentsTest.numeric;

import deSolvers.RK4Solver;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import java.util.function.ToDoubleFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.effects.springs.SpringForce;
import particles.law.Vector3;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.SceneReader;

/** The right answers against closed forms, which read the numbers from the task's own text as a student does. */
class ClosedFormsTest {
    private static final int STUDENTS = 25;

    /** The number that follows the words; of a text in which they are there once. */
    private static double after(String text, String words) {
        Matcher matcher = Pattern.compile(Pattern.quote(words) + "(\\d+(?:\\.\\d+)?)").matcher(text);
        assertTrue(matcher.find(), words + " in " + text);
        return Double.parseDouble(matcher.group(1));
    }

    private static void hold(int number, double bound, ToDoubleFunction<String> closedForm) {
        NumericExercise exercise = numeric(number);
        for (int s = 0; s < STUDENTS; s++) {
            Draw draw = new Draw("student " + s, number);
            double expected = closedForm.applyAsDouble(exercise.text(draw));
            assertEquals(expected, exercise.worked(draw).answer(), bound * Math.abs(expected), exercise.text(draw));
        }
    }

    /** (re + i im)^n (x + i y). */
    private static double[] turned(double re, double im, int n, double x, double y) {
        double[] z = {x, y};
        for (int k = 0; k < n; k++) {
            z = new double[] {z[0] * re - z[1] * im, z[0] * im + z[1] * re};
        }
        return z;
    }

    /** With z = x + i v/omega the spring is z' = -i omega z, and a step of Euler multiplies by 1 - i omega deltaT. */
    @Test
    void eulerMultipliesByOneMinusIOmegaDeltaT() {
        hold(1, 1e-12, text -> {
            double omega = Math.sqrt(after(text, "k = ") / after(text, "m = "));
            return turned(1, -omega * after(text, "deltaT = "), 3, after(text, "x = "), after(text, "v = ") / omega)[0];
        });
    }

    @Test
    void eulerMultipliesTheEnergy() {
        hold(2, 1e-12, text -> {
            double h = after(text, "deltaT = ");
            return StrictMath.pow(1 + h * h * after(text, "k = ") / after(text, "m = "), after(text, "have "));
        });
    }

    /** v minus the motion b (t - m/c) that Runge-Kutta methods follow exactly is multiplied by R(-c deltaT/m). */
    private static double leaf(String text, int steps, int order) {
        double a = after(text, "c = ") / after(text, "m = ");
        double b = after(text, "b = ");
        double h = after(text, "deltaT = ");
        double r = 0;
        for (int k = order; k >= 0; k--) {
            r += StrictMath.pow(-a * h, k) / factorial(k);
        }
        return b * (steps * h - 1 / a) + (after(text, "v = ") + b / a) * StrictMath.pow(r, steps);
    }

    private static double factorial(int k) {
        return k < 2 ? 1 : k * factorial(k - 1);
    }

    @Test
    void midpointMultipliesByItsPolynomial() {
        hold(3, 1e-12, text -> leaf(text, 2, 2));
    }

    @Test
    void rk4MultipliesByItsPolynomial() {
        hold(4, 1e-12, text -> leaf(text, 1, 4));
    }

    /** Each wrong answer begins at the student's own start, too. */
    @Test
    void mistakesWithTheLeafBeginAtItsStart() {
        for (int number : new int[] {3, 4}) {
            NumericExercise exercise = numeric(number);
            Draw draw = new Draw("ann", number);
            double euler = DoubleStream.of(exercise.worked(draw).mistakes()).filter(slip -> exercise.mark(draw,
                    Double.toString(slip)).lines().get(0).contains("is the Euler method")).findFirst().orElseThrow();
            assertEquals(leaf(exercise.text(draw), number == 3 ? 2 : 1, 1), euler, 1e-12 * Math.abs(euler));
        }
    }

    /** The error of N steps is |R(-i h)^N - e^(-i omega T)|. */
    @Tag("slow")
    @Test
    void costFollowsFromTheStabilityFunctions() {
        hold(5, 1e-4, text -> {         // round-off may move the fewest steps by one in ten thousand
            double t = after(text, "followed for ") * after(text, "omega = ");
            double error = after(text, "may be ");
            return (double) fewest(t, error, z -> 1 - z * z / 2, z -> z) / (2 * fewest(t, error,
                    ClosedFormsTest::cosine,
                    ClosedFormsTest::sine));
        });
    }

    private static int fewest(double t, double error, DoubleUnaryOperator re, DoubleUnaryOperator im) {
        int few = 20;
        int enough = 1 << 20;
        while (enough - few > 1) {
            int n = (few + enough) / 2;
            double x = re.applyAsDouble(t / n);
            double y = im.applyAsDouble(t / n);
            double size = StrictMath.exp(n * StrictMath.log(x * x + y * y) / 2);
            double angle = n * StrictMath.atan2(y, x);
            boolean fits = StrictMath.hypot(size * StrictMath.cos(angle) - StrictMath.cos(t),
                    size * StrictMath.sin(angle) - StrictMath.sin(t)) <= error;
            few = fits ? few : n;
            enough = fits ? n : enough;
        }
        return enough;
    }

    /** The leading terms of these errors, N h^3/6 and N h^5/120, are right to 3 %,
            so that who uses them is. Measured 1.6 %. */
    @Test
    void costFollowsTheErrorsLeadingTerms() {
        hold(5, 0.02, text -> {
            double t = after(text, "followed for ") * after(text, "omega = ");
            double error = after(text, "may be ");
            double midpoint = Math.sqrt(t * t * t / (6 * error));
            double rk4 = StrictMath.pow(StrictMath.pow(t, 5) / (120 * error), 0.25);
            return midpoint / (2 * rk4);
        });
    }

    /** A thousandth below the answer RK4 is stable on the chain, and a thousandth above it is not. */
    @Test
    void theChainsFastestMotionSetsTheStep() {
        for (int s = 0; s < STUDENTS; s++) {
            NumericExercise exercise = numeric(6);
            Draw draw = new Draw("student " + s, 6);
            String text = exercise.text(draw);
            double answer = exercise.worked(draw).answer();
            int n = Integer.parseInt(text.substring(0, 1));
            double m = after(text, "m = ");
            double k = after(text, "k = ");
            assertTrue(growth(n, m, k, 0.999 * answer) < 1, text);
            assertTrue(growth(n, m, k, 1.001 * answer) > 10, text);
        }
    }

    /** The factor of the energy in 2000 steps; neighbours begin against each other. */
    private static double growth(int count, double m, double k, double deltaT) {
        ParticleSystem system = new ParticleSystem();
        SpringForce springs = new SpringForce(system.getParticles());
        for (int i = 0; i < count + 2; i++) {
            boolean wall = i == 0 || i == count + 1;
            double aside = wall ? 0 : i % 2 == 0 ? 1e-9 : -1e-9;
            system.addParticle("p" + i, m, new Vector3(i + aside, 0, 0), Vector3.ZERO, wall);
            if (i > 0) {
                springs.addSpring(i - 1, i, k, 1, 0);
            }
        }
        system.addEffect(springs);
        double before = system.getEnergy(system.getOwnState(), 0);
        for (int step = 0; step < 2000; step++) {
            new RK4Solver().stepState(system, deltaT);
        }
        return system.getEnergy(system.getOwnState(), 0) / before;
    }

    /** k x^2 + m v^2 - deltaT k x v stays what it is, and the energy is largest on the ellipse's diagonal. */
    @Test
    void symplecticEulersEnergySwingsOnAnEllipse() {
        hold(7, 1e-4, text -> 1 / (1 - after(text, "deltaT = ") * Math.sqrt(after(text, "k = ") / after(text,
                "m = ")) / 2));
    }

    @Test
    void backwardEulerDividesTheEnergy() {
        hold(8, 1e-9, text -> {
            double h = after(text, "deltaT = ");
            double m = after(text, "m = ");
            return m / h * StrictMath.log(1 + h * h * after(text, "k = ") / m);
        });
    }

    @Test
    void backwardEulersEquationIsSolvedByHand() {
        hold(9, 1e-9, text -> {
            double h = after(text, "deltaT = ");
            double m = after(text, "m = ");
            double k = after(text, "k = ");
            return (after(text, "has v = ") - h * k / m * after(text, "x = ")) / (1 + h * after(text, "c = ") / m
                    + h * h * k / m);
        });
    }

    @Test
    void theErrorsFifthRootSetsTheStep() {
        hold(10, 1e-9, text -> {
            double omega = Math.sqrt(after(text, "k = ") / after(text, "m = "));
            double h = after(text, "deltaT = ");
            double x = after(text, "x = ");
            double y = after(text, "v = ") / omega;
            double error = Math.abs(turned(cosine(h * omega), -sine(h * omega), 2, x,
                    y)[0] - turned(cosine(2 * h * omega),
                    -sine(2 * h * omega), 1, x, y)[0]);
            return h * StrictMath.pow(after(text, "error ") / error, 0.2);
        });
    }

    /** Real part of RK4's R(iz). */
    private static double cosine(double z) {
        return 1 - z * z / 2 + z * z * z * z / 24;
    }

    private static double sine(double z) {
        return z - z * z * z / 6;
    }

    @Test
    void flightsFormAGeometricSeries() {
        hold(11, 1e-7, text -> {
            int bounce = (int) after(text, "for the ");
            double fall = Math.sqrt(2 * after(text, "its middle ") / after(text, "g = "));
            Scene scene = SceneBuilder.build(SceneReader.read("a ball", """
                    title: A ball
                    teaches: When it bounces.
                    solver: rk4
                    deltaT: %s
                    duration: %s
                    impact: exact
                    particles: [{id: ball, position: [0, %s, 0]}]
                    effects: [gravity: {acceleration: [0, -%s, 0]}]
                    rules: [ground: {restitution: %s, restSpeed: 1e-9}]
                    """.formatted(fall / 16, fall * (2 * bounce + 1), after(text, "its middle "), after(text, "g = "),
                    after(text, "r = ")).getBytes(StandardCharsets.UTF_8)));
            List<Double> times = new ArrayList<>();
            scene.simulation().addObserver(new Observer() {
                @Override
                public void changed(ParticleSystem system, Rule rule) {
                    times.add(system.getTime());
                }
            });
            scene.simulation().run();
            return times.get(bounce - 1);
        });
    }

    /** Nobody can copy from a neighbour, and capitals or spaces in an id do no harm. */
    @Test
    void neighboursHaveOtherNumbers() {
        for (int number = 1; number <= Exercises.ALL.size(); number++) {
            List<String> texts = new ArrayList<>();
            for (String student : List.of("ann", "bob", "cy")) {
                texts.add(Exercises.ALL.get(number - 1).text(new Draw(student, number)));
            }
            assertEquals(3, texts.stream().distinct().count(), texts.toString());
            assertEquals(texts.get(0), Exercises.ALL.get(number - 1).text(new Draw(" ANN ", number)),
                    "the same at every call");
        }
    }

    /** These bits are promised: a student's numbers stay what they are from release to release. */
    @Test
    void drawsStayWhatTheyAre() {
        Draw.Picks picks = new Draw("ann", 1).picks();
        assertEquals(List.of(754, 870, 328), List.of(picks.whole(0, 999), picks.whole(0, 999), picks.whole(0, 999)));
    }
}
