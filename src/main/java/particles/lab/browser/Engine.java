package particles.lab.browser;

import org.teavm.jso.JSByRef;
import org.teavm.jso.JSExport;
import particles.lab.Session;

/** The functions that the page's scripts may call; each is the method of {@link Session} of the same name. */
public final class Engine {
    private static final Session SESSION = new Session(new PageClasses());

    private Engine() {
    }

    @JSExport
    public static String openScene(String file, String text, String solver, String deltaT, double tolerance) {
        return SESSION.open(file, text, solver, deltaT, tolerance);
    }

    @JSExport
    public static void advance(double time, double milliseconds) {
        SESSION.advance(time, milliseconds);
    }

    @JSExport
    public static void step() {
        SESSION.step();
    }

    @JSExport
    public static void look(double time) {
        SESSION.look(time);
    }

    @JSExport
    public static void drag(String id, double x, double y, double z) {
        SESSION.drag(id, x, y, z);
    }

    @JSExport
    public static String particle(String id) {
        return SESSION.particle(id);
    }

    @JSExport
    public static String status() {
        return SESSION.status();
    }

    @JSExport
    @JSByRef
    public static float[] state() {
        return SESSION.state();
    }

    @JSExport
    @JSByRef
    public static float[] energies(double time) {
        return SESSION.energies(time);
    }

    @JSExport
    @JSByRef
    public static double[] exactState() {
        return SESSION.exactState();
    }

    @JSExport
    @JSByRef
    public static double[] region(String solver, double left, double bottom, double cell, int columns, int rows) {
        return SESSION.region(solver, left, bottom, cell, columns, rows);
    }

    @JSExport
    public static int structureNumber() {
        return SESSION.structureNumber();
    }

    @JSExport
    public static String ids() {
        return SESSION.ids();
    }

    @JSExport
    @JSByRef
    public static float[] structure() {
        return SESSION.structure();
    }

    @JSExport
    @JSByRef
    public static float[] phase(String id, int axis, double time) {
        return SESSION.phase(id, axis, time);
    }
}
