/**
 * Forces that depend on the sum of all others: contact, friction, rods, wires and balls on balls. They are added after
 * all effects.
 * This page is their theory.
 *
 * <p><b>Unknowns.</b> A constraint r is a function C<sub>r</sub>(x): the length of a rod, the distance from a wire, or
 * the distance d of a particle from a surface with normal N. Its force is lambda<sub>r</sub> times the gradient of
 * C<sub>r</sub>. With J the gradients of all rows, W the inverse masses and F the sum of all effects, C'' = J W F + J W
 * J<sup>T</sup> lambda + J' v. Demanding C'' = 0 gives the system A lambda = b with A = J W J<sup>T</sup> and b = -(J W
 * F + J' v). The particles of a rod whose motion is prescribed enter b with their velocity (in J' v) and with their
 * acceleration. Errors of steps decay by two more terms in b, see {@link particles.reactions.RigidConstraints}.
 *
 * <p><b>Complementarity.</b> A rod pulls and pushes; a contact only pushes, and only while it touches: lambda &ge; 0,
 * d'' &ge; 0 and lambda d'' = 0. For one particle on one plane that is the slides' rule: lambda = 0 for N . F &ge; 0,
 * otherwise lambda = -(N . F). On a sphere of radius R, N . F is replaced by N . F + m v<sub>t</sub>&sup2;/R, inside a
 * hollow sphere by N . F - m v<sub>t</sub>&sup2;/R: a fast particle takes off from a hill. Rods and contacts that share
 * particles form a block, a particle that only touches surfaces is a block of its own, and each block is solved by one
 * active-set method: all contacts are taken to push, and one that would pull, or that would let its particle in,
 * changes sides until none is wrong. A block keeps its rows until a contact begins or ends, sticks or slides; a
 * particle on one plane has one row, lambda = -(N . F).
 *
 * <p><b>Friction.</b> The friction of a contact lies in a cone, |F<sub>t</sub>| &le; mu lambda. While a particle
 * slides, it is mu lambda against the velocity v<sub>t</sub>; at the start from rest, against the force that moves the
 * particle. The slides have another law, proportional to speed: k<sub>f</sub> lambda v<sub>t</sub>. A particle that
 * several surfaces push slides along all of them: in a groove along its bottom line, and in the corner of three planes
 * not at all. So friction is perpendicular to all normals of its particle: it changes normal forces only through rods.
 * Several surfaces share it in the ratio of their limits mu lambda. A particle at rest sticks if contact forces in the
 * cones of its surfaces can balance all other forces on it. A rod to a moving anchor is stronger than any friction: its
 * end cannot stick while the anchor moves along the rod.
 *
 * <p><b>What is unique.</b> The accelerations are, while the same particles stick and friction is not so large that it
 * jams (P. Painlev&eacute; 1895: then no forces may exist, and the run says so). The forces need not be: a square of
 * rods with both diagonals, or a prop between rough walls, is statically indeterminate. Rods take the solution with the
 * least sum of squares; static friction holds if at least one solution stays in all cones. Rods in one line that close
 * a triangle have no finite forces across the line, and are refused when a scene is read.
 *
 * <p><b>From impacts to contacts.</b> At an impact the normal velocity v<sub>n</sub> becomes -r v<sub>n</sub>; impulses
 * obey the same equations with velocities in place of accelerations. A bounce slower than the surface's rest speed
 * becomes a contact. Within a step the contacts and their modes (sliding or sticking) are fixed. Rules change them
 * between steps or at located events, by the forces and velocities at the end of the solver's own step. If the release
 * is a located event, a contact holds until then: lambda may become negative within a step, and the contact ends where
 * it does. Otherwise lambda &ge; 0 holds at each evaluation. On a curved surface the next step of a method of order 1
 * may end below it by O(deltaT&sup2;) although v<sub>n</sub> points outwards: that is truncation error, not an impact.
 *
 * <p><b>Balls on balls.</b> With the rule {@code collisions}, particles are hard spheres. Two that touch have the row
 * of a rod between their centres, C = |x<sub>j</sub> - x<sub>i</sub>| - r<sub>i</sub> - r<sub>j</sub>, with lambda
 * &ge; 0. It has no friction; impacts have, by an impulse of at most mu times the normal one. An impact is solved with
 * the rods, wires and surfaces of its two balls, but with no other contact of balls: of several at the same time, one
 * follows the other, as in Newton's cradle, until none is left or all that remain are slow. These stop together. Then,
 * and where a lambda becomes negative, the complementarity problem tells which contacts separate; a contact with
 * neither force nor separation lasts. In a dense packing many contacts are dependent: forces are not unique, motion is.
 * Errors of distances are corrected after each step and not by feedback: those of dependent rows cannot all decay.
 *
 * <p>At about 200 steps and at the end of each run the largest violation of a rod, wire or contact is noted, and the
 * difference between the work that is reported for moving anchors and that of the forces on them. If one of them is
 * more than a tenth, the run ends as wrong. Sources: the slides "Particle/Plane Contact" and "Particle/Plane
 * Collisions"; A. Witkin, "Constrained Dynamics", SIGGRAPH course notes 1997; D. Baraff, "Fast contact force
 * computation for nonpenetrating rigid bodies", SIGGRAPH 1994; K. Murty, "Note on a Bard-type scheme for solving the
 * complementarity problem", Opsearch 1974.
 */
package particles.reactions;
