package particles.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import particles.law.Effect;
import particles.law.Sphere;
import particles.law.Vector3;
import particles.scene.format.OutputDescription.Phase;
import particles.view.Camera;
import particles.view.CurveView;
import particles.view.ParticleMark;
import particles.view.ParticleStyle;
import particles.view.RenderOptions;
import particles.view.RenderOptions.Visibility;
import particles.view.Scenery;

class SceneBuilderTest {
    private static final String HEAD = "title: T\nteaches: t\nsolver: rk4\ndeltaT: 0.01\nduration: 2\n";
    private static final String BOB = "particles:\n  - {id: bob, position: [0, 3, 0], mass: 2}\n";
    private static final String TWO = BOB + "  - {id: tom, position: [0, 0, 0], mass: 5, fixed: true}\n";

    private static Scene build(String text) {
        return TestScenes.build(HEAD + text);
    }

    private static ParticleStyle style(String text) {
        return build(text).description().drawing().look().style();
    }

    @Test
    void onlyNamedLawsAreBuilt() {
        Scene bare = build(TWO);
        assertEquals(List.of(), bare.system().getEffects());
        assertEquals(List.of(), bare.system().getReactions());
        assertEquals(0, bare.springs().springCount());
        Scene full = build(TWO + "effects:\n  - drag: {coefficient: 1}\n  - wind: {mean: [1, 0, 0]}\n  - gravity\n"
                + "rules: [ground]\nsprings:\n  - {from: bob, to: tom, stiffness: 7}\n");
        assertEquals(List.of("springs", "gravity", "drag"),
                full.system().getEffects().stream().map(Effect::getName).toList());
        assertEquals(1, full.system().getReactions().size());
        assertEquals(3, full.springs().restLength(0), "the initial distance");
        assertEquals(1, full.scenery().planes().size());
    }

    @Test
    void windActsThroughDragInAnyOrder() {
        Scene scene = build(BOB + "effects:\n  - drag: {coefficient: 3}\n  - wind: {mean: [4, 0, 0]}\n");
        double[] force = new double[6];
        scene.system().addUpEffects(scene.system().getOwnState(), 0, force);
        assertEquals(12, force[3]);
    }

    @Test
    void optionsOverrideTheFileAndAreCheckedInTheSameWay() {
        Scene scene = SceneBuilder.build(new Overrides("-P"::concat).with("solver", "euler")
                .with("deltaT", "0.5").with("duration", "1e1")
                .applyTo(TestScenes.read(HEAD + BOB)));
        assertEquals(0.5, scene.simulation().getDeltaT());
        assertEquals(10, scene.simulation().getDuration());
        assertEquals("euler", scene.description().solver());
        assertEquals(List.of("-PdeltaT: the value is 0; it has to be a number over 0 (s)",
                "-Pduration: the value is the text 'long'; it has to be a number from 0 up (s)"),
                refusal(new Overrides("-P"::concat).with("deltaT", "0").with("duration", "long")));
        assertEquals("-Psolver: unknown solver 'rk44'; did you mean 'rk4'?",
                refusal(new Overrides("-P"::concat).with("solver", "rk44")).get(0).replaceFirst(" known:.*", ""));
        assertEquals("-Psolver: no class or solver is called 'my.Solver';",
                refusal(new Overrides("-P"::concat).with("solver", "my.Solver")).get(0).replaceFirst(" known .*", ""));
        assertEquals(List.of("x.yaml:5:11: a duration of 2 s is 2e11 steps of deltaT = 1e-11 s; a run"
                                + " can have at most 1e10"),
                refusal(new Overrides("--"::concat).with("deltaT", "1e-11")));
    }

    private static List<String> refusal(Overrides overrides) {
        return assertThrows(SceneException.class,
                () -> SceneBuilder.build(overrides.applyTo(TestScenes.read(HEAD + BOB)))).getLines();
    }

    /** Each of the three sources alone, from closed forms: g = 9.81, m = 2, T = 2. */
    @Test
    void theEnergyScaleIsTheLargestSourceOfMotion() {
        assertEquals(2 * 9.81 * (3 + 9.81 * 4 / 2), build(TWO + "effects: [gravity]\n").energyEstimate(), 1e-12);
        assertEquals(2 * 25 / 2.0, build(TWO + "effects: [drag: {coefficient: 1}, wind: {mean: [3, 0, 0], "
                + "gust: [0, 2, 0]}]\n").energyEstimate(), 1e-12);
        assertEquals(7 * 4 / 2.0, build(TWO + "springs: [{from: bob, to: tom, stiffness: 7, restLength: 1}]\n")
                .energyEstimate(), 1e-12);
        assertEquals(2 * 16 / 2.0, build(BOB.replace("mass: 2",
                "mass: 2, velocity: [0, 0, 4]")).energyEstimate(), 1e-12);
    }

