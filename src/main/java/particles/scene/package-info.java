/**
 * Scene files: from {@code scenes/x.yaml} to a simulation that is ready to run.
 *
 * <p>{@link particles.scene.SceneReader} reads a file into a {@link particles.scene.format.SceneDescription}, or says
 * everything that is wrong with it, each with its place; {@link particles.scene.SceneBuilder} builds what the
 * description names and nothing else. What may stand in a file is said once, in
 * {@link particles.scene.format.SceneFormat} and the catalogues {@link particles.scene.parts.ShapeKind},
 * {@link particles.effects.EffectCatalog} and {@link particles.scene.parts.RuleKind}.
 */
package particles.scene;
