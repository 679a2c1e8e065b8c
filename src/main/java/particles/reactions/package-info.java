/**
 * Forces that depend on the sum of all others: contact, friction, rods, wires and balls on balls. They are added after
 * all effects. This page is their theory.
 *
 * <p><b>Letters.</b> The slides': position x, velocity v, mass m, force F, unit normal N, distance d from a surface
 * (m), restitution r, friction k<sub>f</sub> (s/m). Ours: lambda, the force of a constraint (N); mu, Coulomb's
 * coefficient, and mu<sub>s</sub> that of rest; x', the derivative by time; F<sub>t</sub> and v<sub>t</sub>, the parts
 * along a surface.
 *
 * <p><b>Phases.</b> {@link particles.reactions.Contacts} has who touches what, and a {@link particles.reactions.Row}
 * for each rod, each two balls in contact and, twice, each bead on a wire. {@link particles.reactions.GatherPhase}
 * gathers the rows that depend on each other in a {@link particles.reactions.Block}, with one more for each particle at
 * each surface that it touches; {@link particles.reactions.EvaluatePhase} evaluates gaps, velocities and the matrix,
 * {@link particles.reactions.SolvePhase} solves for forces or impulses by one active-set method, and {@link
 * particles.reactions.ApplyPhase} adds the forces, or changes places and velocities. No phase knows a later one. The
 * reactions {@link particles.reactions.RestingContacts} and {@link particles.reactions.RigidConstraints} run them in
 * each evaluation; rules do through {@link particles.reactions.BlockImpacts}, {@link particles.reactions.BallContacts}
 * and {@link particles.reactions.ContactQueries}.
 *
 * <p><b>Unknowns.</b> A constraint is a function C(x) that is to stay 0: a rod is one, its length minus the prescribed
 * one; a wire is two; a contact is one, C = d. Each is a row of equations. Its force is lambda times the gradient of C.
 * With J the gradients of all rows, W the inverse masses and F the sum of all effects, C'' = J W F + J W J<sup>T</sup>
 * lambda + J' v. Demanding C'' = 0 gives the system A lambda = b with A = J W J<sup>T</sup> and b = -(J W F + J' v). An
 * anchor whose motion is prescribed has W = 0; its velocity enters b through J' v, its acceleration is added to W F.
 * Errors of steps decay by two more terms in b, see {@link particles.reactions.RigidConstraints}.
 *
 * <p><b>Complementarity.</b> A rod pulls and pushes; a contact only pushes, and only while it touches: lambda &ge; 0,
 * d'' &ge; 0 and lambda d'' = 0 (but see the release, below). For one particle on one plane that is the slides' rule:
 * lambda = 0 for N . F &ge; 0, otherwise lambda = -(N . F). With its centre at distance R from that of a sphere, N . F
 * is replaced by N . F + m v<sub>t</sub>&sup2;/R, inside a hollow sphere by N . F - m v<sub>t</sub>&sup2;/R: a fast
 * particle takes off from a hill. Rods and contacts that share particles form a block, and a particle that only touches
 * surfaces is a block of its own. Each block is solved by one active-set method: all contacts are taken to push; one
 * with lambda &lt; 0 is opened, an open one with d'' &lt; 0 is closed, and the system is solved again until there is
 * neither. A particle that sticks counts as immovable, and its contacts have no rows.
 *
 * <p><b>Friction.</b> Coulomb's friction lies in a cone, |F<sub>t</sub>| &le; mu lambda. While a particle slides, it is
 * mu lambda against the velocity v<sub>t</sub>; at the start from rest it is against the force that moves the particle,
 * and at most as large. Each newton of lambda then brings its own friction, S in J - S, so the matrix is A = J W (J -
 * S)<sup>T</sup>, which is not symmetric. The slides have another law, proportional to speed, k<sub>f</sub> lambda
 * v<sub>t</sub>; where they print N + k<sub>f</sub> v<sub>t</sub>, it has to be N - k<sub>f</sub> v<sub>t</sub>. A
 * particle that several surfaces push slides along all of them: in a groove along its bottom line, and in the corner of
 * three planes not at all. So friction is perpendicular to the normals of all surfaces that push the particle, and
 * changes normal forces only where rods, wires or balls join particles. Several surfaces share it in the ratio of their
 * limits mu lambda. With {@link particles.law.Scales} the cone is not round: its sections are two half ellipses,
 * friction with sliding is the force in it that takes most energy, and from rest the part of the moving force that is
 * balanced is the nearest one in it. A particle slower than its friction's threshold is at rest. It sticks if
 * mu<sub>s</sub> lambda, summed over its surfaces, is at least the force left along them, with lambda as without
 * friction; in a block with rods, wires or balls, it sticks if some contact forces in the cones balance all other
 * forces. Friction cannot hold the end of a rod while the rod's anchor moves along it.
 *
 * <p><b>What is unique.</b> The accelerations are, while the same particles stick and friction is not so large that it
 * jams (P. Painlev&eacute; 1895): then it can happen that no forces satisfy the equations, and the run ends with that
 * reason. The forces need not be unique: a square of rods with both diagonals, or a rod wedged between rough walls, is
 * statically indeterminate. Dependent rows take the solution with the least sum of squares; static friction in a block
 * holds if at least one solution stays in all cones. Rods in one line that close a polygon without area cannot stop a
 * motion across the line with finite forces, and are refused when a scene is read.
 *
 * <p><b>Impacts.</b> At an impact the normal velocity v<sub>n</sub> becomes -r v<sub>n</sub>; impulses obey the same
 * equations with velocities in place of accelerations. All contacts of surfaces and balls that approach at one
 * moment are answered together: lambda &ge; 0 and J v' &ge; -r J v, with equality where lambda &gt; 0, in their
 * rows, and J v' = 0 in those of rods and wires. With one r this turns back by 1 + r the part of v that leads into
 * the contacts, measured by the masses. Contacts that approach after that are answered in the next round, as each
 * ball of Newton's cradle hits the next one, until none approaches (B. Smith and others, "Reflections on
 * simultaneous impact", ACM Transactions on Graphics 31, 2012). Momentum is kept, and for r = 1 energy; no order of
 * lines matters. Surfaces that were touched before take part with r = 0 and may open. Coulomb's friction acts as an
 * impulse too, in all rows with a normal one: of all impulses along the surfaces, at most mu times the normal ones,
 * those that leave the least energy. The slides keep v<sub>t</sub>; a scene can choose that.
 *
 * <p><b>From impacts to contacts.</b> A bounce slower than the surface's rest speed, or than what the forces give
 * back within a step, becomes a contact; with r = 1 only one that is a round-off of the motion. Within a step the
 * contacts and their modes (sliding or sticking) are fixed. Rules change them between steps or at located events, by
 * distance and by the forces and velocities at the end of the step as this solver made it. If the release is a
 * located event, the contacts of a block without touching balls hold until then: lambda may become negative within a
 * step, and the contact ends where it does. Otherwise lambda &ge; 0 holds at each evaluation. After a release from a
 * curved surface, the first step of a method of order 1 may end below it by O(deltaT&sup2;) although v<sub>n</sub>
 * points outwards: that is truncation error, not an impact.
 *
 * <p><b>Balls on balls.</b> With the rule {@code collisions}, particles are hard spheres. Two that touch have the row
 * of a rod between their centres, as long as the sum of their radii, with lambda &ge; 0. Balls in lasting contact have
 * no friction. Where balls accelerate apart, the complementarity problem tells which contacts separate; a contact with
 * neither force nor separation lasts, and two that meet again in the step in which they parted stay together until its
 * end. In a dense packing many contacts are dependent: forces are not unique, motion is. Errors of distances are
 * corrected after each step and not by feedback: those of dependent rows cannot all decay.
 *
 * <p>At up to 200 steps and at the end of each run the largest violation of a rod, wire or contact is noted, as a
 * fraction of its length or radius (of 1 m for planes and wires), and the difference between the work that is reported
 * for moving anchors and that of the forces on them. From 0.001 on there is a warning; above 0.1 the run ends as wrong.
 *
 * <p>{@link particles.reactions.Tolerances} has all limits: what counts as 0, and which errors mean no solution.
 *
 * <p>Sources: the slides "Particle/Plane Contact" and "Particle/Plane Collisions"; A. Witkin, "Constrained Dynamics",
 * SIGGRAPH course notes 1997 (rows); D. Baraff, "Fast contact force computation for nonpenetrating rigid bodies",
 * SIGGRAPH 1994 (complementarity with friction); for active sets J. J&uacute;dice and F. Pires 1994 and, as the
 * fallback, K. Murty, "Note on a Bard-type scheme for solving the complementarity problem", Opsearch 1974.
 */
package particles.reactions;
