package particles.lab.browser;

import java.util.function.Supplier;
import org.teavm.jso.JSExport;
import particles.lab.Session;
import particles.scene.SceneEditor;
import particles.spec.ClassNames;
import particles.spec.Kind;

/**
 * What the page's scripts begin with: a session that finds the students' effects that are in the page, and changes of a
 * scene's text.
 */
public final class Engine implements ClassNames {
    private Engine() {
    }

    /** @return a session with the page's classes */
    @JSExport
    public static Session session() {
        return new Session(new Engine());
    }

    /** As {@link SceneEditor#place}, for a scene's text. */
    @JSExport
    public static String place(String text, double x, double y, double z) {
        return new SceneEditor(text).place(x, y, z);
    }

    /** As {@link SceneEditor#join}, for a scene's text. */
    @JSExport
    public static String join(String text, String from, String to, boolean muscle) {
        return new SceneEditor(text).join(from, to, muscle);
    }

    /** As {@link SceneEditor#toggleFixed}, for a scene's text. */
    @JSExport
    public static String toggleFixed(String text, String id) {
        return new SceneEditor(text).toggleFixed(id);
    }

    /** As {@link SceneEditor#remove}, for a scene's text. */
    @JSExport
    public static String remove(String text, String id) {
        return new SceneEditor(text).remove(id);
    }

    @Override
    public <K extends Kind> K find(String name, Class<K> type) {
        Supplier<?> maker = Students.EFFECTS.get(name);
        if (maker == null) {
            throw new IllegalArgumentException(name
                    + " is not in this page; name it in a scene and type: gradle lab -Pscene=FILE");
        }
        return type.cast(maker.get());
    }
}
