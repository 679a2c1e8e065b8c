package deSolvers.catalog;

import deSolvers.DESolver;
import deSolvers.EulerSolver;
import deSolvers.MidpointSolver;
import deSolvers.RK4Solver;
import deSolvers.adaptive.DormandPrinceSolver;
import deSolvers.adaptive.StepDoublingSolver;
import deSolvers.extrapolation.BulirschStoerSolver;
import deSolvers.implicit.BackwardEulerSolver;
import deSolvers.implicit.ImplicitMidpointSolver;
import deSolvers.implicit.LinearisedEulerSolver;
import deSolvers.implicit.RadauIIASolver;
import deSolvers.multistep.AdamsBashforthMoultonSolver;
import deSolvers.symplectic.SymplecticEulerSolver;
import deSolvers.symplectic.VelocityVerletSolver;
import deSolvers.symplectic.Yoshida4Solver;
import deSolvers.text.DidYouMean;
import java.lang.reflect.InvocationTargetException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NoSuchElementException;
import java.util.Optional;
import java.util.function.Supplier;

/** The list of all solvers. {@code create("rk4")} creates one; a fully-qualified class name creates a student's own. */
public final class SolverCatalog {
    private static final double NONE = Double.NaN;
    private static final double UNLIMITED = Double.POSITIVE_INFINITY;

    private static final Map<String, Entry> ENTRIES = byName(
            entry(EulerSolver::new, "euler", EulerSolver.class,
                    1, "slides", "1", 2, 0,
                    "One straight step; every undamped spring gains energy."),
            entry(MidpointSolver::new, "midpoint", MidpointSolver.class,
                    2, "slides", "2", 2, 0,
                    "Uses the derivative half way; undamped springs gain energy slowly."),
            entry(RK4Solver::new, "rk4", RK4Solver.class,
                    4, "slides", "4", 2.7853, 2.8284,
                    "The old workhorse: accurate and stable enough for most scenes."),
            adaptive(StepDoublingSolver::new, StepDoublingSolver::new, "step-doubling", StepDoublingSolver.class,
                    4, "adaptive", "11 a sub-step", 5.5706, 5.6569,
                    "Compares two RK4 steps with one of twice the length."),
            adaptive(DormandPrinceSolver::new, DormandPrinceSolver::new, "dormand-prince", DormandPrinceSolver.class,
                    5, "adaptive", "6 a sub-step", 3.3066, 0.9972,
                    "First choice for smooth motion to a stated accuracy."),
            adaptive(BulirschStoerSolver::new, BulirschStoerSolver::new, "bulirsch-stoer", BulirschStoerSolver.class,
                    18, "extrapolation", "9 to 163 a sub-step", NONE, NONE,
                    "Extrapolates midpoint steps: smooth motion, high accuracy."),
            entry(AdamsBashforthMoultonSolver::new, "adams", AdamsBashforthMoultonSolver.class,
                    4, "multistep", "2", 1.2848, 0,
                    "Reuses earlier derivatives: order 4 for two evaluations."),
            symplectic(SymplecticEulerSolver::new, "symplectic-euler", SymplecticEulerSolver.class,
                    1, "symplectic", "1", 2, 0.8284,
                    "The slides' simple algorithm; no energy drift in small steps."),
            symplectic(VelocityVerletSolver::new, "verlet", VelocityVerletSolver.class,
                    2, "symplectic", "1, more with damping", 2, 0.74,
                    "First choice for undamped motion; no energy drift in small steps."),
            symplectic(Yoshida4Solver::new, "yoshida4", Yoshida4Solver.class,
                    4, "symplectic", "3, more with damping", 1.5734, 0.438,
                    "Three verlet steps in one, with order 4."),
            entry(BackwardEulerSolver::new, "backward-euler", BackwardEulerSolver.class,
                    1, "implicit", "2 to 8, tens with rods", UNLIMITED, UNLIMITED,
                    "Damps vibrations that a step cannot resolve."),
            entry(LinearisedEulerSolver::new, "linearised-euler", LinearisedEulerSolver.class,
                    1, "implicit", "1", UNLIMITED, UNLIMITED,
                    "Backward Euler with one linear system a step; for cloth."),
            entry(ImplicitMidpointSolver::new, "implicit-midpoint", ImplicitMidpointSolver.class,
                    2, "implicit", "2 to 8, tens with rods", UNLIMITED, UNLIMITED,
                    "Keeps the energy of linear springs."),
            adaptive(RadauIIASolver::new, RadauIIASolver::new, "radau", RadauIIASolver.class,
                    5, "implicit", "about 10 a sub-step", UNLIMITED, UNLIMITED,
                    "First choice for stiff systems to a stated accuracy."));

