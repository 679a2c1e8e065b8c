package particles.view;

/**
 * A surface spanned by particles, to be drawn shaded.
 *
 * @param triangles indices of particles, three a triangle, counter-clockwise seen from the front
 * @param ofSprings whether springs along the edges hold it together: a triangle with fewer than two of them left is
 *                  torn and not drawn
 */
public record Surface(int[] triangles, boolean ofSprings) {
}
