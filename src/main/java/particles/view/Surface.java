package particles.view;

/**
 * A surface spanned by particles, to be drawn shaded.
 *
 * @param triangles indices of particles, three a triangle, counter-clockwise seen from the front
 * @param ofSprings whether it is the springs along its edges that hold it together: a triangle that keeps fewer than
 *                  two of them is torn, and is not drawn
 */
public record Surface(int[] triangles, boolean ofSprings) {
}
