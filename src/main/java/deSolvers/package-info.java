/**
 * The course's interface between a simulation and the methods that solve its differential equation, and the three
 * solvers that the slides spell out.
 *
 * <p>A {@link deSolvers.DEStateSource} knows its state s, its time t and its derivative ds/dt = f(s, t).
 * A {@link deSolvers.DESolver} advances it, knowing nothing else of it. The pair is small on purpose: a new solver is
 * one method, a new simulation is six short ones.
 *
 * <h2>From the slides' symbols to the names in the code</h2>
 * <table>
 * <caption>dictionary</caption>
 * <tr><th>slide</th><th>code</th><th>meaning</th></tr>
 * <tr><td>s</td><td>{@code state}</td><td>the state vector, in R<sup>n</sup></td></tr>
 * <tr><td>s with a dot</td><td>{@code dSdt}</td><td>its derivative with respect to time</td></tr>
 * <tr><td>t, &Delta;t</td><td>{@code time}, {@code deltaT}</td><td>time and time step</td></tr>
 * <tr><td>&Delta;s</td><td>{@code deltaS}</td><td>an Euler step, deltaT times dSdt</td></tr>
 * <tr><td>g<sub>mid</sub></td><td>{@code gMid}</td><td>the derivative half way through the step</td></tr>
 * <tr><td>k<sub>1</sub> ... k<sub>4</sub></td><td>{@code k1 ... k4}</td>
 *     <td>the stages of RK4; as on the slide they include the factor deltaT</td></tr>
 * <tr><td>k<sub>ij</sub>, l<sub>ij</sub>, k<sub>d</sub></td>
 *     <td>{@code stiffness}, {@code restLength}, {@code damping}</td><td>a spring's constants</td></tr>
 * <tr><td>r, k<sub>f</sub>, N</td><td>{@code restitution}, {@code friction}, {@code normal}</td>
 *     <td>what a plane does to a particle</td></tr>
 * </table>
 *
 * <p>Two letters of the field stand in the theory: h is deltaT, z is lambda deltaT for the test equation
 * s' = lambda s, and R(z) is the factor by which a method multiplies s in one step, its stability function.
 */
package deSolvers;
