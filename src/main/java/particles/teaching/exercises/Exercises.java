package particles.teaching.exercises;

import java.util.List;
import particles.teaching.marking.Exercise;

/** All exercises, in the order of the lecture; the first has the number 1. */
public final class Exercises {
    private static final List<Exercise> ALL = List.of(SlideExercises.eulerSteps(), SlideExercises.eulerSpiral(),
            SlideExercises.midpointSteps(), SlideExercises.rk4Step(), SlideExercises.costOfRK4(),
            StepExercises.largestStep(), StepExercises.symplecticEnergy(), StepExercises.numericalDamping(),
            StepExercises.stiffSpring(), StepExercises.adaptiveStep(), BouncingBall.exercise(), new SceneDesign());

    private Exercises() {
    }

    /** @return all of them */
    public static List<Exercise> all() {
        return ALL;
    }
}
