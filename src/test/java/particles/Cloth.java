package particles;

import static particles.Systems.addGravity;
import static particles.Systems.springs;

import particles.effects.springs.SpringForce;
import particles.law.Vector3;

/** Square cloths and chains for tests. */
public final class Cloth {
    /**
     * Offsets of each particle's springs: to its neighbours, across the squares, and to the next but one against
     * bending.
     */
    private static final int[][] JOINTS = {{0, 1}, {1, 0}, {1, 1}, {1, -1}, {0, 2}, {2, 0}};

    private Cloth() {
    }

    /**
     * A cloth that hangs from two corners, slightly crumpled, its particles 5 cm apart.
     *
     * @param n         particles along an edge; about 6 n^2 springs
     * @param stiffness of every spring (N/m)
     * @param damping   of every spring (N s/m)
     */
    public static ParticleSystem hanging(int n, double stiffness, double damping) {
        double spacing = 0.05;
        ParticleSystem system = new ParticleSystem();
        for (int row = 0; row < n; row++) {
            for (int column = 0; column < n; column++) {
                boolean corner = row == 0 && (column == 0 || column == n - 1);
                Vector3 place = new Vector3(spacing * column, -spacing * row, 0.01 * ((7 * row + 13 * column) % 5));
                system.addParticle(row + "," + column, 0.01, place, Vector3.ZERO, corner);
            }
        }
        addGravity(system);
        addSprings(system, n, spacing, stiffness, damping);
        return system;
    }

    /** A level cloth of 2 m x 2 m and 0.6 kg, held at two corners: it buckles as soon as it falls. */
    static ParticleSystem level(int n, double stiffness) {
        double spacing = 2.0 / (n - 1);
        ParticleSystem system = new ParticleSystem();
        for (int i = 0; i < n * n; i++) {
            system.addParticle("" + i, 0.6 / (n * n), new Vector3(spacing * (i % n), 0, spacing * (i / n)),
                    Vector3.ZERO, i == 0 || i == n - 1);
        }
        addGravity(system);
        addSprings(system, n, spacing, stiffness, 0);
        return system;
    }

    /** A cloth in free flight: stretched, crumpled and thrown. */
    static ParticleSystem thrown(int n, double stiffness) {
        ParticleSystem system = new ParticleSystem();
        for (int i = 0; i < n * n; i++) {
            system.addParticle("" + i, 0.001, new Vector3(0.0525 * (i % n), -0.05 * (i / n), 0.002 * (i % 7)),
                    new Vector3(1 + 0.05 * (i % 5), 2, 0.05 * (i % 3)), false);
        }
        addSprings(system, n, 0.05, stiffness, 0.01);
        return system;
    }

    /** A chain along the x axis that begins to fall from its first particle, on springs of the given spacing. */
    static ParticleSystem chain(int n, double mass, double spacing, double stiffness, double damping) {
        ParticleSystem system = new ParticleSystem();
        addGravity(system);
        SpringForce springs = springs(system);
        for (int i = 0; i < n; i++) {
            system.addParticle("link" + i, mass, new Vector3(spacing * i, 0, 0), Vector3.ZERO, i == 0);
            if (i > 0) {
                springs.addSpring(i - 1, i, stiffness, spacing, damping);
            }
        }
        return system;
    }

    private static void addSprings(ParticleSystem system, int n, double spacing, double stiffness, double damping) {
        SpringForce springs = springs(system);
        for (int row = 0; row < n; row++) {
            for (int column = 0; column < n; column++) {
                for (int[] joint : JOINTS) {
                    int r = row + joint[0];
                    int c = column + joint[1];
                    if (r < n && c >= 0 && c < n) {
                        double length = spacing * Math.sqrt(joint[0] * joint[0] + joint[1] * joint[1]);
                        springs.addSpring(row * n + column, r * n + c, stiffness, length, damping);
                    }
                }
            }
        }
    }
}
