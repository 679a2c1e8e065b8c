package particles.reactions;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import particles.law.Particles;
import particles.law.Scales;
import particles.law.Scales.Skin;
import particles.law.Vector3;
import particles.reactions.ContactSurface.Friction;
import particles.reactions.ContactSurface.Friction.Law;
import particles.reactions.NormalForces.Push;

/**
 * The derivative of the total force on a particle that slides on one surface or several, F + sum lambda N + friction,
 * see {@link SlidingFriction}: its change for small changes of the forces before contact, of the particle's place and
 * velocity and of its body's axis. With the dual normals D (D_r . N_s is 1 for r = s and 0 otherwise) the projection
 * onto the surfaces is P u = u - sum N_r (D_r . u), and lambda = -sum (D_r . D_s) (N_s . F + bend_s). Each line here is
 * the derivative of a line there. Where normals are dependent, the loads on them are taken not to change.
 *
 * <p>Finite differences do not replace it. Differences of the whole system fail: a cloth of 21 x 17 particles that
 * falls on a rough sphere, with linearised-euler and deltaT = 0.02 s, ends at 0.26 s, where GMRES fails. Differences of
 * single contacts cross the kink at which a contact ends.
 */
final class ContactDerivative {
    private final Contacts contacts;
    private final int i;
    private final double mass;
    private final double[] state;
    private final Vector3 velocity;
    private final Vector3 force;
    private final Vector3 total;                        // with normal forces
    private final Push[] pushes;
    private final Vector3[] duals;
    private final Vector3 body;                         // its vector (m), 0 without scales
    private final Vector3 axis;                         // its part along the surfaces
    private final Skin skin;
    private final Vector3[] turns;                      // dN
    private Vector3 longer;                             // the change of the body's axis

    /** @param force on the particle, of all effects (N) */
    ContactDerivative(Contacts contacts, int i, double mass, double[] state, Vector3 force, Push... pushes) {
        this.contacts = contacts;
        this.i = i;
        this.mass = mass;
        this.state = state;
        this.force = force;
        this.pushes = pushes;
        velocity = Vector3.at(state, Particles.STRIDE * i + 3);
        duals = new Vector3[pushes.length];
        turns = new Vector3[pushes.length];
        Vector3 sum = force;
        for (int r = 0; r < pushes.length; r++) {
            sum = sum.plus(pushes[r].normal().times(pushes[r].size()));
            duals[r] = dual(r);
        }
        total = sum;
        Optional<Scales> scales = contacts.scalesOf(i);
        body = scales.map(s -> s.axis(state)).orElse(Vector3.ZERO);
        axis = along(body);
        skin = scales.map(s -> s.skin(body.length(), axis)).orElse(Skin.SMOOTH);
    }

    /** The part of a normal perpendicular to the others, divided by its square; 0 for one that depends on others. */
    private Vector3 dual(int r) {
        List<Vector3> axes = new ArrayList<>();         // orthonormal, of the other normals
        for (int s = 0; s < pushes.length; s++) {
            Vector3 rest = across(axes, pushes[s].normal());
            if (s != r && rest.length() > Tolerances.PARALLEL) {
                axes.add(rest.normalized());
            }
        }
        Vector3 rest = across(axes, pushes[r].normal());
        return rest.length() > Tolerances.PARALLEL ? rest.over(rest.dot(rest)) : Vector3.ZERO;
    }

    private static Vector3 across(List<Vector3> axes, Vector3 u) {
        Vector3 rest = u;
        for (Vector3 axis : axes) {
            rest = rest.minus(axis.times(axis.dot(rest)));
        }
        return rest;
    }

    private Vector3 along(Vector3 u) {
        Vector3 rest = u;
        for (int r = 0; r < duals.length; r++) {
            rest = rest.minus(pushes[r].normal().times(duals[r].dot(u)));
        }
        return rest;
    }

    /** The change of P u. */
    private Vector3 along(Vector3 u, Vector3 du) {
        Vector3 changed = du;
        Vector3 turned = Vector3.ZERO;
        Vector3 flat = along(u);
        for (int r = 0; r < duals.length; r++) {
            changed = changed.minus(turns[r].times(duals[r].dot(u)));
            turned = turned.plus(duals[r].times(turns[r].dot(flat)));
        }
        return along(changed).minus(turned);
    }

