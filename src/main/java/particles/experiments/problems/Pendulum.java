package particles.experiments.problems;

/** A pendulum, theta'' = -sin theta, released at 1.5 rad. */
final class Pendulum extends TestProblem {
    Pendulum() {
        super(1.5, 0);
    }

    @Override
    protected void accelerate(double[] s, double[] dSdt) {
        dSdt[1] = -StrictMath.sin(s[0]);
    }
}
