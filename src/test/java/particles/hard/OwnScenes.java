package particles.hard;

import java.util.Map;
import java.util.TreeMap;

/** Thirty-two scenes that are not shipped: rods, wires, friction and births where solvers find them hardest. */
final class OwnScenes {
    private static final String HEAD = "title: t\nteaches: t\nsolver: rk4\ndeltaT: 0.005\nduration: 1\n";

    /** Each falls on each of the {@link #GROUNDS}. */
    private static final Map<String, String> BODIES = Map.of(
            "cloth", """
            shapes:
              - cloth: {corner: [-0.5, 0.72, -0.4], across: [0.9, 0, 0.1], down: [0, 0.1, 0.9], columns: 6, rows: 6,
                        totalMass: 0.2, structural: {stiffness: 100, damping: 0.05}, shear: {stiffness: 50}}
            """, "rope", """
            shapes:
              - rope: {start: [-0.6, 0.6, 0.02], end: [0.7, 0.6, 0.02], particles: 12, totalMass: 0.2,
                       structural: {stiffness: 200, damping: 0.1}}
            """, "jelly", """
            shapes:
              - jelly: {centre: [0.05, 0.95, 0], size: [0.4, 0.4, 0.4], turn: [20, 0, 35], columns: 3, rows: 3,
                        layers: 3, totalMass: 1, velocity: [0.5, 0, 0], structural: {stiffness: 300, damping: 0.5},
                        shear: {stiffness: 200, damping: 0.3}}
            """, "dumbbells", """
            particles:
              - {id: a, position: [0.1, 0.7, 0], mass: 1}
              - {id: b, position: [0.5, 0.9, 0], mass: 0.3}
              - {id: c, position: [-0.3, 0.8, 0.2], mass: 0.5, velocity: [1, 0, -1]}
              - {id: d, position: [-0.1, 0.8, 0.5], mass: 0.5, velocity: [1, 0, -1]}
            rods:
              - {from: a, to: b}
              - {from: c, to: d}
            """);

    /** What is rough and below the bodies. */
    private static final Map<String, String> GROUNDS = Map.of(
            "ground, clamp", "impact: clamp\nrules:\n  - ground: {height: 0.55, FRICTION}\n",
            "ground, exact", "impact: exact\nrules:\n  - ground: {height: 0.55, FRICTION}\n",
            "ball, clamp", "impact: clamp\nrules:\n  - sphere: {centre: [0, 0, 0], radius: 0.55, FRICTION}\n",
            "ball, exact", "impact: exact\nrules:\n  - sphere: {centre: [0, 0, 0], radius: 0.55, FRICTION}\n",
            "bowl, exact", "impact: exact\nrules:\n"
                    + "  - sphere: {centre: [0, 1, 0], radius: 1, hollow: true, FRICTION}\n");
    private static final String FRICTION = "restitution: 0.2, friction: {law: coulomb, coefficient: 0.4}";

    /** A rod whose ends slide along a vertical and a horizontal wire. */
    static final String TRAMMEL = """
            particles:
              - {id: across, position: [0.6, 0, 0], mass: 1}
              - {id: up, position: [0, 0.8, 0], mass: 1}
            wires:
              - line: {bead: across, direction: [1, 0, 0]}
              - line: {bead: up, direction: [0, 1, 0]}
            rods:
              - {from: across, to: up}
            """;

    /** Four rods that hang from a fixed particle. */
    static final String CHAIN = """
            particles:
              - {id: a, position: [0, 0, 0], fixed: true}
              - {id: b, position: [0.6, 0.8, 0]}
              - {id: c, position: [1.6, 0.8, 0]}
              - {id: d, position: [2.2, 0, 0]}
              - {id: e, position: [3.2, 0, 0]}
            rods:
              - {from: a, to: b}
              - {from: b, to: c}
              - {from: c, to: d}
              - {from: d, to: e}
            """;

    /** A gram between a pivot and a tonne. */
    static final String UNEVEN = """
            particles:
              - {id: pivot, position: [0, 0, 0], fixed: true}
              - {id: light, position: [0.6, -0.8, 0], mass: 1e-3}
              - {id: heavy, position: [1.2, -1.6, 0], mass: 1000}
            rods:
              - {from: pivot, to: light}
              - {from: light, to: heavy}
            """;

    /** Five particles are held rigid by nine rods; here are ten. The body spins with 2 rad/s. */
    static final String RIGID = """
            particles:
              - {id: a, position: [0, 1, 0], velocity: [0.8, -0.6, 0]}
              - {id: b, position: [1, 1, 0], velocity: [0.8, 1.4, 0]}
              - {id: c, position: [0, 2, 0], velocity: [-1.2, -0.6, 0]}
              - {id: d, position: [0, 1, 1], velocity: [0.8, -0.6, 0]}
              - {id: e, position: [1, 2, 1], velocity: [-1.2, 1.4, 0]}
            rods:
              - {from: a, to: b}
              - {from: a, to: c}
              - {from: a, to: d}
              - {from: a, to: e}
              - {from: b, to: c}
              - {from: b, to: d}
              - {from: b, to: e}
              - {from: c, to: d}
              - {from: c, to: e}
              - {from: d, to: e}
            """;