    private record Entry(SolverInfo info, Supplier<DESolver> maker, WithTolerances toleranceMaker) {
    }

    /** Makes an adaptive solver. */
    private interface WithTolerances {
        DESolver create(double relativeTolerance, double absoluteTolerance);
    }

    private SolverCatalog() {
    }

    /** The entry of a solver that steps by deltaT. */
    private static Entry entry(Supplier<DESolver> maker, String name, Class<? extends DESolver> solver, int order,
                               String family, String evaluations, double realLimit, double imaginaryLimit,
                               String sentence) {
        SolverInfo info = new SolverInfo(name, solver.getName(), order, family, evaluations, false, false,
                realLimit, imaginaryLimit, realLimit, sentence);
        return new Entry(info, maker, (relative, absolute) -> throwNotAdaptive(name));
    }

    /** The entry of a solver that steps positions and velocities separately. */
    private static Entry symplectic(Supplier<DESolver> maker, String name, Class<? extends DESolver> solver, int order,
                                    String family, String evaluations, double imaginaryLimit, double dampedLimit,
                                    String sentence) {
        SolverInfo info = new SolverInfo(name, solver.getName(), order, family, evaluations, false, true, NONE,
                imaginaryLimit, dampedLimit, sentence);
        return new Entry(info, maker, (relative, absolute) -> throwNotAdaptive(name));
    }

    /** The entry of a solver that chooses its own sub-steps. */
    private static Entry adaptive(Supplier<DESolver> maker, WithTolerances toleranceMaker, String name,
                                  Class<? extends DESolver> solver, int order, String family, String evaluations,
                                  double realLimit, double imaginaryLimit, String sentence) {
        SolverInfo info = new SolverInfo(name, solver.getName(), order, family, evaluations, true, false, realLimit,
                imaginaryLimit, realLimit, sentence);
        return new Entry(info, maker, toleranceMaker);
    }

    private static DESolver throwNotAdaptive(String name) {
        throw new IllegalArgumentException("solver '" + name
                + "' steps by deltaT and takes no tolerances; adaptive are: "
                + String.join(", ", all().stream().filter(SolverInfo::adaptive).map(SolverInfo::name).toList()));
    }

    private static Map<String, Entry> byName(Entry... entries) {
        Map<String, Entry> byName = new LinkedHashMap<>();
        for (Entry entry : entries) {
            byName.put(entry.info().name(), entry);
        }
        return Collections.unmodifiableMap(byName);
    }

    /** @return the data of all solvers, in teaching order */
    public static List<SolverInfo> all() {
        List<SolverInfo> all = new ArrayList<>();
        ENTRIES.values().forEach(entry -> all.add(entry.info()));
        return all;
    }

    /** @return the names of all solvers, in teaching order */
    public static List<String> names() {
        return List.copyOf(ENTRIES.keySet());
    }

    /**
     * @param name a solver's name
     * @return its entry; empty for a class of one's own
     */
    public static Optional<SolverInfo> find(String name) {
        return Optional.ofNullable(ENTRIES.get(name)).map(Entry::info);
    }

