package particles.teaching.exercises;

import java.util.List;
import java.util.stream.IntStream;
import particles.teaching.exercises.NumericExercise.Worked;

/** All exercises, in the order of the lecture; the first has the number 1. */
public final class Exercises {
    private static final double EARTH = 9.81;
    /** All of them. */
    public static final List<Exercise> ALL = List.of(SlideExercises.eulerSteps(), SlideExercises.eulerSpiral(),
            SlideExercises.midpointSteps(), SlideExercises.rk4Step(), SlideExercises.costOfRK4(),
            StepExercises.largestStep(), StepExercises.symplecticEnergy(), StepExercises.numericalDamping(),
            StepExercises.stiffSpring(), StepExercises.adaptiveStep(), bouncingBall(), new SceneDesign());

    private Exercises() {
    }

    /** The exercise on collisions: the time at which a ball meets the ground for the n-th time. */
    private static NumericExercise bouncingBall() {
        return new NumericExercise("Collisions: the n-th bounce", "s", 0.5, 15, """
                Where g = %s m/s^2, a ball falls from rest, its middle %s m above where it meets the ground. Each \
                bounce turns the velocity v into -r v with r = %s.
                When does it meet the ground for the %s time?
                ---
                Draw the height over time, and write down how long each flight takes.
                This is one bounce too early; the first contact counts as 1.
                This is one bounce too late; the first contact counts as 1.
                Between two bounces it flies up and down: each flight counts twice, only the first fall once.
                The first fall is only down: it counts once, the later flights twice.
                r multiplies the velocity, and a flight's time with it; not the energy or the height.
                The height goes with r^2, but a flight's time with r.
                The bounces lose energy: each flight is r times as long as the one before.
                This is g on Earth.
                This is the first contact.
                """, picks -> {
            double height = picks.decimal(50, 300, 2);
            double g = picks.of(1.62, 3.72, 8.87, 24.79);
            double r = picks.decimal(55, 90, 2);
            int bounce = picks.whole(3, 6);
            double first = Math.sqrt(2 * height / g);
            double sum = IntStream.range(0, bounce).mapToDouble(n -> StrictMath.pow(r, n)).sum();
            return new Worked(timeOf(bounce, height, g, r), 0,
                    List.of(g, height, r, bounce + (bounce == 3 ? "rd" : "th")), timeOf(bounce - 1, height, g, r),
                    timeOf(bounce + 1, height, g, r), first * sum, first * (2 * sum),
                    timeOf(bounce, height, g, Math.sqrt(r)), timeOf(bounce, height, g, r * r),
                    first * (2 * bounce - 1), timeOf(bounce, height, EARTH, r), first);
        });
    }

    private static double timeOf(int bounce, double height, double g, double r) {
        double flights = IntStream.range(1, bounce).mapToDouble(n -> StrictMath.pow(r, n)).sum();
        return Math.sqrt(2 * height / g) * (1 + 2 * flights);
    }
}
