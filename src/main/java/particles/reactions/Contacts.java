package particles.reactions;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.law.Scales;
import particles.law.Vector3;
import particles.reactions.ContactModes.Mode;
import particles.reactions.ContactSurface.Friction;
import particles.reactions.Row.Kind;

/**
 * The data of contact: the surfaces, which particles touch them and how, the rods, wires and balls in contact, and the
 * beginning of the step. Rules change it between steps; forces only read it, so they are smooth functions of the
 * particles' state while a solver works.
 */
public final class Contacts {
    private static final int STRIDE = Particles.STRIDE;

    final ParticleSystem system;
    final Particles particles;
    final List<Row> rows = new ArrayList<>();          // of rods, of balls in contact and of wires, in this order
    private int rowChanges;
    private final List<ContactSurface> surfaces;
    private final ContactModes modes;
    private double feedback;
    private boolean holding;
    private Scales[] scales = {};                       // by particle; null for those that have none
    private int step;                                   // its number
    private double[] stepBegin = {};                    // the state at the beginning of the step
    private double[] stopping = {};                     // m/deltaT of a particle that may stop in the step, or 0 (kg/s)

    Contacts(ParticleSystem system, List<ContactSurface> surfaces) {
        this.system = system;
        this.particles = system.getParticles();
        this.surfaces = List.copyOf(surfaces);
        modes = new ContactModes(particles, surfaces.size());
    }

    /** @return the system of the particles */
    public ParticleSystem getSystem() {
        return system;
    }

    /** @return the surfaces, in the order of their indices in {@link #getModes} */
    public List<ContactSurface> getSurfaces() {
        return surfaces;
    }

    /** @return the contact mode of each particle at each surface, which rules change */
    public ContactModes getModes() {
        return modes;
    }

    /** Counts changes of the list of rows. */
    int getRowChanges() {
        return rowChanges;
    }

    /** Adds the row of a rod or of two balls, in the order of kinds; it keeps this distance (m). */
    Row addLink(Kind link, int from, int to, double distance) {
        rowChanges++;
        Row row = new Row(link, from, to, distance);
        rows.add(begin(Kind.values()[link.ordinal() + 1]), row);
        return row;
    }

    /** Adds the rows of a bead. */
    void addBead(int particle, Curve wire) {
        rowChanges++;
        wire.surfaces().forEach(surface -> rows.add(Row.wire(particle, surface)));
    }

    /** Removes a row. */
    void removeRow(int row) {
        rowChanges++;
        rows.remove(row);
    }

    /** Updates indices after particles were removed; their rows are removed too. */
    void reindexRows(int[] newIndex) {
        rowChanges++;
        for (Row row : rows) {
            row.first = newIndex[row.first];
            row.second = row.second < 0 ? -1 : newIndex[row.second];
        }
        rows.removeIf(row -> row.first < 0 || row.second < 0 && row.kind != Kind.WIRE);
    }

    /** The index of the first row of a kind, or of a later one. */
    int begin(Kind from) {
        int r = rows.size();
        while (r > 0 && rows.get(r - 1).kind.compareTo(from) >= 0) {
            r--;
        }
        return r;
    }

    /** The rate at which errors of rods, wires and contacts joined with them decay (1/s). */
    double getFeedback() {
        return feedback;
    }

    void setFeedback(double feedback) {
        this.feedback = feedback;
    }

    /**
     * Sets whether contact lasts until a rule ends it. Otherwise the normal force is 0 wherever N . F is positive, as
     * on the slide; then the force has a kink there, and a step across it loses its order.
     *
     * @param holding true if a rule locates the exact time of release
     */
    public void setHolding(boolean holding) {
        this.holding = holding;
    }

    /** @return whether contact lasts until a rule ends it */
    public boolean isHolding() {
        return holding;
    }

    /** @param scales by particle; null for those that have none */
    public void setScales(Scales... scales) {
        this.scales = scales.clone();
    }

    /** The scales of a particle. */
    Optional<Scales> scalesOf(int i) {
        return i < scales.length ? Optional.ofNullable(scales[i]) : Optional.empty();
    }

    /** Updates indices after particles were removed: one without its neighbour has no scales any more. */
    void reindex(int[] newIndex) {
        modes.reindex(newIndex);
        stepBegin = new double[0];
        stopping = new double[0];
        Scales[] before = scales;
        scales = new Scales[before.length];
        for (int i = 0; i < before.length; i++) {
            Scales own = before[i];
            if (own != null && newIndex[own.tail()] >= 0 && newIndex[own.head()] >= 0) {
                scales[newIndex[i]] = new Scales(newIndex[own.tail()], newIndex[own.head()], own.forward(),
                        own.backward(), own.across());
            }
        }
    }

