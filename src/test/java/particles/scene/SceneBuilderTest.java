package particles.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import particles.law.Sphere;
import particles.law.Vector3;
import particles.scene.format.OutputDescription.Phase;
import particles.view.Camera;
import particles.view.ParticleStyle;
import particles.view.ParticleStyle.ParticleMark;
import particles.view.RenderOptions;
import particles.view.RenderOptions.Visibility;
import particles.view.Scenery;
import particles.view.Scenery.CurveView;

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
    void aSpringsRestLengthIsItsInitialDistance() {
        assertEquals(3, build(TWO + "springs:\n  - {from: bob, to: tom, stiffness: 7}\n").springs().restLength(0));
    }

    @Test
    void windActsThroughDragInAnyOrder() {
        Scene scene = build(BOB + "effects:\n  - drag: {coefficient: 3}\n  - wind: {mean: [4, 0, 0]}\n");
        double[] force = new double[6];
        scene.system().addUpEffects(scene.system().getOwnState(), 0, force);
        assertEquals(12, force[3]);
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
        assertEquals(List.of(new ParticleMark("bob", Optional.of(0xff0000), 0, "here")), style.marks());
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
