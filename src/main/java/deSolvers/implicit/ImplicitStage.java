package deSolvers.implicit;

import deSolvers.DEStateSource;
import deSolvers.FiniteCheck;
import deSolvers.JacobianStateSource;
import deSolvers.SecondOrderStateSource;
import deSolvers.StepTransaction;
import deSolvers.linear.ImplicitWork;
import java.util.Arrays;

/**
 * Solves the equation of all one-stage implicit methods, m = s + g f(m, t), at the source's present time, choosing how
 * by the size and the kind of the source.
 */
final class ImplicitStage {
    /**
     * States up to this size are solved with a full matrix, which fails in the fewest cases. It is not the fastest way
     * for radau: three steps of a chain of springs, k = 1e4, take it 0.21 s with a state of 50, 0.70 s of 100 and 7.2 s
     * of 300, and by GMRES with the source's products 0.05, 0.06 and 0.09 s.
     */
    static final int LARGEST_DENSE = 600;
    /** For one of Newton's corrections; the last of them reduces what is left by this much again. */
    private static final double LINEAR_TOLERANCE = 1e-4;
    /** For the only correction of the linearised equation. */
    private static final double LINEARISED_TOLERANCE = 1e-8;
    /** The path from g = 0 is followed in pieces no smaller than this part of the way. */
    private static final double SMALLEST_PIECE = 1.0 / 4096;
    /** A full matrix of so many rows is still made, of 100 MB, where GMRES fails. */
    static final int LARGEST_FULL = 2000;

    /** How the solution is looked for. */
    enum Way {
        /** The equation is linearised at s, and solved once. */
        LINEARISED,
        /**
         * Newton's method begins straight on along the velocities: near where they are those of the last step's motion.
         */
        STRAIGHT_ON,
        /**
         * It begins at the positions of s. Velocities may be those of a stiff spring that swings faster than the step
         * can follow; straight on leads past its other end then, where the equation has a second solution, with the
         * spring turned inside out.
         */
        FROM_PLACE
    }

    private final ImplicitWork.Counter work = new ImplicitWork.Counter();
    private final Newton newton = new Newton(work);
    private final DenseProblem dense = new DenseProblem(work);
    private final KrylovProblem krylov = new KrylovProblem(work);
    private final ReducedVelocityProblem velocities = new ReducedVelocityProblem(work);
    private int largestDense;                           // in this step: more once GMRES has failed
    private double[] unknowns = {};
    private double[] reached = {};
    private double[] scale = {};                        // how large the unknowns are where the step starts

    ImplicitWork getWork() {
        return work.read();
    }

    /**
     * Solves the equation.
     *
     * @param source     the step, its clock at the stage's time
     * @param start      s
     * @param gamma      g (s)
     * @param way        how to look for the solution
     * @param stage      receives m
     */
    void solve(StepTransaction source, double[] start, double gamma, Way way, double[] stage) {
        DEStateSource client = source.getClient();
        boolean byVelocity = givesBlocks(client);
        boolean linearised = way == Way.LINEARISED;
        int n = byVelocity ? start.length / 2 : start.length;
        if (unknowns.length != n) {
            unknowns = new double[n];
            reached = new double[n];
            scale = new double[n];
        }
        largestDense = LARGEST_DENSE;
        String failure = "";
        boolean solved = attempt(source, client, start, gamma, byVelocity, way);
        if (!solved) {
            failure = newton.describeFailure();
            failIfNotFinite(source, start, gamma, stage);
            if (!byVelocity && n > LARGEST_DENSE && n <= LARGEST_FULL) {
                largestDense = LARGEST_FULL;
                solved = attempt(source, client, start, gamma, false, way);
            }
        }
        if (!solved) {
            NewtonProblem problem = begin(source, client, start, gamma, byVelocity, LINEAR_TOLERANCE);
            setToStart(start, byVelocity, way);
            if (linearised || !newton.descend(problem, unknowns, scale)
                    && !follow(source, client, start, gamma, byVelocity, way)) {
                throw source.failure(-1, failure + "; deltaT is probably too large for what the forces do"
                        + " within it");
            }
        }
        if (byVelocity) {
            velocities.stage(unknowns, stage);
        } else {
            System.arraycopy(unknowns, 0, stage, 0, stage.length);
        }
    }

    private boolean attempt(StepTransaction source, DEStateSource client, double[] start, double gamma,
            boolean byVelocity,
                            Way way) {
        boolean linearised = way == Way.LINEARISED;
        NewtonProblem problem = begin(source, client, start, gamma, byVelocity,
                linearised ? LINEARISED_TOLERANCE : LINEAR_TOLERANCE);
        setToStart(start, byVelocity, way);
        return linearised ? newton.solveLinearised(problem, unknowns) : newton.solve(problem, unknowns, scale);
    }

    /**
     * Follows the solution m(g) from g = 0, where it is s, in pieces that double and halve as Newton's method allows.
     */
    private boolean follow(StepTransaction source, DEStateSource client, double[] start, double gamma,
            boolean byVelocity,
                           Way way) {
        setToStart(start, byVelocity, way);
        double done = 0;
        double piece = 0.5;
        while (done < 1) {
            System.arraycopy(unknowns, 0, reached, 0, unknowns.length);
            double next = Math.min(1, done + piece);
            NewtonProblem problem = begin(source, client, start, next * gamma, byVelocity, LINEAR_TOLERANCE);
            if (newton.solve(problem, unknowns, scale)) {
                done = next;
                piece *= 2;
            } else {
                System.arraycopy(reached, 0, unknowns, 0, unknowns.length);
                piece /= 2;
                if (piece < SMALLEST_PIECE) {
                    return false;
                }
            }
        }
        return true;
    }

    private NewtonProblem begin(StepTransaction source, DEStateSource client, double[] start, double gamma,
            boolean byVelocity,
                                double linearTolerance) {
        if (byVelocity) {
            velocities.begin(source, (JacobianStateSource) client, start, gamma, linearTolerance);
            return velocities;
        }
        if (start.length <= largestDense) {
            dense.begin(source, client, start, gamma);
            return dense;
        }
        krylov.begin(source, start, gamma, linearTolerance);
        return krylov;
    }

    private void setToStart(double[] start, boolean byVelocity, Way way) {
        if (!byVelocity) {
            System.arraycopy(start, 0, unknowns, 0, start.length);
            System.arraycopy(start, 0, scale, 0, start.length);
            return;
        }
        velocities.startVelocities(scale);
        if (way == Way.FROM_PLACE) {
            Arrays.fill(unknowns, 0);
        } else {
            System.arraycopy(scale, 0, unknowns, 0, scale.length);
        }
    }

    /**
     * Where not even an Euler step is finite, the source is to blame and not Newton's method; the guard finds out and
     * says so.
     */
    private static void failIfNotFinite(StepTransaction source, double[] start, double gamma, double[] euler) {
        source.setState(start);
        source.getStateDerivative(euler);
        for (int i = 0; i < start.length; i++) {
            euler[i] = start[i] + gamma * euler[i];
        }
        if (FiniteCheck.firstNonFinite(euler) >= 0) {
            source.finish(euler);
        }
    }

    static boolean givesBlocks(DEStateSource client) {
        return client instanceof JacobianStateSource && client instanceof SecondOrderStateSource
                && ((SecondOrderStateSource) client).getDimension() == 3 && client.getStateSize() > 0
                && ((JacobianStateSource) client).getJacobianBlocks() != JacobianStateSource.Blocks.NONE;
    }
}
