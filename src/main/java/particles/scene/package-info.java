/**
 * Reads scene files and builds simulations from them.
 *
 * <p>{@link particles.scene.SceneReader} reads a file into a {@link particles.scene.format.SceneDescription}, or
 * reports all problems with their places; {@link particles.scene.SceneBuilder} builds what the description names. The
 * format is declared once, in {@link particles.scene.format.SceneFormat} and the catalogues {@link
 * particles.scene.parts.ShapeKind}, {@link particles.effects.EffectCatalog} and {@link particles.scene.parts.RuleKind}.
 * {@link particles.scene.SceneChecks} has the conditions between its parts. {@link particles.scene.BlowUpMessage} says
 * why a run of a scene cannot go on, and what to try.
 */
package particles.scene;