    /** Its foot is on the ground, its top at a wall. */
    static final String LADDER = """
            particles:
              - {id: foot, position: [0.6, 0, 0], mass: 1}
              - {id: top, position: [0, 0.8, 0], mass: 1}
            rods:
              - {from: foot, to: top}
            """;

    private static final Map<String, String> OTHERS = Map.ofEntries(
            Map.entry("trammel of Archimedes", TRAMMEL), Map.entry("chain of four rods", CHAIN),
            Map.entry("rigid body, one rod too many", RIGID + """
            impact: exact
            rules:
              - ground: {height: 0.5, restitution: 0.3, friction: {law: coulomb, coefficient: 0.3}}
            """), Map.entry("ladder on a rough floor", LADDER + """
            rules:
              - plane: {point: [0, 0, 0], normal: [0, 1, 0], restitution: 0, friction: {law: coulomb, coefficient: 0.2}}
              - plane: {point: [0, 0, 0], normal: [1, 0, 0], restitution: 0}
            """), Map.entry("masses of ratio a million on rods", UNEVEN),
            Map.entry("a weight under a bead hits the ground", """
            particles:
              - {id: slider, position: [-1, 0.5, 0]}
              - {id: weight, position: [-1, 0.1, 0.1], mass: 0.5}
            wires:
              - parabola: {bead: slider, curvature: 1}
            rods:
              - {from: slider, to: weight}
            impact: exact
            rules:
              - ground: {restitution: 0.3, friction: {law: coulomb, coefficient: 0.4}}
            """), Map.entry("rings and sine waves with drag", """
            particles:
              - {id: surfer, position: [0.6, 0.4755, 0]}
              - {id: ringer, position: [2.5, 2.5, 0]}
            springs:
              - {from: surfer, to: ringer, stiffness: 500}
            wires:
              - sine: {bead: surfer, amplitude: 0.5, wavelength: 2}
              - circle: {bead: ringer, centre: [1.5, 2.5, 0], radius: 1}
            """), Map.entry("elastic catenary", """
            shapes:
              - rope: {start: [-1, 0, 0], end: [1, 0, 0], particles: 21, totalMass: 1, fixed: [start, end],
                       structural: {stiffness: 2000}}
            """), Map.entry("five hundred rods", rods(500)),
            Map.entry("fountain into a rough bowl", """
            particles:
              - {id: nozzle, position: [0, 0.5, 0], fixed: true}
            impact: exact
            rules:
              - sphere: {centre: [0, 1, 0], radius: 1, hollow: true, restitution: 0.2,
                         friction: {law: coulomb, coefficient: 0.4}}
              - emitter: {id: drop, position: [0, 0.5, 0], direction: [0, 1, 0], spread: 40, speed: 2, rate: 60,
                          mass: 0.01, lifetime: 0.7, seed: 715}
            """), Map.entry("births beside a stiff net", """
            shapes:
              - cloth: {corner: [-0.5, 0.5, 0], across: [1, 0, 0], down: [0, 0, 1], columns: 5, rows: 5, totalMass: 0.2,
                        fixed: corners, structural: {stiffness: 1e5, damping: 1}}
            rules:
              - tear: {strain: 0.3}
              - emitter: {id: spark, position: [0, 1, 0], spread: 60, speed: 1, rate: 50, mass: 0.01, lifetime: 0.3,
                          seed: 3}
              - kill: {point: [0, 1.05, 0], normal: [0, -1, 0]}
            """), Map.entry("rope shaken on rough ground", """
            shapes:
              - rope: {start: [0, 0.3, 0], end: [1.5, 0, 0], particles: 16, totalMass: 0.3, fixed: start,
                       structural: {stiffness: 500, damping: 0.1}}
            impact: clamp
            rules:
              - ground: {restitution: 0, friction: {law: coulomb, coefficient: 0.5}}
              - shake: {particle: "rope[0]", amplitude: [0, 0.2, 0], period: 0.4}
            """));

    private OwnScenes() {
    }

    /** @return the texts of the scenes by name, in a fixed order */
    static Map<String, String> all() {
        Map<String, String> scenes = new TreeMap<>();
        BODIES.forEach((body, things) -> GROUNDS.forEach((ground, rules) -> scenes.put(body + " on " + ground,
                HEAD + things + "effects:\n  - gravity\n" + rules.replace("FRICTION", FRICTION))));
        OTHERS.forEach((name, text) -> scenes.put(name, HEAD + text + "effects:\n  - gravity\n"
                + (name.endsWith("drag") ? "  - drag: {coefficient: 2}\n" : "")));
        return scenes;
    }

    private static String rods(int count) {
        StringBuilder particles = new StringBuilder("particles:\n  - {id: p0, position: [0, 0, 0], fixed: true}\n");
        StringBuilder rods = new StringBuilder("rods:\n");
        for (int i = 1; i <= count; i++) {
            particles.append("  - {id: p" + i + ", position: [" + i * 0.01 + ", 0, 0], mass: 0.01}\n");
            rods.append("  - {from: p" + (i - 1) + ", to: p" + i + "}\n");
        }
        return particles.append(rods).toString();
    }
}
