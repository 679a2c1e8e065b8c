package particles.output;

import particles.Surface;

/** Casts what a frame shows onto a plane's shadow map. */
final class ShadowPainter {
    private double[] columns = {};
    private double[] rows = {};
    private boolean[] above = {};

    /**
     * @param shown   what of it is drawn
     * @param surface surfaces, always drawn
     */
    void paint(ShadowMap map, FrameState state, Shown shown, Sizes sizes, Iterable<Surface> surfaces) {
        map.clear();
        int n = state.particles;
        if (columns.length < n) {
            columns = new double[n];
            rows = new double[n];
            above = new boolean[n];
        }
        double[] p = state.positions;
        for (int i = 0; i < n; i++) {
            columns[i] = map.column(p[3 * i], p[3 * i + 1], p[3 * i + 2]);
            rows[i] = map.row(p[3 * i], p[3 * i + 1], p[3 * i + 2]);
            above[i] = map.isAbove(p[3 * i], p[3 * i + 1], p[3 * i + 2]);       // false where it is no number
            if (above[i] && shown.particle(i)) {
                map.disc(columns[i], rows[i], sizes.ball());
            }
        }
        for (int s = 0; s < state.springs; s++) {
            int a = state.from[s];
            int b = state.to[s];
            if (above[a] && above[b] && shown.spring(a, b)) {
                map.strip(columns[a], rows[a], columns[b], rows[b], sizes.coils() ? 0.5 * sizes.coil() : sizes.tube());
            }
        }
        for (Surface surface : surfaces) {
            int[] t = surface.triangles();
            for (int k = 0; k + 2 < t.length; k += 3) {
                if (t[k] < n && t[k + 1] < n && t[k + 2] < n && above[t[k]] && above[t[k + 1]] && above[t[k + 2]]) {
                    map.triangle(columns[t[k]], rows[t[k]], columns[t[k + 1]], rows[t[k + 1]], columns[t[k + 2]],
                            rows[t[k + 2]]);
                }
            }
        }
        map.blur();
    }
}
