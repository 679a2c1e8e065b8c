package particles.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import deSolvers.catalog.SolverCatalog;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import particles.effects.EffectCatalog;
import particles.effects.EffectKind;
import particles.spec.messages.InvalidInputException;

/** Each mistake in a scene file is reported in one line with its place, what was found and what is allowed. */
class BrokenScenesTest {
    /** Seven valid lines, so that a case's own lines begin at line 8. */
    private static final String HEAD = """
            title: Broken
            teaches: what messages look like
            solver: rk4
            deltaT: 0.01
            duration: 1
            particles:
              - {id: bob, position: [0, 1, 0]}
            """;

    /** Lines added to the head, and below them the messages. */
    private static final String ADDED = """
            effects:
              - gravty
            x.yaml:9:5: unknown effect 'gravty'; did you mean 'gravity'? known: {effects}

            efects: []
            x.yaml:8:1: unknown key 'efects'; did you mean 'effects'? known in the scene: {keys}

            friction: 0.5
            x.yaml:8:1: unknown key 'friction'; it is a key of 'ground', 'plane', 'sphere', 'collisions'; known in \
            the scene: {keys}

            effects:
              - friction: 0.5
            x.yaml:9:5: unknown effect 'friction'; it is a key of 'ground', 'plane', 'sphere', 'collisions'; known: \
            {effects}

            output:
              phase: {particle: bob, axis: X}
            x.yaml:9:32: unknown axis 'X'; did you mean 'x'? known: x, y, z, angle

            effects:
              gravity: {}
            x.yaml:9:3: 'effects' is a mapping (key: value); it has to be a list, each entry after a dash: one of \
            {effects}, or the full name of a class, such as exercises.MyForce, with its keys below it

            effects:
              - ground
            x.yaml:9:5: 'ground' is a rule, not an effect; move it to 'rules'

            rules:
              - drag: {coefficient: 1}
            x.yaml:9:5: 'drag' is an effect, not a rule; move it to 'effects'

            effects:
              - gravity:
            x.yaml:9:5: 'gravity' has no value; it has to be keys with values, such as {acceleration: ...}; or \
            write '- gravity', without the colon

            effects:
              - gravity:
                acceleration: [0, -1, 0]
            x.yaml:10:5: an entry names one effect, here 'gravity'; the next line is either one of its keys, \
            indented further, or another effect, which needs its own dash

            effects:
              - drag
            x.yaml:9:5: 'drag' needs a value for at least one key: write '- drag: {coefficient: ...}'

            effects:
              - drag: {coefficient: -1}
            x.yaml:9:25: 'coefficient' is -1; it has to be a number from 0 up (N s/m)

            effects:
              - gravity
              - gravity
            x.yaml:10:5: 'gravity' is already named at line 9

            effects:
              - wind: {mean: [1, 0, 0]}
            x.yaml:9:5: 'wind' only acts together with 'drag' or 'quadraticDrag', which is missing; add '- drag: \
            ...' to 'effects'

            effects:
              - turbulence: {strength: 1}
              - wind: {mean: [1, 0, 0]}
              - drag: {coefficient: 1}
            x.yaml:9:5: 'turbulence' and 'wind' cannot be combined; keep one of them

            rules:
              - shake: {particle: bob, amplitude: [1, 0, 0], period: 1}
            x.yaml:9:23: particle 'bob' is free; only a fixed particle can follow a given motion

            rules:
              - tear: {strain: 0.5}
            x.yaml:9:5: 'tear' acts on springs, and the scene has none

            rules:
              - emitter: {id: bob, position: [0, 0, 0], speed: 1, rate: 1}
            x.yaml:9:19: the id 'bob' is already used at line 7; give another

              - {id: bob, position: [1, 0, 0]}
            x.yaml:8:10: the id 'bob' is already used at line 7; give another

              - {id: tom, position: [1, 0]}
            x.yaml:8:25: 'position' has 2 entries; it has to be three numbers [x, y, z] (m)

              - {id: tom, position: [1, a, .inf], mass: 0}
            x.yaml:8:29: y of 'position' is the text 'a'; it has to be a number (m)
            x.yaml:8:32: z of 'position' is .inf; numbers in a scene are at most 1e30
            x.yaml:8:45: 'mass' is 0; it has to be a number over 0 (kg)

              - {id: 7, postion: [1, 2, 3]}
            x.yaml:8:10: 'id' is 7; it has to be a name of at most 60 characters without spaces, brackets, commas, \
            quotes and invisible characters: put quotes around it, '7'
            x.yaml:8:13: unknown key 'postion'; did you mean 'position'? known in a particle: id, position, \
            velocity, mass, fixed, radius

              - {id: a b, position: [1, 2, 3], fixed: yes}
            x.yaml:8:10: 'id' is the text 'a b'; it has to be a name of at most 60 characters without spaces, \
            brackets, commas, quotes and invisible characters
            x.yaml:8:43: 'fixed' is the text 'yes'; it has to be true or false

              - {id: b\u202eo\u200bb, position: [1, 2, 3]}
            x.yaml:8:10: 'id' is the text 'bU+202EoU+200Bb'; it has to be a name of at most 60 characters without \
            spaces, brackets, commas, quotes and invisible characters

              - {id: thisnameisfartoolongforanybodytotypeandevenlongerthanthatandmore, position: [1, 2, 3]}
            x.yaml:8:10: 'id' is the text 'thisnameisfartoolongforanybodytotypea...'; it has to be a name of at most \
            60 characters without spaces, brackets, commas, quotes and invisible characters

              - {id: tom, position: [1, 2, 3], fixed: true, velocity: [0, 1, 0]}
            x.yaml:8:59: 'tom' is fixed and has a velocity; remove one of the two

              - {id: tom, position: [1, 2, 3], mass: 1, mass: 2}
            x.yaml:8:45: 'mass' appears twice in a particle

              - tom
            x.yaml:8:5: a particle is the text 'tom'; it has to be keys with values, such as {id: ..., position: \
            ...}; keys: id, position, velocity, mass, fixed, radius

            springs:
              - {from: bob, to: bob, stiffness: 1}
            x.yaml:9:21: a spring from 'bob' to itself; its ends must be two different particles

            springs:
              - {from: bob, to: bbo, stiffness: 1}
            x.yaml:9:21: unknown particle 'bbo'; did you mean 'bob'? known: bob

              - {id: tom, position: [0, 1, 0]}
            springs:
              - {from: bob, to: tom, stiffness: 1}
            x.yaml:10:21: 'bob' and 'tom' are at the same place; a spring between them would have no direction, \
            unless it has restLength: 0

              - {id: tom, position: [0, 1, 0]}
            lines:
              - {from: bob, to: tom}
            x.yaml:10:21: 'bob' and 'tom' are at the same place; a line between them would have no length

              - {id: tom, position: [0, 3, 0], velocity: [1, 2, 0]}
            rods:
              - {from: bob, to: tom}
            x.yaml:10:21: the rod from 'bob' to 'tom' cannot keep its length: along it, 'bob' moves at 0 m/s and \
            'tom' at 2 m/s; these speeds must be equal

              - {id: hand, position: [0, 3, 0], fixed: true}
            rods:
              - {from: bob, to: hand}
            rules:
              - shake: {particle: hand, amplitude: [0, 1, 0], period: 6.283185307179586}
            x.yaml:10:21: the rod from 'bob' to 'hand' cannot keep its length: along it, 'bob' moves at 0 m/s and \
            'hand' at 1 m/s; these speeds must be equal

              - {id: tom, position: [0, 3, 0]}
              - {id: sue, position: [0, 7, 0]}
            rods:
              - {from: bob, to: tom}
              - {from: tom, to: sue}
              - {from: sue, to: bob}
            x.yaml:13:5: the rods between sue, tom, bob lie in one line, which only infinite forces could keep \
            straight; leave out the rod from 'sue' to 'bob'

            wires:
              - circle: {bead: bob, centre: [0, 3, 0], radius: 1}
            x.yaml:9:20: 'bob' begins about 1 m off its wire; place it on the wire

            wires:
              - line: {bead: bob, direction: [1, 0, 0]}
            constraints: {feedback: 100}
            x.yaml:10:14: the feedback of rods and wires, 100 /s, is too strong for a deltaT of 0.01 s; feedback \
            times deltaT must be 0.5 at most

            springs:
              - {from: bob}
            x.yaml:9:5: a spring needs 'to': the id of a particle, such as bob or cloth[3,4]
            x.yaml:9:5: a spring needs 'stiffness': a number over 0 (N/m)

            springs:
              - {from: bob, to: rope[1], stiffness: 1}
            x.yaml:9:25: not valid YAML: the '{' of line 9 is not closed before this '[' (an id such as cloth[3,4] \
            needs quotes here)

            shapes:
              - rope: {start: [0, 0, 0], end: [1, 0, 0], particles: 5, mass: 1}
            springs:
              - {from: bob, to: "rope[5]", stiffness: 1}
            x.yaml:11:21: unknown particle 'rope[5]'; known in this shape: rope[0] to rope[4]

            shapes:
              - rope: {start: [0, 0, 0], end: [1, 0, 0], particles: 1, mass: 1, totalMass: 2}
            x.yaml:9:11: 'rope' needs exactly one of 'mass', 'totalMass'
            x.yaml:9:57: 'particles' is 1; it has to be a whole number from 2 to 1000000

            shapes:
              - rope: {start: [0, 0, 0], end: [0, 0, 0], particles: 5, mass: 1}
            x.yaml:9:5: 'rope' has no extent in one direction: its particles would lie on top of each other

            shapes:
              - rope: {start: [0, 0, 0], end: [1, 0, 0], particles: 5, mass: 1, fixed: [strat, "rope[9]"]}
            x.yaml:9:77: unknown part 'strat'; did you mean 'start'? known: start, end, or the id of a particle of \
            the shape, such as ID[0] in a rope, ID[3,4] in a cloth

            shapes:
              - cloth: {corner: [0, 1, 0], across: [1, 0, 0], down: [2, 0, 0], columns: 3, rows: 3, mass: 1}
            x.yaml:9:5: 'cloth' has no extent in one direction: its particles would lie on top of each other

            shapes:
              - jelly: {centre: [0, 0, 0], size: [1, 1, 1], columns: 1000, rows: 1000, layers: 1000, mass: 1}
            x.yaml:9:5: 'jelly' has 1000000000 particles; a scene may have at most 1000000

            shapes:
              - jely: {centre: [0, 0, 0]}
            x.yaml:9:5: unknown shape 'jely'; did you mean 'jelly'? known: rope, cloth, jelly, mesh

            rules:
              - ground: {height: 1.5}
            x.yaml:7:5: 'bob' begins 0.5 m inside the 'ground' of line 9; it has to begin outside

            rules:
              - plane: {normal: [0, 0, 0]}
            x.yaml:9:21: 'normal' is [0, 0, 0]; it has to be three numbers [x, y, z], not all 0

            rules:
              - ground: {restitution: 1.2, friction: {law: columb}}
            x.yaml:9:27: 'restitution' is 1.2; it has to be a number from 0 to 1
            x.yaml:9:42: 'friction' needs 'coefficient': a number from 0 up
            x.yaml:9:48: unknown friction law 'columb'; did you mean 'coulomb'? known: slide, coulomb

            look: {particlesAs: blob}
            x.yaml:8:21: unknown way of drawing 'blob'; did you mean 'blobs'? known: balls, points, blobs, glow

            look: {ageColours: ['#ffffff']}
            x.yaml:8:20: 'ageColours' only works with a glow; add 'particlesAs: glow' or remove it

            look: {particlesAs: glow, ageColours: []}
            x.yaml:8:39: 'ageColours' has 0 colours; allowed are 1 to 16

            look: {trail: 1.2.3, strainRange: 1/0, velocityArrows: 1/2/3}
            x.yaml:8:15: 'trail' is the text '1.2.3'; it has to be a number from 0 up (s)
            x.yaml:8:35: 'strainRange' is the text '1/0'; it has to be a number over 0
            x.yaml:8:56: 'velocityArrows' is the text '1/2/3'; it has to be a number from 0 up (s)

            camera: {position: [0, 1, 0], target: [0, 1, 0]}
            x.yaml:8:39: the camera's target is at the camera's position; choose another point

            camera: {position: [0, 1, 0], target: [0, 0, 0]}
            x.yaml:8:9: the camera looks along its 'up' direction; give another 'up', such as [0, 0, -1]

            look: {particleColour: red, springs: allways}
            x.yaml:8:24: 'particleColour' is the text 'red'; it has to be a colour '#rrggbb' in quotes
            x.yaml:8:38: unknown choice 'allways'; did you mean 'always'? known: always, beside-surfaces, never

            output: {width: 8, frameRate: 0, phase: {particle: tim, axis: w}}
            x.yaml:8:17: 'width' is 8; it has to be a whole number from 16 to 4096
            x.yaml:8:31: 'frameRate' is 0; it has to be a number over 0 (1/s)
            x.yaml:8:52: unknown particle 'tim'; known: bob
            x.yaml:8:63: unknown axis 'w'; known: x, y, z, angle

            output: {phase: {particle: bob, axis: angle}}
            x.yaml:8:39: 'axis: angle' goes with 'about', the particle that the angle is seen from

            output: {phase: {particle: bob, about: bob}}
            x.yaml:8:40: 'axis: angle' goes with 'about', the particle that the angle is seen from

            output: {phase: {particle: bob, axis: angle, about: bob}}
            x.yaml:8:53: a particle has no angle about itself

            blowUpFactor:
            x.yaml:8:1: 'blowUpFactor' has no value; it has to be a number over 0

            title: again
            x.yaml:8:1: 'title' appears twice in the scene

            more: &a [1]
            less: *a
            x.yaml:8:7: anchors and aliases (&name, *name) are not used in scenes; write the values out, or put \
            quotes around a text that begins with & or *
            x.yaml:9:7: anchors and aliases (&name, *name) are not used in scenes; write the values out, or put \
            quotes around a text that begins with & or *

            camera: {position: 1, 0}
            x.yaml:8:9: the camera needs 'target': three numbers [x, y, z] (m)
            x.yaml:8:20: 'position' is 1; it has to be three numbers [x, y, z] (m)
            x.yaml:8:23: a number where a key of the camera should be; numbers have a decimal point, not a comma, \
            and several of them stand in [ ]

            ? [a]
            : 1
            x.yaml:8:3: a key of the scene is [a]; it has to be one of {quoted}

            ---
            title: second
            x.yaml:8:1: a second document begins; a file holds one scene

            \tx: 1
            x.yaml:8:1: not valid YAML: a tab; YAML is indented by spaces

            rules: [a
            x.yaml:9:1: not valid YAML: the '[' of line 8 is not closed before the end

            impact: exactly
            x.yaml:8:9: unknown kind of impact 'exactly'; did you mean 'exact'? known: clamp, exact

            wires:
              - circle: {bead: bob, centre: [0, 1, 0], radius: 1}
            x.yaml:9:20: 'bob' begins far off its wire; place it on the wire

            rules:
              - sphere: {centre: [0, 0, 0], radius: 0.75, hollow: true}
            x.yaml:7:5: 'bob' begins 0.25 m outside the hollow 'sphere' of line 9; it has to begin inside
            """;

