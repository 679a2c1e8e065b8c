/**
 * The types of which a file format is declared: mappings with typed keys. One declaration serves three purposes, which
 * therefore agree: reading a file, reporting its mistakes with their places, and the JSON Schema by which editors
 * complete and check a file as it is typed.
 *
 * <p>A {@link particles.spec.Key} has a name, a {@link particles.spec.Type}, a default and a sentence; a {@link
 * particles.spec.MappingType} is a set of keys; {@link particles.spec.YamlText} parses a file into a tree of nodes with
 * places, and refuses files that could exhaust memory or time. {@link particles.spec.Reference} writes the tables of a
 * format's keys.
 */
package particles.spec;
