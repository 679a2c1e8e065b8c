package architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;
import org.junit.jupiter.api.Test;
import particles.reactions.RestingContacts;

/**
 * Contact is solved in four phases over plain data: gather, evaluate, solve, apply. Checks that no class knows one of a
 * later phase, and that no classes know each other in a cycle. jdeps reads the dependencies from the compiled classes.
 */
class ContactPhasesTest {
    private static final String ROOM = RestingContacts.class.getPackageName();
    private static final Pattern EDGE = Pattern.compile("(?m)^ +" + Pattern.quote(ROOM + ".") + "(\\w+)\\S* +-> (?:"
            + Pattern.quote(ROOM + ".") + "(\\w+))?");

    private static final List<Set<String>> PHASES = List.of(
            Set.of("Tolerances", "ContactSurface", "Curve", "ContactModes", "Row", "Contacts", "Block"),
            Set.of("GatherPhase"),
            Set.of("EvaluatePhase", "SlidingFriction"),
            Set.of("SolvePhase", "ActiveSetMethod", "NormalForces", "StaticFriction"),
            Set.of("ApplyPhase", "ContactDerivative", "BlockImpacts", "ContactQueries", "RestingContacts",
                    "RigidConstraints", "BallContacts"));

    /** For each class of the room, the others that it uses; nested classes count as the outer one. */
    private static Map<String, Set<String>> uses() throws Exception {
        StringWriter out = new StringWriter();
        String classes = RestingContacts.class.getProtectionDomain().getCodeSource().getLocation().getPath();
        int exit = ToolProvider.findFirst("jdeps").orElseThrow().run(new PrintWriter(out), new PrintWriter(out),
                "-verbose:class", "-filter:none", "--ignore-missing-deps", "--multi-release", "17", "-include",
                Pattern.quote(ROOM) + "\\..*", classes);
        assertEquals(0, exit, out.toString());
        Map<String, Set<String>> uses = new TreeMap<>();
        Matcher edge = EDGE.matcher(out.toString());
        while (edge.find()) {
            Set<String> used = uses.computeIfAbsent(edge.group(1), name -> new TreeSet<>());
            if (edge.group(2) != null && !edge.group(2).equals(edge.group(1))) {
                used.add(edge.group(2));
            }
        }
        return uses;
    }

    /** Removes those that use none of the remaining ones; a cycle, and what uses it, remains. */
    private static Set<String> inCycles(Map<String, Set<String>> uses) {
        Map<String, Set<String>> left = new TreeMap<>(uses);
        while (left.entrySet().removeIf(entry -> entry.getValue().stream().noneMatch(left::containsKey))) {
            assertTrue(left.size() < uses.size());
        }
        return left.keySet();
    }

    private static int phase(String name) {
        for (int phase = 0; phase < PHASES.size(); phase++) {
            if (PHASES.get(phase).contains(name)) {
                return phase;
            }
        }
        throw new AssertionError(name + " belongs to no phase");
    }

    @Test
    void noClassesKnowEachOtherInACycle() throws Exception {
        assertEquals(Set.of(), inCycles(uses()));
        Map<String, Set<String>> wrong = new LinkedHashMap<>(uses());
        wrong.put("Row", Set.of("RigidConstraints"));
        assertTrue(inCycles(wrong).containsAll(Set.of("Row", "RigidConstraints")), "the test finds a cycle");
    }

    @Test
    void noClassKnowsOneOfALaterPhase() throws Exception {
        Set<String> wrong = new TreeSet<>();
        Map<String, Set<String>> uses = uses();
        uses.forEach((name, used) -> used.stream().filter(other -> phase(other) > phase(name))
                .forEach(other -> wrong.add(name + " uses " + other)));
        assertEquals(Set.of(), wrong);
        Set<String> all = new TreeSet<>();
        PHASES.forEach(all::addAll);
        assertEquals(all, uses.keySet(), "every class has a phase, and every name is that of a class");
    }
}
