package hunts;

import deSolvers.DESolver;
import deSolvers.text.DidYouMean;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

/**
 * Runs mutation tests of solvers and effects, package by package: changes one instruction at a time and counts the
 * changes that a test notices. Only a package's own tests and a few others are run against its mutants; all of them
 * would take hours. {@code gradle mutationTests -Ppackage=deSolvers.adaptive} runs it for one package.
 */
final class MutationTests {
    /** The least percentage of killed mutants for each package. */
    private static final int LEAST_KILLED = 85;
    /** A test times out after twice its usual time plus this (ms). */
    private static final int PATIENCE = 2000;
    private static final Path REPORTS = Path.of("build", "reports", "mutations");

    /** Packages, each with further tests to run besides its own. */
    private static final Map<String, String> PACKAGES = new TreeMap<>(Map.ofEntries(
            Map.entry("deSolvers", "particles.ArrayStateSourceTest"),
            Map.entry("deSolvers.adaptive", ""),
            Map.entry("deSolvers.catalog", ""),
            Map.entry("deSolvers.extrapolation", ""),
            Map.entry("deSolvers.implicit", ""),
            Map.entry("deSolvers.linear", ""),
            Map.entry("deSolvers.multistep", ""),
            Map.entry("deSolvers.rungeKutta", "deSolvers.adaptive.DormandPrinceSolverTest"),
            Map.entry("deSolvers.symplectic", ""),
            Map.entry("deSolvers.text", ""),
            Map.entry("particles.effects",
            "particles.LawsOnRandomSystemsTest,particles.engine.ParticleJacobianTest,particles.ArrayStateSourceTest")));

    private MutationTests() {
    }

    private static String classesOf(String packageName) {
        return "~" + packageName.replace(".", "\\.") + "\\.[A-Z].*";
    }

    /** @return the command that starts PIT for a package */
    private static List<String> command(String packageName) throws URISyntaxException {
        String others = PACKAGES.get(packageName);
        Path classes = Path.of(DESolver.class.getProtectionDomain().getCodeSource().getLocation().toURI());
        return List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
                System.getProperty("java.class.path"), "org.pitest.mutationtest.commandline.MutationCoverageReport",
                "--reportDir", REPORTS.resolve(packageName).toString(), "--timestampedReports=false",
                "--outputFormats", "HTML", "--mutationThreshold", Integer.toString(LEAST_KILLED),
                "--targetClasses", classesOf(packageName), "--mutableCodePaths", classes.toString(),
                "--targetTests", classesOf(packageName) + (others.isEmpty() ? "" : "," + others), "--excludedGroups",
                "hard,slow",
                "--sourceDirs", Path.of("src", "main", "java").toString(), "--verbosity=NO_SPINNER",
                "--timeoutConst", Integer.toString(PATIENCE), "--timeoutFactor", "2",
                "--threads", Integer.toString(Math.max(1, Runtime.getRuntime().availableProcessors() / 2)),
                "--jvmArgs", "-Djava.awt.headless=true");
    }

    /** Runs PIT on a package; returns whether it killed enough. */
    private static boolean run(String packageName) throws IOException, InterruptedException, URISyntaxException {
        Files.createDirectories(REPORTS);
        Path log = REPORTS.resolve(packageName + ".log");
        long begin = System.nanoTime();
        Process pit = new ProcessBuilder(command(packageName)).redirectErrorStream(true).redirectOutput(log.toFile())
                .start();
        Thread end = new Thread(() -> {
            pit.descendants().forEach(ProcessHandle::destroy);
            pit.destroy();
        });
        Runtime.getRuntime().addShutdownHook(end);          // Ctrl-C also ends child processes
        int exitCode = pit.waitFor();
        Runtime.getRuntime().removeShutdownHook(end);
        System.out.println(packageName + ":");
        Files.readAllLines(log).stream().filter(line -> line.matches(">> Generated \\d+ mut.*|.* below threshold.*"))
                .forEach(System.out::println);
        System.out.printf(Locale.ROOT, "%.1f minutes; line by line: %s%n%n", (System.nanoTime() - begin) / 60e9,
                REPORTS.resolve(packageName).resolve("index.html"));
        return exitCode == 0;
    }

    /** @return the packages requested */
    static List<String> packages(String[] args) {
        String asked = new TaskOptions(args, List.of("package")).get("package", String.join(",", PACKAGES.keySet()));
        List<String> names = Arrays.asList(asked.split(",", -1));
        for (String name : names) {
            if (!PACKAGES.containsKey(name)) {
                throw new IllegalArgumentException("unknown package '" + name + "'"
                        + DidYouMean.hint(name, PACKAGES.keySet(), "'%s'"::formatted)
                        + " allowed: " + String.join(", ", PACKAGES.keySet()));
            }
        }
        return names;
    }

    /** @param args {@code --package=deSolvers.adaptive,deSolvers.catalog}, or none for all packages */
    public static void main(String[] args) throws IOException, InterruptedException, URISyntaxException {
        List<String> packages;
        try {
            packages = packages(args);
        } catch (IllegalArgumentException e) {
            System.err.println(e.getMessage());
            System.exit(2);
            return;
        }
        List<String> bad = new ArrayList<>();
        for (String name : packages) {
            if (!run(name)) {
                bad.add(name);
            }
        }
        if (!bad.isEmpty()) {
            System.out.println("fewer than " + LEAST_KILLED + " % killed, or tests that fail without mutants: "
                    + String.join(", ", bad) + "; see the logs in " + REPORTS);
            System.exit(1);
        }
    }
}
