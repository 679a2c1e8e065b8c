/**
 * Programs that measure time, run by their own tasks and never by tests; tests check the counts behind them.
 *
 * <h2>All benchmarks: {@code gradle benchmark}</h2>
 * Steps of every solver, beside loops written by hand and the integrators of Hipparchus, reading a scene and drawing a
 * frame, by JMH, in three minutes. {@code -Pinclude=StepBenchmark} selects a class, {@code -Pworkload=chain}, {@code
 * -Pmethod=rk4,verlet}, {@code -Pintegrator=} and {@code -Pscene=} what is measured; {@code -Pforks=3 -Piterations=10}
 * gives closer means; {@code -Pmilliseconds} is the length of an iteration. JMH's table is also written to {@code
 * build/out/benchmark/benchmark.csv}.
 *
 * <p>{@code StepBenchmark} compares equal evaluations: the same steps of the same method on the same source. The loops
 * by hand show what the interface, the checks and the slides' form cost. {@code ErrorBenchmark} compares equal errors:
 * each has the coarsest steps or the loosest tolerance that ends within 1e-6 of a reference.
 * <table>
 * <caption>time of Hipparchus 4.0.3 over ours</caption>
 * <tr><th>equal</th><th>ours, Hipparchus</th><th>oscillator</th><th>chain of 100</th><th>cloth of 12 x 12</th></tr>
 * <tr><td>evaluations</td><td>{@code euler}, Euler</td><td>5.3</td><td>3.7</td><td>4.8</td></tr>
 * <tr><td>evaluations</td><td>{@code midpoint}, Midpoint</td><td>4.2</td><td>6.1</td><td>2.7</td></tr>
 * <tr><td>evaluations</td><td>{@code rk4}, ClassicalRungeKutta</td><td>5.5</td><td>4.4</td><td>2.0</td></tr>
 * <tr><td>error</td><td>{@code rk4}, ClassicalRungeKutta</td><td>4.7</td><td>4.3</td><td>2.8</td></tr>
 * <tr><td>error</td><td>{@code dormand-prince}, DormandPrince54</td><td>7.5</td><td>3.2</td><td>1.7</td></tr>
 * <tr><td>error</td><td>{@code bulirsch-stoer}, GraggBulirschStoer</td><td>15</td><td>3.5</td><td>2.2</td></tr>
 * <tr><td>error</td><td>{@code adams}, AdamsMoulton</td><td>48</td><td>12</td><td>15</td></tr>
 * </table>
 * Measured on 2026-11-22 in one run with the defaults, JDK 17, one thread, on two cores of a shared server without
 * other work of ours: medians of five iterations of 0.06 s, in a process for each, after as many that do not count.
 * With other work beside it, single rows differed by up to a factor of two. Adams-Moulton of Hipparchus chooses its
 * steps, ours does not.
 *
 * <h2>Stiff cloth: {@code gradle stiffCloth}</h2>
 * Measures the CPU time of a frame of 1/60 s of ever stiffer cloth of 64 x 64 particles: RK4, with up to 5,000 steps,
 * against one step of backward Euler with one linear solve. That step takes as long as some 100 steps of {@code rk4}: a
 * cloth for which {@code rk4} needs fewer is cheaper with it, and one for which it needs 5,000 takes 49 times as long
 * with it. Over all of that the implicit step's own time varies by a factor of 7 (medians of nine steps, on the same
 * machine with other work beside it).
 *
 * <h2>Pictures and starting up</h2>
 * A thread of its own draws and writes the pictures of a run: for a cloth of 64 x 64 particles at 1280 x 720 pixels, 32
 * a second on two cores with the simulation running beside it, and 27 with the animation. A film is compressed in pure
 * Java, some tenths of a second for a frame of that size. The installed program takes 2.5 s of CPU time, user and
 * system, for {@code run --scene=2 --frames=false} with its two charts: the median of five starts, without other work.
 */
package benchmarks;