    /**
     * Records the state at the beginning of a step. Coulomb friction would flip when sliding reverses; within a step it
     * is continued smoothly as if it had not, and the end of the step shows whether it did.
     */
    public void beginStep() {
        step++;
        if (stepBegin.length != system.getStateSize()) {
            stepBegin = new double[system.getStateSize()];
        }
        System.arraycopy(system.getOwnState(), 0, stepBegin, 0, stepBegin.length);
        Arrays.fill(stopping, 0);
    }

    /** @return the state at the beginning of the step; read only */
    public double[] getStepBegin() {
        return stepBegin;
    }

    /** The number of the step. */
    int getStep() {
        return step;
    }

    /** A particle's velocity at the beginning of the step (m/s); 0 if none has begun. */
    Vector3 beginning(int i) {
        int v = STRIDE * i + 3;
        return v < stepBegin.length ? Vector3.at(stepBegin, v) : Vector3.ZERO;
    }

    /**
     * @param particle its index
     * @return whether it is at rest at the beginning of the step; if it slides, then where the force pulls it
     */
    boolean startsFromRest(int particle) {
        int v = STRIDE * particle + 3;
        return v < stepBegin.length && Vector3.at(stepBegin, v).norm1() <= Tolerances.STANDSTILL;
    }

    /**
     * Lets Coulomb friction act on a particle as an impulse over the step that begins: as a constant force that brings
     * it to rest after a time, as far as the friction cone allows. Near a stop the direction of exact friction turns as
     * fast as that of the velocity. Implicit solvers then do not converge and adaptive ones make no progress, above all
     * where springs stop and start a particle again and again.
     *
     * @param time from the step's start to the stop (s)
     */
    public void stopAfter(int particle, double time) {
        if (stopping.length * STRIDE != stepBegin.length) {
            stopping = new double[stepBegin.length / STRIDE];
        }
        stopping[particle] = particles.mass(particle) / time;
    }

    /** The mass of a particle divided by the time after which friction is to stop it (kg/s); 0 if it is not. */
    double stoppingRate(int i) {
        return i < stopping.length ? stopping[i] : 0;
    }

    /** Whether friction acts on a particle as an impulse in the present step. */
    boolean mayStop(int particle) {
        return stoppingRate(particle) > 0;
    }

    /** The largest value for the friction of the surfaces that a particle touches; 0 if there is none. */
    double largest(int particle, ToDoubleFunction<Friction> value) {
        double largest = 0;
        for (int p = 0; p < surfaces.size(); p++) {
            largest = modes.get(p, particle) == Mode.FREE ? largest
                    : Math.max(largest, value.applyAsDouble(surfaces.get(p).friction()));
        }
        return largest;
    }

    /**
     * @param particle its index
     * @param state    the state
     * @return whether the particle is slow enough for static friction: it touches a rough surface and is slower than
     *         its threshold or round-off
     */
    public boolean isSlow(int particle, double[] state) {
        double limit = largest(particle,
                f -> f.staticCoefficient() > 0 ? Math.max(Tolerances.STANDSTILL, f.threshold()) : 0);
        Vector3 velocity = Vector3.at(state, STRIDE * particle + 3);
        return limit > 0 && velocity.dot(velocity) <= limit * limit;
    }

    /** @return whether friction on a particle flips when it reverses, or may hold it */
    public boolean rubs(int particle) {
        return largest(particle, f -> Math.max(f.ofCoulomb(1), f.staticCoefficient())) > 0;
    }

    /** @return the largest threshold of the friction that acts on a particle (m/s), below which it may stick */
    public double threshold(int particle) {
        return largest(particle, Friction::threshold);
    }

    /**
     * @param particle its index
     * @param velocity its velocity at the end of the step (m/s)
     * @return whether it has reversed within the step, is slower than the threshold of a surface, or as good as stopped
     *         where friction was to stop it
     */
    public boolean hasStopped(int particle, Vector3 velocity) {
        Vector3 before = Vector3.at(stepBegin, STRIDE * particle + 3);
        double slow = mayStop(particle) ? Tolerances.ALMOST_STOPPED * before.length() : 0;
        return velocity.dot(before) <= 0 || velocity.length() <= Math.max(slow, threshold(particle));
    }
}
