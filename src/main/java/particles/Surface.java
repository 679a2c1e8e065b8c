package particles;

/**
 * A surface spanned by particles, to be drawn shaded.
 *
 * @param triangles indices of particles, three a triangle, counter-clockwise seen from the front
 */
public record Surface(int[] triangles) {
}