    /** Whole files, and below them the messages. */
    private static final String WHOLE = """
            title: Broken
            teaches: what messages look like
            solver: {name: rk4, relativeTolerance: 1e-3}
            deltaT: 0.01
            duration: 1
            particles:
              - {id: bob, position: [0, 1, 0]}
            x.yaml:3:40: solver 'rk4' takes steps of deltaT and has no tolerances; solvers with tolerances: \
            {adaptive}

            title: Broken
            teaches: what messages look like
            solver: {name: dormand-prince, tolerance: 2}
            deltaT: 0.01
            duration: 1
            particles:
              - {id: bob, position: [0, 1, 0]}
            x.yaml:3:32: unknown key 'tolerance'; known in the solver: name, relativeTolerance, absoluteTolerance

            title: Broken
            teaches: what messages look like
            solver: {name: bulirsch-stoer, relativeTolerance: 0.1}
            deltaT: 0.01
            duration: 1
            particles:
              - {id: bob, position: [0, 1, 0]}
            x.yaml:3:51: 'relativeTolerance' is 0.1; it has to be a number from 0 to 0.001

            x.yaml: the file is empty

            # nothing
            x.yaml: the file is empty

            just a text
            x.yaml:1:1: the scene is the text 'just a text'; it has to be keys with values, such as {title: ..., \
            teaches: ..., solver: ..., deltaT: ..., duration: ...}; keys: {keys}

            title: A: B
            x.yaml:1:9: not valid YAML: this ':' cannot stand here; a text with a colon needs quotes, or the line \
            is indented too far

            title: a
              solver: rk4
            x.yaml:2:9: not valid YAML: this ':' cannot stand here; a text with a colon needs quotes, or the line \
            is indented too far

            deltaT:0.01
            duration: 1
            x.yaml:1:8: a space is missing after 'deltaT:'; write 'deltaT: 0.01'

            deltaT:\u00a00.01
            duration: 1
            x.yaml:1:8: a no-break space is here, which YAML does not take for a space; type an ordinary space instead

            title: \u201cTyping: a title\u201d
            x.yaml:1:8: a curly quote is here, which YAML does not take for a quote; type an ordinary ' or " instead

            particles:
              - {id: bob, position: [0, '1' 0]}
            x.yaml:2:33: not valid YAML: the '[' of line 2 is not closed before this; a comma or the closing bracket \
            is missing

            particles:
              - {id: bob, position: [0, 1, 0
            effects:
            x.yaml:3:8: not valid YAML: the '[' of line 2 is not closed before this ':'

            particles:
              - {id: bob, position: [0, 1, 0}
            x.yaml:2:33: not valid YAML: the '[' of line 2 is not closed before this '}'

            particles:
              - {id: a}
             - {id: b}
            x.yaml:3:2: not valid YAML: this line is not indented like the lines that it follows

            title: "a" b
            x.yaml:1:12: not valid YAML: a text continues after its closing quote

            title: ""
            solver: rk5
            deltaT: 0
            duration: soon
            x.yaml:1:1: the scene needs 'teaches': a text that is not empty, without control characters
            x.yaml:1:8: 'title' is the text ''; it has to be a text that is not empty, without control characters
            x.yaml:2:9: unknown solver 'rk5'; did you mean 'rk4'? known: {solvers}, or the full name of a class, \
            such as exercises.MySolver
            x.yaml:3:9: 'deltaT' is 0; it has to be a number over 0 (s)
            x.yaml:4:11: 'duration' is the text 'soon'; it has to be a number from 0 up (s)

            title: "a\\x07b"
            teaches: "two\\tlines\\n"
            solver: rk4
            deltaT: 0
            duration: 1
            x.yaml:1:8: 'title' is the text 'a b'; it has to be a text that is not empty, without control characters
            x.yaml:4:9: 'deltaT' is 0; it has to be a number over 0 (s)

            title: A
            teaches: B
            solver: rk4
            deltaT: 0.01
            duration: 1
            x.yaml:1:1: the scene has no particle at the start; add some under 'particles' or 'shapes'

            title: A
            teaches: B
            solver: rk4
            deltaT: 1e-9
            duration: 1e7
            particles: [{id: a, position: [0, 0, 0]}]
            x.yaml:5:11: a duration of 1e7 s is 1e16 steps of deltaT = 1e-9 s; a run can have at most 1e10

            title: A
            teaches: B
            solver: rk4
            deltaT: 0.01
            duration: 1
            rules: [emitter: {id: jet, position: [0, 0, 0], speed: 1, rate: 9}]
            x.yaml:1:1: the scene has no particle at the start; add some under 'particles' or 'shapes'
            """;

