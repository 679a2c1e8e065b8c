package particles.app.student;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.experiments.runs.ProgressListener;

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
        return new StudentLoader(classes);
    }

    private static void assertFails(String message, StudentLoader loader, String name) {
        assertEquals(message, assertThrows(IllegalArgumentException.class,
                () -> loader.loadClass("exercises." + name)).getMessage());
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
        assertFails(message, loader, "Broken");
        assertFails(message, loader, "User");
    }

    /** A neighbour's name, its body, and how a class uses it. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            Help\u00c4  | public static int two = 2; | return Help\u00c4.two;
            Help$er      | public static int two = 2; | return Help$er.two;
            Helper       | public static int two = 2; | String page = "https://x.y"; return Helper.two;
            Helper       | static int one; } class Extra { static int two = 2; | Helper.one++; return Extra.two;
            EulerSolver  | int x = y;                 | return EulerSolver.class.getName().length() - 19;
            """)
    void neighboursAreFoundAsTheCompilerFindsThem(String name, String body, String use) throws Exception {
        Map<String, String> sources = Map.of(name, "package exercises; class " + name + " {" + body + "}", "Mine", """
                package exercises; import deSolvers.EulerSolver;
                public class Mine { public static int of() { %s } }""".formatted(use));
        Class<?> mine = new StudentLoader(() -> sources).loadClass("exercises.Mine");
        assertEquals(2, mine.getMethod("of").invoke(null));
    }

    @Test
    void theProgramsOwnClassesAreTheProgramsOwn() throws Exception {
        StudentLoader loader = loader("Mine", "public static Class<?> base() { return deSolvers.EulerSolver.class; }");
        assertEquals(deSolvers.EulerSolver.class, loader.loadClass("exercises.Mine").getMethod("base").invoke(null));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            public class Homeless { }                    | Homeless | Homeless.java: it has to begin with \
            'package exercises;', and its class has to be called Homeless, as the file is
            package exercises; class Other { }           | Renamed  | Renamed.java: it has to begin with \
            'package exercises;', and its class has to be called Renamed, as the file is
            package exercises; public class Other { }    | Public   | it does not compile: Public.java:1: class Other \
            is public, should be declared in a file named Other.java
            """)
    void aWrongPackageAndAWrongNameAreToldAsSuch(String text, String name, String message) throws Exception {
        StudentLoader loader = loader();
        Files.writeString(folder.resolve("exercises").resolve(name + ".java"), text);
        assertFails(message, loader, name);
    }

    /** Two tasks that wait for each other run in two threads. */
    @Test
    void allThreadsOfAnExperimentFindIt() throws Exception {
        ClassLoader before = Thread.currentThread().getContextClassLoader();
        loader("First", "", "Second", "").install();
        CountDownLatch both = new CountDownLatch(2);
        ProgressListener quiet = (part, what) -> { };
        try {
            List<String> names = List.of("exercises.First", "exercises.Second");
            assertEquals(names, quiet.onAllCores(names, name -> name, name -> {
                try {
                    both.countDown();
                    both.await(10, TimeUnit.SECONDS);
                    return Class.forName(name, true, Thread.currentThread().getContextClassLoader()).getName();
                } catch (ClassNotFoundException | InterruptedException e) {
                    return e.toString();
                }
            }));
        } finally {
            Thread.currentThread().setContextClassLoader(before);
        }
    }

    @Test
    void whatIsNotThereIsNotFound() throws Exception {
        StudentLoader loader = loader("Mine", "class Inner { }");
        assertThrows(ClassNotFoundException.class, () -> loader.loadClass("exercises.Yours"));
        assertThrows(ClassNotFoundException.class, () -> loader.loadClass("exercises.Mine$Outer"));
        assertThrows(ClassNotFoundException.class, () -> loader.loadClass("Mine"));
    }

    /** So Java reads a letter that the locale lacks, and no path can be made of it. */
    @Test
    void aFileWhoseNameCannotBeReadIsNoNeighbour() throws Exception {
        for (String name : List.of("Good", "L\uFFFDser", "My Solver")) {
            Files.writeString(folder.resolve(name + ".java"), "");
        }
        assertEquals(Map.of("Good", ""), StudentLoader.sources(folder));
    }
}
