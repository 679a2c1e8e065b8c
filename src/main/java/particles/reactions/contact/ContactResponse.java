package particles.reactions.contact;

import deSolvers.ForceDerivatives;
import java.util.List;
import particles.law.Particles;
import particles.law.Vector3;

/** The contact force on one particle in closed form: normal forces and friction of all surfaces that it touches. */
public final class ContactResponse {
    private static final int STRIDE = Particles.STRIDE;

    private final Particles particles;
    private final List<ContactSurface> surfaces;
    private final ContactModes modes;
    private final SlidingDirection sliding;
    private final ContactDerivative derivative;
    private final TouchedSurfaces touched;              // by the particle of the last respond()
    private final Vector3[] normals;
    private final double[] push;
    private final double[] friction = new double[3];
    private double pushed;                              // sum of the normal forces of the last holdSlack() (N)
    private boolean holdsOn;

    /** Creates the response of these particles at these surfaces, in modes that rules change. */
    public ContactResponse(Particles particles, List<ContactSurface> surfaces, ContactModes modes,
            SlidingDirection sliding) {
        this.particles = particles;
        this.surfaces = surfaces;
        this.modes = modes;
        this.sliding = sliding;
        touched = new TouchedSurfaces(particles, surfaces.size());
        normals = touched.normals;
        push = touched.push;
        derivative = new ContactDerivative(surfaces.size());
    }

    /** Sets whether contact lasts until a rule ends it; see {@code RestingContacts.setHoldsOn}. */
    public void setHoldsOn(boolean holdsOn) {
        this.holdsOn = holdsOn;
    }

    /** @return whether contact lasts until a rule ends it */
    public boolean holdsOn() {
        return holdsOn;
    }

    /** Adds the contact force on particle i. */
    public void addForce(int i, double[] state, double[] force) {
        int count = respond(i, state, force);
        if (count == 0) {
            return;
        }
        int f = STRIDE * i + 3;
        for (int p = 0; p < count; p++) {
            force[f] += push[p] * normals[p].x();
            force[f + 1] += push[p] * normals[p].y();
            force[f + 2] += push[p] * normals[p].z();
        }
        force[f] += friction[0];
        force[f + 1] += friction[1];
        force[f + 2] += friction[2];
    }

    /**
     * Returns a sum plus the power of the contact force on particle i (W), which is that of friction, since surfaces at
     * rest do no work.
     */
    public double addPower(double sum, int i, double[] state, double[] force) {
        if (respond(i, state, force) == 0) {
            return sum;
        }
        int v = STRIDE * i + 3;
        return sum + friction[0] * state[v] + friction[1] * state[v + 1] + friction[2] * state[v + 2];
    }

    /** Adds the derivatives of the contact force on particle i. */
    public void addDerivatives(int i, double[] state, double[] force, ForceDerivatives derivatives) {
        int count = respond(i, state, force);
        if (count == 0) {
            return;
        }
        derivative.begin(count, touched, particles.mass(i), state, STRIDE * i + 3);
        if (touched.isSticking()) {
            derivative.hold();
        }
        for (int p = 0; p < count && !touched.isSticking(); p++) {
            double factor = findFriction(p, count, state, STRIDE * i + 3);
            derivative.rub(p, factor, sliding, touched.surfaces[p].friction().law());
        }
        derivative.add(i, derivatives);
    }

    /** As {@code RestingContacts.holdMargin}, for a given force on one particle. */
    public double holdMargin(int i, double[] state, double[] force) {
        double slack = holdSlack(i, state, force);
        return pushed > 0 ? slack : -1;
    }

    /**
     * As {@link #holdMargin}, but without the jump where the normal force vanishes: a concave function of the force.
     */
    public double holdSlack(int i, double[] state, double[] force) {
        int count = respond(i, state, force);
        pushed = 0;
        double withstood = 0;
        for (int p = 0; p < count; p++) {
            pushed += push[p];
            withstood += push[p] * touched.surfaces[p].friction().staticCoefficient();
        }
        return withstood - SlidingDirection.length(touched.unheld());
    }

    /** As {@code RestingContacts.pressure}, for a given force on one particle. */
    public double pressure(int surface, int i, double[] state, double[] force) {
        int count = respond(i, state, force);
        for (int p = 0; p < count; p++) {
            if (touched.surfaces[p] == surfaces.get(surface)) {
                return push[p] != 0 ? push[p] : touched.needed(p, touched.unheld());
            }
        }
        return 0;
    }

    /** As {@code RestingContacts.stopEntering}. */
    public void stopEntering(int i, double[] state) {
        if (touched.gather(i, surfaces, modes, state) > 0) {
            touched.answerVelocity(state, STRIDE * i + 3);
            System.arraycopy(touched.unheld(), 0, state, STRIDE * i + 3, 3);
        }
    }

    /**
     * Finds normal forces and friction for one particle; returns how many surfaces it touches, 0 if there is no contact
     * force.
     */
    private int respond(int i, double[] state, double[] force) {
        if (particles.isFixed(i)) {
            return 0;
        }
        int count = touched.gather(i, surfaces, modes, state);
        if (count == 0) {
            return 0;
        }
        touched.answer(force, STRIDE * i + 3);
        if (holdsOn && count == 1 && push[0] == 0) {
            push[0] = touched.needed(0, touched.pressing);
        }
        friction[0] = 0;
        friction[1] = 0;
        friction[2] = 0;
        if (touched.isSticking()) {
            hold();
        } else {
            for (int p = 0; p < count; p++) {
                rub(p, count, state, STRIDE * i + 3);
            }
        }
        return count;
    }

    /** Static friction cancels the tangential force. Rules check between steps that it can, by holdMargin. */
    private void hold() {
        double[] left = touched.unheld();
        for (int c = 0; c < 3; c++) {
            friction[c] = -left[c];
        }
    }

    /**
     * Finds the direction and factor of one surface's friction. What would move a particle on several surfaces is the
     * force that all normal forces leave, and the surfaces share the friction against it.
     */
    private double findFriction(int p, int count, double[] state, int v) {
        double all = 0;
        for (int q = 0; q < count; q++) {
            all += touched.surfaces[q].friction().ofCoulomb(push[q]);
        }
        double own = touched.surfaces[p].friction().ofCoulomb(push[p]);
        return sliding.find(touched.surfaces[p].friction(), normals[p], push[p], all > 0 ? own / all : 1,
                count == 1 ? touched.pressing : touched.unheld(), state, v);
    }

    /** Sliding friction of one surface, against the velocity along it. */
    private void rub(int p, int count, double[] state, int v) {
        double factor = findFriction(p, count, state, v);
        for (int c = 0; c < 3 && factor != 0; c++) {
            friction[c] -= factor * sliding.direction[c];
        }
    }
}