    /**
     * Returns a solver's entry.
     *
     * @param name a catalogue name
     * @return the data of that solver
     * @throws NoSuchElementException if no solver has this name
     */
    public static SolverInfo info(String name) {
        Entry entry = ENTRIES.get(name);
        if (entry == null) {
            throw new NoSuchElementException("unknown solver '" + name + "'"
                    + DidYouMean.hint(name, names(), "'%s'"::formatted)
                    + " known: " + String.join(", ", names()) + (name.matches("[A-Z]\\w*")
                    ? "; a class of your own is called exercises." + name : ""));
        }
        return entry.info();
    }

    /**
     * Creates a solver.
     *
     * @param name a catalogue name, or the fully-qualified name of a class of one's own with a public no-arg
     *             constructor
     * @return a new solver
     * @throws NoSuchElementException   if there is neither a solver nor a class of this name
     * @throws IllegalArgumentException if the class is not a {@link DESolver} or cannot be created
     */
    public static DESolver create(String name) {
        Entry entry = ENTRIES.get(name);
        if (entry != null) {
            return entry.maker().get();
        }
        return name.indexOf('.') > 0 ? ofClass(name) : throwUnknown(name);
    }

    /**
     * Creates an adaptive solver.
     *
     * @param name              a catalogue name, or the fully-qualified name of a class of one's own with a public
     *                          constructor of two doubles
     * @param relativeTolerance error allowed for an entry of the state in one sub-step, relative to its size
     * @param absoluteTolerance error allowed besides, in the entry's unit
     * @return a new solver
     * @throws NoSuchElementException   if there is neither a solver nor a class of this name
     * @throws IllegalArgumentException if the solver is not adaptive, the class is no {@link DESolver} or cannot be
     *                                  made, or a tolerance is negative or not finite, or both are 0
     */
    public static DESolver create(String name, double relativeTolerance, double absoluteTolerance) {
        Entry entry = ENTRIES.get(name);
        if (entry != null) {
            return entry.toleranceMaker().create(relativeTolerance, absoluteTolerance);
        }
        return name.indexOf('.') > 0 ? ofClass(name, relativeTolerance, absoluteTolerance) : throwUnknown(name);
    }

    private static DESolver throwUnknown(String name) {
        info(name);
        throw new AssertionError("a known name was not in the list: " + name);
    }

    private static DESolver ofClass(String name, Double... tolerances) {
        try {
            Class<?> found = Class.forName(name, true, Thread.currentThread().getContextClassLoader());
            if (!DESolver.class.isAssignableFrom(found)) {
                throw new IllegalArgumentException("class " + name + " is not a solver: it has to extend "
                        + DESolver.class.getName());
            }
            Class<?>[] types = new Class<?>[tolerances.length];
            Arrays.fill(types, double.class);
            return found.asSubclass(DESolver.class).getConstructor(types).newInstance((Object[]) tolerances);
        } catch (ClassNotFoundException e) {
            throw new NoSuchElementException("no class or solver is called '" + name + "'"
                    + DidYouMean.hint(name.replaceFirst(".*[.]", ""), names(), "'%s'"::formatted) + " known solvers: "
                    + String.join(", ", names()), e);
        } catch (LinkageError e) {                      // a static initialiser failed; no cause the second time
            throw new IllegalArgumentException("class " + name + " cannot be loaded: "
                    + (e.getCause() == null ? e : e.getCause()), e);
        } catch (NoSuchMethodException | InstantiationException | IllegalAccessException e) {
            throw new IllegalArgumentException("class " + name
                    + " cannot be created: it has to be public, not abstract, and"
                    + " have a public constructor " + (tolerances.length == 0 ? "without parameters"
                    : "of two doubles"), e);
        } catch (InvocationTargetException e) {
            throw new IllegalArgumentException("the constructor of " + name + " failed: " + e.getCause(), e);
        }
    }
}