    /** Each broken scene with its messages; the page of the lab has to give the same ones. */
    static Stream<Arguments> brokenScenes() {
        return Stream.concat(Arrays.stream(ADDED.split("\n\n")).map(HEAD::concat), Arrays.stream(WHOLE.split("\n\n")))
                .map(both -> Arguments.of(both.lines().filter(line -> !isMessage(line)).map(line -> line + "\n")
                        .collect(Collectors.joining()),
                        both.lines().filter(BrokenScenesTest::isMessage).map(BrokenScenesTest::withNames).toList()));
    }

    @ParameterizedTest
    @MethodSource("brokenScenes")
    void everyMistakeIsReported(String scene, List<String> messages) {
        assertEquals(messages, assertThrows(InvalidInputException.class,
                () -> SceneReader.read("x.yaml", scene.getBytes(StandardCharsets.UTF_8))).getLines());
    }

    private static boolean isMessage(String line) {
        return line.startsWith("x.yaml:");
    }

    private static String withNames(String message) {
        List<String> solvers = SolverCatalog.names();
        String keys = """
                title, teaches, solver, deltaT, duration, particles, shapes, springs, rods, lines, faces, wires, \
                constraints, effects, rules, impact, camera, look, output, blowUpFactor, threads, files""";
        return message.replace("{keys}", keys).replace("{quoted}", "'" + keys.replace(", ", "', '") + "'")
                .replace("{effects}", String.join(", ", EffectCatalog.ALL.stream().map(EffectKind::getName).toList()))
                .replace("{adaptive}", String.join(", ", solvers.stream().filter(name ->
                        SolverCatalog.info(name).adaptive()).toList()))
                .replace("{solvers}", String.join(", ", solvers));
    }
}
