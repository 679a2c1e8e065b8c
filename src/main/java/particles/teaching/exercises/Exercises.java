package particles.teaching.exercises;

import java.util.List;
import particles.teaching.marking.Exercise;

/** All exercises, in the order of the lecture; the first has the number 1. */
public final class Exercises {
    private static final List<Exercise> ALL = List.of(new EulerSteps(), new EulerSpiral(), new MidpointSteps(),
            new RK4Step(), new CostOfRK4(),
            new LargestStep(), new SymplecticEnergy(), new NumericalDamping(), new StiffSpring(), new AdaptiveStep(),
                    new BouncingBall(), new SceneDesign());

    private Exercises() {
    }

    /** @return all of them */
    public static List<Exercise> all() {
        return ALL;
    }
}
