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
    /** Name, order, family, evaluations per step, limits for undamped and for critically damped springs, sentence. */
    private static final Map<String, Entry> ENTRIES = byName(
            new Entry("euler | 1 | slides | 1 | 0 | 2 | One straight step; every undamped spring gains energy.",
                    EulerSolver::new),
            new Entry("midpoint | 2 | slides | 2 | 0 | 2 "
                    + "| Uses the derivative half way; undamped springs gain energy slowly.", MidpointSolver::new),
            new Entry("rk4 | 4 | slides | 4 | 2.8284 | 2.7853 "
                    + "| The old workhorse: accurate and stable enough for most scenes.", RK4Solver::new),
            new Entry("step-doubling | 4 | adaptive | 11 per sub-step | 5.6569 | 5.5706 "
                    + "| Compares two RK4 steps with one of twice the length.",
                    StepDoublingSolver::new, StepDoublingSolver::new),
            new Entry("dormand-prince | 5 | adaptive | 6 per sub-step | 0.9972 | 3.3066 "
                    + "| First choice for smooth motion to a stated accuracy.",
                    DormandPrinceSolver::new, DormandPrinceSolver::new),
            new Entry("bulirsch-stoer | 18 | extrapolation | 9 to 163 per sub-step | none | none "
                    + "| Extrapolates midpoint steps: smooth motion, high accuracy.",
                    BulirschStoerSolver::new, BulirschStoerSolver::new),
            new Entry("adams | 4 | multistep | 2 | 0 | 1.2848 "
                    + "| Reuses earlier derivatives: order 4 for two evaluations.", AdamsBashforthMoultonSolver::new),
            new Entry("symplectic-euler | 1 | symplectic | 1 | 2 | 0.8284 "
                    + "| The slides' simple algorithm; no energy drift in small steps.", SymplecticEulerSolver::new),
            new Entry("verlet | 2 | symplectic | 1, more with damping | 2 | 0.74 "
                    + "| First choice for undamped motion; no energy drift in small steps.",
                    VelocityVerletSolver::new),
            new Entry("yoshida4 | 4 | symplectic | 3, more with damping | 1.5734 | 0.438 "
                    + "| Three verlet steps in one, with order 4.", Yoshida4Solver::new),
            new Entry("backward-euler | 1 | implicit | 2 to 8, tens with rods | unlimited | unlimited "
                    + "| Damps vibrations that a step cannot resolve.", BackwardEulerSolver::new),
            new Entry("linearised-euler | 1 | implicit | 1 | unlimited | unlimited "
                    + "| Backward Euler with one linear system per step; for cloth.", LinearisedEulerSolver::new),
            new Entry("implicit-midpoint | 2 | implicit | 2 to 8, tens with rods | unlimited | unlimited "
                    + "| Keeps the energy of linear springs.", ImplicitMidpointSolver::new),
            new Entry("radau | 5 | implicit | about 10 per sub-step | unlimited | unlimited "
                    + "| First choice for stiff systems to a stated accuracy.", RadauIIASolver::new,
                    RadauIIASolver::new));

    private record Entry(SolverInfo info, Supplier<DESolver> maker, WithTolerances toleranceMaker) {
        /** A solver that steps by deltaT. */
        Entry(String row, Supplier<DESolver> maker) {
            this(SolverInfo.of(row, false), maker, (relative, absolute) -> throwNotAdaptive(row.split(" ")[0]));
        }

        /** An adaptive solver. */
        Entry(String row, Supplier<DESolver> maker, WithTolerances toleranceMaker) {
            this(SolverInfo.of(row, true), maker, toleranceMaker);
        }
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
