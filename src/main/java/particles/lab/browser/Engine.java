package particles.lab.browser;

import java.util.function.Supplier;
import org.teavm.jso.JSExport;
import particles.lab.Session;
import particles.spec.ClassNames;
import particles.spec.Kind;

/** What the page's scripts begin with: a session that finds the students' effects that are in the page. */
public final class Engine implements ClassNames {
    private Engine() {
    }

    /** @return a session with the page's classes */
    @JSExport
    public static Session session() {
        return new Session(new Engine());
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
