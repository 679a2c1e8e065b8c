package particles.teaching.effects;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import particles.ParticleSystem;
import particles.teaching.Formula;

/** Compares forces with the expected ones, and looks for a common pattern of the differences. */
final class ForceComparison {
    private static final double SAME = 1e-5;
    private static final String XYZ = "xyz";

    private final ParticleSystem system;
    private final double[] force;
    private final double[] expected;
    private final double size;

    /**
     * @param system   the system of the particles on which they act
     * @param force    the forces, in the entries of the velocities
     * @param expected the right forces, likewise
     * @param size     the size of the largest force
     */
    ForceComparison(ParticleSystem system, double[] force, double[] expected, double size) {
        this.system = system;
        this.force = force;
        this.expected = expected;
        this.size = size;
    }

    /**
     * @param velocities whether the forces depend on velocities
     * @param other      the origin of the right forces, in words
     * @return the likely mistake, after a colon; empty if nothing is common to all differences
     */
    String cause(boolean velocities, String other) {
        if (Arrays.stream(expected).allMatch(f -> Math.abs(f) <= SAME * size)) {
            return velocities ? ": a force that depends on the velocity is not CONSERVATIVE; claim DISSIPATIVE if it "
                    + "damps"
                    : ": " + other + " is the same everywhere; getPotentialEnergy is missing (1/2 is 0 in "
                    + "Java, 0.5 is meant), or the claim CONSERVATIVE is wrong";
        }
        Optional<String> leftOut = leftOut();
        if (leftOut.isPresent()) {
            return leftOut.get();
        }
        if (fits(-1, 0)) {
            return ": the sign is wrong, in the force or in " + other;
        }
        if (fits(0.5, 0)) {
            return ": the half is missing in " + other + ", or one was taken too often in the force";
        }
        if (fits(2, 0)) {
            return ": the force is twice what it should be, or a half too many stands in " + other;
        }
        if (fits(1, -1)) {
            return ": the mass is missing in the force, which is mass times acceleration";
        }
        if (fits(1, 1)) {
            return ": the mass is missing in " + other + ", or stands in the force once too often";
        }
        int largest = 3;
        for (int k = 3; k < force.length; k += k % 6 == 5 ? 4 : 1) {
            largest = Math.abs(expected[k]) > Math.abs(expected[largest]) ? k : largest;
        }
        if (fits(force[largest] / expected[largest], 0)) {
            return ": all of it is " + Formula.number(force[largest] / expected[largest]) + " times what it should be";
        }
        List<String> off = new ArrayList<>();
        for (int c = 0; c < 3; c++) {
            for (int k = 3 + c; k < force.length; k += 6) {
                if (!system.getParticles().isFixed(k / 6) && Math.abs(force[k] - expected[k]) > SAME * size) {
                    off.add(XYZ.substring(c, c + 1));
                    break;
                }
            }
        }
        return off.size() == 3 ? "" : ": only " + String.join(" and ", off) + (off.size() == 1 ? " is" : " are")
                + " wrong";
    }

    /** Finds particles without any force, if all others have the right one. */
    private Optional<String> leftOut() {
        List<String> names = new ArrayList<>();
        for (int i = 0; i < force.length / 6; i++) {
            boolean none = true;
            boolean right = true;
            for (int k = 6 * i + 3; k < 6 * i + 6; k++) {
                none &= force[k] == 0;
                right &= Math.abs(force[k] - expected[k]) <= SAME * size;
            }
            if (!right && !system.getParticles().isFixed(i)) {
                if (!none) {
                    return Optional.empty();
                }
                names.add("'" + system.getParticles().id(i) + "'");
            }
        }
        return names.isEmpty() ? Optional.empty() : Optional.of(": there is no force on particle "
                + String.join(", ", names) + ", and the right one on all others; "
                + "the loop has to begin at 0 and go while i < particles.count()");
    }

    /** Whether force = factor * mass^power * expected, for all free particles. */
    private boolean fits(double factor, int power) {
        for (int k = 3; k < force.length; k += k % 6 == 5 ? 4 : 1) {
            double mass = system.getParticles().mass(k / 6);
            double scaled = factor * expected[k] * (power == 0 ? 1 : power > 0 ? mass : 1 / mass);
            if (!system.getParticles().isFixed(k / 6) && Math.abs(force[k] - scaled) > SAME * size * 2) {
                return false;
            }
        }
        return true;
    }
}
