/**
 * A small language for saying what may stand in a file: mappings with typed keys. One description serves three ends
 * that therefore cannot contradict each other - reading a file, saying what is wrong in it and where, and the JSON
 * Schema by which editors complete and check while one types.
 *
 * <p>A {@link particles.spec.Key} has a name, a {@link particles.spec.Type}, a default and a sentence;
 * a {@link particles.spec.MappingType} is a set of keys; {@link particles.spec.YamlText} makes a tree of
 * nodes with places out of a file, and refuses whatever could exhaust memory or patience.
 */
package particles.spec;
