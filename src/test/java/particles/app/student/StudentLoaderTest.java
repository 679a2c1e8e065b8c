package particles.app.student;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A class that does not compile breaks what uses it, with the compiler's messages, and nothing else. */
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
        String message = "it does not compile: Broken.java:3: cannot find symbol: variable y\n"
                + "  Broken.java:4: cannot find symbol: variable w";
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
    void aWrongPackageAndAWrongNameAreToldAsSuch() throws Exception {
        StudentLoader loader = loader("Mine", "");
        Path classes = folder.resolve("exercises");
        Files.writeString(classes.resolve("Homeless.java"), "public class Homeless { }");
        Files.writeString(classes.resolve("Renamed.java"), "package exercises; class Other { }");
        Files.writeString(classes.resolve("Public.java"), "package exercises; public class Other { }");
        for (String[] pair : new String[][] {
            {"Homeless", "Homeless.java: the first line has to be 'package exercises;'"},
            {"Renamed", "Renamed.java: the class in it has to be called Renamed, as the file is"},
            {"Public", "it does not compile: Public.java:1: class Other is public, should be declared in a file named"
                    + " Other.java"}}) {
            assertEquals(pair[1], assertThrows(IllegalArgumentException.class,
                    () -> loader.loadClass("exercises." + pair[0])).getMessage());
        }
    }

    @Test
    void whatIsNotThereIsNotFound() throws Exception {
        StudentLoader loader = loader("Mine", "class Inner { }");
        assertThrows(ClassNotFoundException.class, () -> loader.loadClass("exercises.Yours"));
        assertThrows(ClassNotFoundException.class, () -> loader.loadClass("exercises.Mine$Outer"));
        assertThrows(ClassNotFoundException.class, () -> loader.loadClass("Mine"));
    }
}