    /** The change of the total force for those of force (N), place (m), velocity (m/s) and the body's axis (m). */
    Vector3 change(Vector3 dForce, Vector3 dPlace, Vector3 dVelocity, Vector3 dBody) {
        longer = dBody;
        Vector3 changed = dForce;
        for (int r = 0; r < pushes.length; r++) {
            Vector3 normal = pushes[r].normal();
            turns[r] = dPlace.minus(normal.times(normal.dot(dPlace))).times(curvature(r));
            changed = changed.plus(turns[r].times(pushes[r].size()));
        }
        double[] right = new double[pushes.length];
        for (int r = 0; r < pushes.length; r++) {
            Vector3 normal = pushes[r].normal();
            double into = normal.dot(velocity);
            double bend = curvature(r) * 2 * (velocity.dot(dVelocity)
                    - into * (turns[r].dot(velocity) + normal.dot(dVelocity)))
                    - curvature(r) * curvature(r) * normal.dot(dPlace) * (velocity.dot(velocity) - into * into);
            right[r] = -turns[r].dot(total) - normal.dot(changed) - mass * bend;
        }
        double slide = 0;
        double dSlide = 0;
        double most = 0;
        double dMost = 0;
        boolean isRough = false;
        for (int r = 0; r < pushes.length; r++) {
            double dPush = 0;
            for (int s = 0; s < pushes.length; s++) {
                dPush += duals[r].dot(duals[s]) * right[s];
            }
            changed = changed.plus(pushes[r].normal().times(dPush));
            Friction friction = pushes[r].surface().friction();
            slide += friction.law() == Law.SLIDE ? friction.coefficient() * pushes[r].size() : 0;
            dSlide += friction.law() == Law.SLIDE ? friction.coefficient() * dPush : 0;
            most += friction.law() == Law.COULOMB ? friction.coefficient() * pushes[r].size() : 0;
            dMost += friction.law() == Law.COULOMB ? friction.coefficient() * dPush : 0;
            isRough |= friction.law() != Law.NONE;
        }
        if (!isRough) {
            return changed;
        }
        Vector3 u = along(velocity);
        Vector3 du = along(velocity, dVelocity);
        if (slide != 0 || dSlide != 0) {
            Stretch s = new Stretch(u);
            changed = changed.minus(s.of(u).times(dSlide)).minus(s.change(u, du).times(slide));
        }
        return most == 0 ? changed : changed.minus(coulomb(u, du, most, dMost, dForce));
    }

    private double curvature(int r) {
        return pushes[r].surface().obstacle().curvature(state, Particles.STRIDE * i);
    }

    /** The change of what Coulomb's friction takes off the force. */
    private Vector3 coulomb(Vector3 u, Vector3 du, double most, double dMost, Vector3 dForce) {
        Vector3 begin = contacts.beginning(i);
        Vector3 b = along(begin);
        Vector3 db = along(begin, Vector3.ZERO);
        boolean stops = contacts.mayStop(i);
        if (!stops && !contacts.startsFromRest(i)) {
            Vector3 v = u;
            Vector3 dv = du;
            double square = b.dot(b);
            double part = 2 * u.dot(b) / square;
            if (u.length() < Tolerances.NO_DIRECTION * b.length()) {
                v = b;
                dv = db;
            } else if (part < 0) {
                double dPart = 2 * (du.dot(b) + u.dot(db) - part * b.dot(db)) / square;
                v = u.minus(b.times(part));
                dv = du.minus(db.times(part)).minus(b.times(dPart));
            }
            Stretch s = new Stretch(v);
            Vector3 q = s.of(v);
            double speed = q.length();
            if (speed > 0) {
                Vector3 dq = s.change(v, dv);
                Vector3 friction = s.of(q).over(speed);
                return friction.times(dMost).plus(s.change(q, dq).minus(friction.times(q.dot(dq) / speed))
                        .times(most / speed));
            }
        }
        if (most < 0) {
            return Vector3.ZERO;                        // a contact that a rule is about to end
        }
        Vector3 needed = along(force).plus(b.times(contacts.stoppingRate(i)));
        Vector3 dNeeded = along(force, dForce).plus(db.times(contacts.stoppingRate(i)));
        Stretch s = new Stretch(needed);
        return s.inverse(needed).length() <= most ? dNeeded : s.balance(needed, dNeeded, most, dMost);
    }

    /** The map S of {@link Skin}, c u + h a (a . u), where a is the body's axis along the surfaces. */
    private final class Stretch {
        private final double c = skin.across();
        private final double ahead;

        /** @param u decides between the factors forward and backward */
        Stretch(Vector3 u) {
            ahead = skin.ahead(u);
        }

        Vector3 of(Vector3 u) {
            return skin.scale(u, ahead, c);
        }

        /** The change of S u. */
        Vector3 change(Vector3 u, Vector3 du) {
            if (axis.isZero()) {
                return du.times(c);
            }
            double h = (ahead - c) / axis.dot(axis);
            Vector3 dAxis = ContactDerivative.this.along(body, longer);
            double dH = -2 * h * body.dot(longer) / body.dot(body);
            double part = axis.dot(u);
            return of(du).plus(dAxis.times(h * part)).plus(axis.times(h * dAxis.dot(u) + dH * part));
        }

        /** S<sup>-1</sup> u. */
        Vector3 inverse(Vector3 u) {
            return skin.scale(u, 1 / ahead, 1 / c);
        }

        /**
         * The change of y, the force on the ellipse |S<sup>-1</sup> y| = most that is nearest to a force n outside:
         * n - y = m B y with B = S<sup>-2</sup>, so (1 + m B) dy = dn - m dB y - dm B y.
         */
        Vector3 balance(Vector3 n, Vector3 dn, double most, double dMost) {
            Vector3 y = skin.balance(n, most);
            double m = n.minus(y).dot(y) / (most * most);
            Vector3 z = inverse(y);
            Vector3 by = inverse(z);
            Vector3 dBy = inverse(change(by, Vector3.ZERO).plus(inverse(change(z, Vector3.ZERO)))).times(-1);
            Vector3 dy = solve(m, dn.minus(dBy.times(m)));
            Vector3 perM = solve(m, by);
            double dM = (by.dot(dy) + y.dot(dBy) / 2 - most * dMost) / by.dot(perM);
            return dy.minus(perM.times(dM));
        }

        private Vector3 solve(double m, Vector3 u) {
            return skin.scale(u, 1 / (1 + m / (ahead * ahead)), 1 / (1 + m / (c * c)));
        }
    }
}
