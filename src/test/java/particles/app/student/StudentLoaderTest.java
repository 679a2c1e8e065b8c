package particles.app.student;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A class that does not compile breaks what uses it, with the compiler's first message, and nothing else. */
class StudentLoaderTest {
    @TempDir
    private Path folder;

    private StudentLoader loader(String... namesAndBodies) throws Exception {
        Path classes = Files.createDirectories(folder.resolve("exercises"));
        for (int k = 0; k < namesAndBodies.length; k += 2) {
            Files.writeString(classes.resolve(namesAndBodies[k] + ".java"), "package exercises;\npublic class "
                    + namesAndBodies[k] + " {\n"
                    + namesAndBodies[k + 1] + "\n}\n");
        }
        return new StudentLoader(classes, getClass().getClassLoader());
    }

    @Test
    void oneThatDoesNotCompileBreaksWhatUsesItOnly() throws Exception {
        StudentLoader loader = loader("Good",
                "public static int of() { return Helper.ONE + new Inner().two; } static class Inner { int two = 2; }",
                "Helper", "static final int ONE = Integer.valueOf(1);", "Broken", "int x = y;\nint z = w;", "User",
                        "Broken broken;");
        assertEquals(3, loader.loadClass("exercises.Good").getMethod("of").invoke(null));
        String message = "Broken.java:3: it does not compile: cannot find symbol symbol: variable y location: class"
                + " exercises.Broken";
        assertEquals(message, assertThrows(IllegalArgumentException.class,
                () -> loader.loadClass("exercises.Broken")).getMessage());
        assertEquals(message, assertThrows(IllegalArgumentException.class,
                () -> loader.loadClass("exercises.User")).getMessage());
    }

    @Test
    void theProgramsOwnClassesAreTheProgramsOwn() throws Exception {
        StudentLoader loader = loader("Mine", "public static Class<?> base() { return deSolvers.EulerSolver.class; }");
        assertEquals(deSolvers.EulerSolver.class, loader.loadClass("exercises.Mine").getMethod("base").invoke(null));
    }

    @Test
    void whatIsNotThereIsNotFound() throws Exception {
        StudentLoader loader = loader("Mine", "class Inner { }");
        assertThrows(ClassNotFoundException.class, () -> loader.loadClass("exercises.Yours"));
        assertThrows(ClassNotFoundException.class, () -> loader.loadClass("exercises.Mine$Outer"));
        assertThrows(ClassNotFoundException.class, () -> loader.loadClass("Mine"));
    }
}
