/**
 * The course's interface between a simulation and the methods that solve its differential equation, and three
 * of the four solvers that the slides write out.
 *
 * <p>A {@link deSolvers.DEStateSource} knows its state s, its time t and its derivative ds/dt = f(s, t).
 * A {@link deSolvers.DESolver} advances it and knows nothing else about it. The pair is small on purpose: a new solver
 * is one method, a new simulation is six short ones.
 *
 * <h2>The slides and the classes, line by line</h2>
 * A solver of one's own may be written the slides' way, as a plain {@link deSolvers.DESolver} with plain calls
 * ({@code gradle newSolver} writes such a class), or on {@link deSolvers.FixedStepSolver},
 * which makes the calls around the formula and keeps the contract:
 * <pre>
 * slide "Euler Solver Code"                      {@link deSolvers.EulerSolver}
 *
 *   source.getState(state);                        (FixedStepSolver)
 *   source.getStateDerivative(dSdt);               double[] dSdt = derivative(state);
 *   for (int i = 0; i &lt; n; i++)                    for (int i = 0; i &lt; state.length; i++) {
 *       state[i] += dSdt[i] * deltaT;                  state[i] += dSdt[i] * deltaT; }
 *   source.setState(state);                        (FixedStepSolver)
 *   source.incTime(deltaT);                        (FixedStepSolver)
 *
 * slide "Mid-point method: Algorithm"            {@link deSolvers.MidpointSolver}
 *
 *   &Delta;s = &Delta;t f(s, t)                                double[] deltaS = eulerStep(s, deltaT);
 *                                                  source.incTime(deltaT / 2);
 *   g_mid = f(s + &Delta;s/2, t + &Delta;t/2)                  double[] gMid = derivative(plus(s, 0.5, deltaS));
 *   s(t + &Delta;t) = s + &Delta;t g_mid                       s[i] += deltaT * gMid[i];
 *
 * slide "4th-Order Runge-Kutta Algorithm"        {@link deSolvers.RK4Solver}
 *
 *   k1 = &Delta;t f(s, t)           (Euler step)       double[] k1 = eulerStep(s, deltaT);
 *                                                  source.incTime(deltaT / 2);
 *   k2 = &Delta;t f(s + k1/2, t + &Delta;t/2)                  double[] k2 = eulerStep(plus(s, 0.5, k1), deltaT);
 *   k3 = &Delta;t f(s + k2/2, t + &Delta;t/2)                  double[] k3 = eulerStep(plus(s, 0.5, k2), deltaT);
 *                                                  source.incTime(deltaT / 2);
 *   k4 = &Delta;t f(s + k3, t + &Delta;t)                      double[] k4 = eulerStep(plus(s, 1, k3), deltaT);
 *   s(t + &Delta;t) = s + k1/6 + k2/3 + k3/3 + k4/6      s[i] = s[i] + 1.0 / 6 * k1[i] + ...
 * </pre>
 * The slides' fourth method, the "Simple Particle System Algorithm", is in {@code deSolvers.symplectic}.
 *
 * <h2>From the slides' symbols to the names in the code</h2>
 * <table>
 * <caption>dictionary</caption>
 * <tr><th>slide</th><th>code</th><th>meaning</th></tr>
 * <tr><td>s</td><td>{@code s}; {@code state} in EulerSolver</td><td>the state vector, in R<sup>n</sup></td></tr>
 * <tr><td>s with a dot</td><td>{@code dSdt}</td><td>its derivative with respect to time</td></tr>
 * <tr><td>t, &Delta;t</td><td>{@code time}, {@code deltaT}</td><td>time and time step</td></tr>
 * <tr><td>&Delta;s</td><td>{@code deltaS}</td><td>an Euler step, deltaT times dSdt</td></tr>
 * <tr><td>g<sub>mid</sub></td><td>{@code gMid}</td><td>the derivative half way through the step</td></tr>
 * <tr><td>k<sub>1</sub> ... k<sub>4</sub></td><td>{@code k1 ... k4}</td>
 *     <td>the four Euler steps of RK4; they include the factor deltaT</td></tr>
 * <tr><td>k<sub>ij</sub>, l<sub>ij</sub>, k<sub>d</sub></td>
 *     <td>{@code stiffness}, {@code restLength}, {@code damping}</td><td>a spring's constants</td></tr>
 * <tr><td>r, of planes</td><td>{@code restitution}</td><td>a bounce turns the normal velocity v into -r v</td></tr>
 * <tr><td>k<sub>f</sub></td><td>{@code coefficient} of the friction law {@code slide}</td>
 *     <td>friction for each unit of normal force and of sliding speed (s/m)</td></tr>
 * <tr><td><b>N</b></td><td>{@code normal}</td><td>a plane's normal, of length 1</td></tr>
 * <tr><td>-(<b>N</b> . F)</td><td>{@code push} in {@code NormalForces}</td>
 *     <td>the normal force, with which a plane pushes back (N)</td></tr>
 * <tr><td>r, of springs</td><td>{@code r}</td><td>the vector x<sub>j</sub> - x<sub>i</sub> along the spring</td></tr>
 * </table>
 *
 * <h2>Where the code differs from the slides</h2>
 * <ul>
 * <li>The friction force is -k<sub>f</sub> |<b>N</b> . F| v<sub>t</sub>. The slide has the opposite sign, with which
 *     friction would push a sliding particle forwards.</li>
 * <li>The relative velocity in the damped spring is v<sub>j</sub> - v<sub>i</sub>, the derivative of r; our copy of
 *     the slide has v<sub>i</sub> - v<sub>i</sub>, which would be 0.</li>
 * <li>The interface has {@code getStateSize}, {@code getTime} and {@code reset} besides the calls on the Euler solver's
 *     slide.</li>
 * <li>The slide's simple algorithm moves the clock before it computes the forces; here they are those at t.</li>
 * <li>The slides count wind among the global forces. Here it moves the air, and drag depends on the velocity relative
 *     to the air.</li>
 * </ul>
 *
 * <p>The javadoc uses three textbook symbols: h is deltaT, z is lambda h for the test equation s' = lambda s, and the
 * stability function R(z) is the factor by which a method multiplies s in one step. An undamped spring has the two
 * values lambda = i omega and -i omega. The small table at the top of a method is its Butcher tableau. Left of the bar
 * are the times of the evaluations, as fractions of the step; to the right the weights of the earlier derivatives;
 * below the line the weights of the result ({@code deSolvers.rungeKutta} has the formula).
 */
package deSolvers;
