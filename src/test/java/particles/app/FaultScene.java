package particles.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A scene with births, deaths, contact, tears and a moving anchor. */
final class FaultScene {
    private FaultScene() {
    }

    /**
     * @param file     where it is written
     * @param duration s; a second of it takes about half a second of computing time
     */
    static Path write(Path file, double duration) throws IOException {
        return Files.writeString(file, """
                title: Everything at once
                teaches: That nothing is lost.
                solver: adams
                deltaT: 0.0005
                duration: %s
                impact: clamp
                particles:
                  - {id: hand, position: [1, 1.5, 0], fixed: true}
                shapes:
                  - cloth:
                      corner: [-1, 1.5, 0]
                      across: [2, 0, 0]
                      down: [0, -1, 0.2]
                      columns: 12
                      rows: 8
                      totalMass: 0.4
                      fixed: left
                      structural: {stiffness: 20, damping: 0.02}
                      shear: {stiffness: 5, damping: 0.01}
                springs:
                  - {from: hand, to: "cloth[11,4]", stiffness: 40, damping: 0.02}
                effects:
                  - gravity
                  - drag: {coefficient: 0.01}
                rules:
                  - ground: {restitution: 0.4, restSpeed: 0.2, friction: {law: coulomb, coefficient: 0.3}}
                  - tear: {strain: 0.3}
                  - glide: {particle: hand, to: [2.5, 1.5, 0], duration: 4}
                  - emitter: {id: drop, position: [0, 0.5, 0], direction: [0, 1, 0], spread: 20, speed: 3, rate: 20,
                              mass: 0.01, lifetime: 1.5, seed: 7}
                camera: {position: [0, 1, 6], target: [0, 1, 0]}
                output: {frameRate: 10, width: 96, height: 72}
                """.formatted(Double.toString(duration)));
    }
}
