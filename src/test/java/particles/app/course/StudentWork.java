package particles.app.course;

import particles.teaching.exercises.Draw;
import particles.teaching.exercises.Exercises;
import particles.teaching.exercises.NumericExercise;

/** What students hand in. */
final class StudentWork {
    private StudentWork() {
    }

    /** @return the source of a solver that adds this to each entry of the state */
    static String solver(String name, String increment) {
        return """
                package exercises;

                public class %s extends deSolvers.DESolver {
                    @Override
                    public void stepState(deSolvers.DEStateSource source, double deltaT) {
                        double[] state = new double[source.getStateSize()];
                        double[] dSdt = new double[source.getStateSize()];
                        source.getState(state);
                        source.getStateDerivative(dSdt);
                        for (int i = 0; i < state.length; i++) {
                            state[i] += %s;
                        }
                        source.setState(state);
                        source.incTime(deltaT);
                    }
                }
                """.formatted(name, increment);
    }

    /** @return the source of Euler's method, in a class MySolver */
    static String euler() {
        return solver("MySolver", "deltaT * dSdt[i]");
    }

    /** @return the line of answers.yaml that is right for a student's second exercise */
    static String answer(String student) {
        return "2: " + ((NumericExercise) Exercises.ALL.get(1)).worked(new Draw(student, 2)).answer() + "\n";
    }
}
