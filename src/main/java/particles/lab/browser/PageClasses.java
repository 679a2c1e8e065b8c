package particles.lab.browser;

import deSolvers.DESolver;
import java.util.NoSuchElementException;
import java.util.function.Supplier;
import particles.spec.ClassNames;
import particles.spec.Kind;

/** Finds the students' classes that are in the page. */
final class PageClasses implements ClassNames {

    @Override
    public <K extends Kind> K find(String name, Class<K> type) {
        Supplier<?> maker = Students.EFFECTS.get(name);
        if (maker == null) {
            throw new IllegalArgumentException(name
                    + " is not in this page; name it in a scene and type: gradle lab -Pscene=FILE");
        }
        return type.cast(maker.get());
    }

    /** A solver; one with tolerances has to be in the catalogue. */
    static DESolver solver(String name, Double... tolerances) {
        Supplier<DESolver> maker = Students.SOLVERS.get(name);
        if (maker == null) {
            throw new NoSuchElementException(name + " is not in this page; type: gradle lab -Psolver=" + name);
        }
        if (tolerances.length > 0) {
            throw new IllegalArgumentException("a solver of your own takes no tolerances in this page");
        }
        return maker.get();
    }
}