    @Test
    void aSceneWhereNothingMovesHasAScaleToo() {
        assertEquals(2 * 1.5 * 1.5 / 2, build(TWO).energyEstimate(), 1e-12, "3 m in 2 s");
        assertEquals(2 * 0.5 * 0.5 / 2, build(BOB).energyEstimate(), 1e-12, "no extent: 1 m in 2 s");
        assertEquals(1, build(BOB.replace("mass: 2", "fixed: true")).energyEstimate());
        assertTrue(SceneBuilder.build(TestScenes.read(HEAD + BOB).withDuration(0)).energyEstimate() > 0);
        assertEquals(1e3 * build(BOB).energyEstimate(), build(BOB
                + "blowUpFactor: 1e3\n").energyLimit(), 1e-9);
    }

    @Test
    void theSceneSetsCameraLookAndOutput() {
        Scene plain = build(BOB);
        assertEquals(Optional.empty(), plain.description().drawing().camera());
        assertEquals(RenderOptions.STANDARD, plain.description().drawing().look());
        assertEquals(Optional.empty(), plain.description().output().phase());
        Scene told = build(BOB + "camera: {position: [0, 0, 10], target: [0, 0, 0], fieldOfView: 90, "
                + "projection: orthographic}\nlook: {springs: always, frontColour: '#00ff10'}\noutput: "
                + "{width: 64, phase: {particle: bob, axis: z}}\n");
        Camera camera = told.description().drawing().camera().orElseThrow();
        assertEquals(new Vector3(0, 1, 0), camera.up());
        assertEquals(20, camera.height(), 1e-12, "2 d tan(45 degrees)");
        assertEquals(0x00ff10, told.description().drawing().look().colours().front());
        assertEquals(Visibility.ALWAYS, told.description().drawing().look().springs());
        Phase phase = told.description().output().phase().orElseThrow();
        assertEquals("bob", phase.particle());
        assertEquals(2, phase.axis());
        assertEquals(Optional.empty(), phase.about());
        assertEquals(64, told.description().output().frames().width());
        assertEquals(25, told.description().output().frames().rate());
    }

    /** A glow is visible by night only, so night is its default. */
    @Test
    void theSceneSetsTheStyleOfParticles() {
        ParticleStyle fire = style(BOB + "look: {particlesAs: glow, ageColours: ['#ffffff', '#800000'], trail: 0.5}\n");
        assertEquals(new ParticleStyle(ParticleStyle.Kind.GLOW, List.of(0xffffff, 0x800000), 0.5, true), fire);
        ParticleStyle day = style(BOB + "look: {particlesAs: glow, sky: day}\n");
        assertEquals(new ParticleStyle(ParticleStyle.Kind.GLOW, ParticleStyle.STANDARD.ageColours(), 0, false), day);
        assertEquals(ParticleStyle.Kind.BLOBS, style(BOB + "look: {particlesAs: blobs}\n").kind());
        assertEquals(ParticleStyle.STANDARD, style(BOB + "look: {trail: 0}\n"));
    }

    @Test
    void aParticleCanBeDrawnInItsOwnWay() {
        ParticleStyle style = style(BOB
                + "look: {velocityArrows: 0.2, marks: [{particle: bob, colour: '#ff0000', label: here}]}\n");
        assertEquals(0.2, style.arrows());
        assertEquals(List.of(new ParticleMark("bob", OptionalInt.of(0xff0000), 0, "here")), style.marks());
        String problem = assertThrows(SceneException.class, () -> build(BOB + "look: {marks: [{particle: bib}]}\n"))
                .getMessage();
        assertTrue(problem.contains("unknown particle 'bib'; did you mean 'bob'?"), problem);
    }

    /** Solids and wires of rules, effects and constraints are drawn. */
    @Test
    void solidsAndWiresAreDrawn() {
        Scenery scenery = build(BOB + """
                effects:
                  - penaltyPlane: {point: [0, -9, 0], stiffness: 10}
                  - penaltySphere: {centre: [8, -9, 0], radius: 2, stiffness: 10}
                rules:
                  - plane: {normal: [0, 1, 0.5], point: [0, -8, 0]}
                  - sphere: {centre: [0, 0, 0], radius: 50, hollow: true}
                wires:
                  - circle: {bead: bob, centre: [0, 2, 0], radius: 1}
                """).scenery();
        assertEquals(2, scenery.planes().size());
        assertEquals(List.of(false, true), scenery.spheres().stream().map(Sphere::hollow).toList());
        CurveView ring = scenery.wires().get(0);
        assertEquals(2 * Math.PI, ring.length(), 1e-12);
        for (double u = 0; u < 7; u++) {
            assertEquals(1, ring.at(u).minus(new Vector3(0, 2, 0)).length(), 1e-12);
        }
        assertEquals(0, ring.at(0).minus(ring.at(ring.length())).length(), 1e-12);
        assertEquals(Scenery.NONE, build(BOB).scenery());
    }
}
