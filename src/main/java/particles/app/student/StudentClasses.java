package particles.app.student;

import particles.spec.ClassNames;
import particles.spec.Kind;

/** Finds the classes that scenes name; {@link StudentLoader} compiles those of students. */
public final class StudentClasses implements ClassNames {
    private static final String KEYS = "$Keys";

    @Override
    public <K extends Kind> K find(String name, Class<K> type) {
        K kind = make(name, type);
        if (!kind.getName().equals(name)) {
            throw new IllegalArgumentException("the Keys of " + name + " call it '" + kind.getName()
                    + "'; write super(\"" + name + "\", ...) in their constructor");
        }
        return kind;
    }

    private static <K extends Kind> K make(String name, Class<K> type) {
        try {
            return Class.forName(name + KEYS, true, Thread.currentThread().getContextClassLoader()).asSubclass(type)
                    .getConstructor().newInstance();
        } catch (ClassNotFoundException e) {
            throw new IllegalArgumentException("there is no class " + name + " with a 'public static final class Keys"
                    + " extends " + type.getSimpleName() + "' in src/main/java/exercises; gradle newEffect writes one",
                    e);
        } catch (ReflectiveOperationException | ClassCastException | LinkageError e) {
            throw new IllegalArgumentException("the Keys of " + name
                    + " cannot be created; they have to be a 'public static final"
                    + " class Keys extends " + type.getSimpleName() + "' with a 'public Keys()': "
                    + (e.getCause() == null ? e : e.getCause()), e);
        }
    }
}
