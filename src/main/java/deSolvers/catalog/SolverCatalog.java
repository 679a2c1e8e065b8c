package deSolvers.catalog;

import deSolvers.DESolver;
import deSolvers.EulerSolver;
import deSolvers.MidpointSolver;
import deSolvers.RK4Solver;
import deSolvers.adaptive.DormandPrinceSolver;
import deSolvers.adaptive.StepDoublingSolver;
import deSolvers.catalog.SolverInfo.ChartLook;
import deSolvers.catalog.SolverInfo.Family;
import deSolvers.catalog.SolverInfo.Limits;
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
    private static final Map<String, Entry> ENTRIES = byName(
            fixed("euler", 1, Family.SLIDES, "1", new Limits(0, 2), new ChartLook(0xd55e00, 0),
                    "One straight step; every undamped spring gains energy.", EulerSolver::new),
            fixed("midpoint", 2, Family.SLIDES, "2", new Limits(0, 2), new ChartLook(0xe69f00, 1),
                    "Uses the derivative half way; undamped springs gain energy slowly.", MidpointSolver::new),
            fixed("rk4", 4, Family.SLIDES, "4", new Limits(2.8284, 2.7853), new ChartLook(0x6b2500, 4),
                    "The old workhorse: accurate and stable enough for most scenes.", RK4Solver::new),
            adaptive("step-doubling", 4, Family.ADAPTIVE, "11 per sub-step", new Limits(5.6569, 5.5706),
                    new ChartLook(0x56b4e9, 1), "Compares two RK4 steps with one of twice the length.",
                    StepDoublingSolver::new, StepDoublingSolver::new),
            adaptive("dormand-prince", 5, Family.ADAPTIVE, "6 per sub-step", new Limits(0.9972, 3.3066),
                    new ChartLook(0x0072b2, 0), "First choice for smooth motion to a stated accuracy.",
                    DormandPrinceSolver::new, DormandPrinceSolver::new),
            adaptive("bulirsch-stoer", 18, Family.EXTRAPOLATION, "9 to 163 per sub-step", Limits.UNSTATED,
                    new ChartLook(0x0b2f5c, 2), "Extrapolates midpoint steps: smooth motion, high accuracy.",
                    BulirschStoerSolver::new, BulirschStoerSolver::new),
            fixed("adams", 4, Family.MULTISTEP, "2", new Limits(0, 1.2848), new ChartLook(0x000000, 3),
                    "Reuses earlier derivatives: order 4 for two evaluations.", AdamsBashforthMoultonSolver::new),
            fixed("symplectic-euler", 1, Family.SYMPLECTIC, "1", new Limits(2, 0.8284), new ChartLook(0x5fcfa4, 1),
                    "The slides' simple algorithm; without rods no energy drift in small steps.",
                    SymplecticEulerSolver::new),
            fixed("verlet", 2, Family.SYMPLECTIC, "1, more with damping", new Limits(2, 0.74),
                    new ChartLook(0x009e73, 0),
                    "First choice for undamped motion; without rods no energy drift.", VelocityVerletSolver::new),
            fixed("yoshida4", 4, Family.SYMPLECTIC, "3, more with damping", new Limits(1.5734, 0.438),
                    new ChartLook(0x00513b, 2), "Three verlet steps in one, with order 4.", Yoshida4Solver::new),
            fixed("backward-euler", 1, Family.IMPLICIT, "2 to 8; meshes to 120", Limits.NONE,
                    new ChartLook(0xcc79a7, 1), "Damps vibrations that a step cannot resolve.",
                    BackwardEulerSolver::new),
            fixed("linearised-euler", 1, Family.IMPLICIT, "1", Limits.NONE, new ChartLook(0xe0a8ca, 2),
                    "Backward Euler with one linear system per step; for cloth.", LinearisedEulerSolver::new),
            fixed("implicit-midpoint", 2, Family.IMPLICIT, "2 to 8; meshes to 120", Limits.NONE,
                    new ChartLook(0x9b3f86, 0), "Keeps the energy of linear springs.", ImplicitMidpointSolver::new),
            adaptive("radau", 5, Family.IMPLICIT, "about 10 per sub-step", Limits.NONE, new ChartLook(0x4b1250, 3),
                    "First choice for stiff systems to a stated accuracy.", RadauIIASolver::new,
                    RadauIIASolver::new));

    private record Entry(SolverInfo info, Supplier<DESolver> maker, WithTolerances toleranceMaker) {
    }

    /** A solver that steps by deltaT. */
    private static Entry fixed(String name, int order, Family family, String evaluations, Limits limits,
            ChartLook look, String sentence, Supplier<DESolver> maker) {
        return new Entry(new SolverInfo(name, order, family, evaluations, false, limits, look, sentence), maker,
                (relative, absolute) -> throwNotAdaptive(name));
    }

    private static Entry adaptive(String name, int order, Family family, String evaluations, Limits limits,
            ChartLook look, String sentence, Supplier<DESolver> maker, WithTolerances toleranceMaker) {
        return new Entry(new SolverInfo(name, order, family, evaluations, true, limits, look, sentence), maker,
                toleranceMaker);
    }

    /** Makes an adaptive solver. */
    private interface WithTolerances {
        DESolver create(double relativeTolerance, double absoluteTolerance);
    }

    private SolverCatalog() {
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
        return ENTRIES.values().stream().map(Entry::info).toList();
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
        return entry(name).info();
    }

    /**
     * Creates a solver.
     *
     * @param name a catalogue name, or the fully-qualified name of a class of one's own with a public constructor of no
     *             parameters
     * @return a new solver
     * @throws NoSuchElementException   if there is neither a solver nor a class of this name
     * @throws IllegalArgumentException if the class is not a {@link DESolver} or cannot be created
     */
    public static DESolver create(String name) {
        return isClass(name) ? ofClass(name) : entry(name).maker().get();
    }

    /**
     * Creates an adaptive solver.
     *
     * @param name              as {@link #create(String)}; a class has a public constructor of two doubles
     * @param relativeTolerance the error allowed for an entry of the state in one sub-step, relative to its size
     * @param absoluteTolerance the error allowed besides, in the entry's unit
     * @return a new solver
     * @throws NoSuchElementException   if there is neither a solver nor a class of this name
     * @throws IllegalArgumentException if the solver is not adaptive, the class is not a {@link DESolver} or cannot be
     *                                  created, a tolerance is negative or not finite, or both are 0
     */
    public static DESolver create(String name, double relativeTolerance, double absoluteTolerance) {
        return isClass(name) ? ofClass(name, relativeTolerance, absoluteTolerance)
                : entry(name).toleranceMaker().create(relativeTolerance, absoluteTolerance);
    }

    private static boolean isClass(String name) {
        return !ENTRIES.containsKey(name) && name.indexOf('.') > 0;
    }

    private static Entry entry(String name) {
        Entry entry = ENTRIES.get(name);
        if (entry == null) {
            throw new NoSuchElementException("unknown solver '" + name + "'"
                    + DidYouMean.hint(name, names(), "'%s'"::formatted)
                    + " known: " + String.join(", ", names()) + (name.matches("[A-Z]\\w*")
                    ? "; a class of your own is called exercises." + name : ""));
        }
        return entry;
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
