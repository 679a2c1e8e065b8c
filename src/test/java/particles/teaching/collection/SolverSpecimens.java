package particles.teaching.collection;

import java.util.List;
import java.util.stream.Stream;

/** Right and wrong solvers that a table makes; those of strangers had not seen the check. */
final class SolverSpecimens {
    private static final List<String> METHODS = List.of("rk 1/2 -> 0 1", "rk HEUN", "rk 2/3 -> 1/4 3/4",
            "rk 1/2; -1 2 -> 1/6 2/3 1/6", "rk RK4 SIXTHS", "rk THREE_EIGHTHS EIGHTHS");

    private SolverSpecimens() {
    }

    /** Mistakes of which the beginning of the sentence is held, word by word. */
    static List<Specimen> sentences() {
        return SolverTable.read("""
                Mine | weight of k3 | = method: the new state is s + k1/6 + k2/3 + k3/6 + k4/6; the slide says \
                s + k1/6 + k2/3 + k3/3 + k4/6: the weight of k3 is 1/6 instead of 1/3 | rk RK4 1/6 1/3 1/6 1/6
                Mine | k1 whole | = method: k2 is evaluated at s + k1; the slide says s + k1/2: the half is missing \
                | rk 1; 0 1/2; 0 0 1 -> SIXTHS @ 0 1/2 1/2 1
                Mine | deltaS whole | = method: gMid is evaluated at s + deltaS; the slide says s + deltaS/2: \
                the half is missing | rk 1 -> 0 1 @ 0 1/2
                EulerSolver | new velocity | = name: the position is updated with the new velocity; the slide's Euler \
                method takes the old | turns 0 1 -> 1
                SymplecticEulerSolver | old velocity | = name: the position is updated with the old velocity, which is \
                the Euler method; the slides' simple algorithm takes the new | nystrom -> 0 -> 1 @ 0
                Mine | sign | = method: the new state is s - deltaS; the slide says s + deltaS: the sign is wrong \
                | rk -> -1
                RK4Solver | k4 forgotten | = method: k4 is missing: the calls of getStateDerivative are 3, the slide \
                needs 4 | rk 1/2; 0 1/2 -> 1/6 1/3 1/3
                RK4Solver | whole numbers | = method: the new state is s; the slide says s + k1/6 + k2/3 + k3/3 \
                + k4/6: no derivative is in it: it was left out, or 1/6 is 0 in Java | rk RK4 0 0 0 0
                MidpointSolver | from the middle | = method: the new state is s + deltaS/2 + deltaT gMid; the slide \
                says s + deltaT gMid: go back to the start s before adding | rk 1/2 -> 1/2 1
                HeunSolver | no half | = method: the new state is s + k1 + k2; Heun's method says s + k1/2 + k2/2: the \
                half is missing | rk 1 -> 1 1
                HeunSolver | is midpoint | = name: this is the midpoint method and not Heun's method, as its name says \
                | rk 1/2 -> 0 1
                VerletSolver | old acceleration | = method: a2 is missing: the calls of getStateDerivative are 1, the \
                method needs 2: the acceleration at the new position is missing | nystrom -> 1/2 -> 1 @ 0
                Mine | left at a stage | = state: the state is left at a trial state, s + k1/2, that of the last \
                evaluation: setState with the new state is missing | rk 1/2 -> 0 1 | end-not-set
                Mine | never set | = state: the new state never reaches the source: setState(state) is missing \
                | rk -> 1 | trials-not-set, end-not-set
                MidpointSolver | trial not set | = method: gMid is evaluated at s; the slide says s + deltaS/2: \
                setState is missing before this getStateDerivative | rk 1/2 -> 0 1 | trials-not-set
                Mine | float | = state: digits get lost | rk -> 1 | float
                RK4Solver | not from the start | = method: k3 is evaluated at s + k1/2 + k2/2; the slide says \
                s + k2/2: go back to the start s before adding | rk 1/2; 1/2 1/2; 0 0 1 -> SIXTHS @ 0 1/2 1/2 1
                RK4Solver | one array | = method: the new state is s + k4; the slide says s + k1/6 + k2/3 + k3/3 \
                + k4/6: only the last derivative is in it, as if all of them were one array | rk RK4 0 0 0 1
                Mine | old state lost | = state: the new state is k1, with 0 times s in it instead of once: the old \
                state is lost | rk -> 1 | old-state-lost
                Mine | to n - 1 | = state: these entries stay as they were in the new state: 23; the loop has to \
                | rk -> 1 | left-at-end 0 -1
                Mine | to 3 | = state: these entries stay as they were in the new state: 3, 4, 5, 6, 7, 8...; the loop \
                has to | rk -> 1 | left-at-end 0 3
                EulerSolver | positions only | entr/or/loop/or/stay | nystrom -> 0 -> 0 @ 0
                Mine | k4 too early | = time: k4 is evaluated at t + deltaT/2; the slide says t + deltaT \
                | rk RK4 SIXTHS @ 0 1/2 1/2 1/2
                Mine | clock at the end | = time: k2 is evaluated at t; the slide says t + deltaT/2: the clock has to \
                be moved with | rk RK4 SIXTHS @ 0 0 0 0
                Mine | no incTime | = time: the clock never moves: incTime(deltaT) is missing | rk -> 1 | clock-still
                Mine | no incTime | = time: the clock never moves: incTime(deltaT) is missing | rk 1/2 -> 0 1 \
                | clock-still
                Mine | incTime twice | = time: the clock ends at t + 2 deltaT after a step | rk -> 1 | then-clock 1
                Mine | the half stays on | = time: the clock ends at t + 3/2 deltaT after a step of deltaT = 1/32 s \
                and has to end at t + deltaT | rk 1/2 -> 0 1 | then-clock 0.5
                RK4Solver | deltaT at every stage | = time: the clock ends at t + 4 deltaT after a step of \
                deltaT = 1/32 s and has to end at t + deltaT | rk RK4 SIXTHS @ 0 1 2 3 | then-clock 3
                Mine | 1/8 s | = time: the clock moves by 1/8 s in every step, whatever deltaT is: it is hard-coded \
                | rk -> 1 | clock-still, then-seconds 0.125
                Mine | new time | = time: the clock moves by 65/32 s in a step of 1/32 s that begins at 2 s: incTime \
                takes how far the clock moves | rk -> 1 | clock-still, then-new-time
                Mine | twice | = method: the parts of the step lead to t + 2 deltaT, and have to lead to t + deltaT: \
                is the step | rk -> 1 | repeated 2
                MidpointSolver | 1/2 of whole numbers | = method: gMid is evaluated at s; the slide says s + deltaS/2: \
                no derivative is in it: it was not added to the state that is set, or 1/2 is 0 in Java \
                | rk 0 -> 0 1 @ 0 1/2
                """);
    }

    /** Each of the methods, without a name that says which it is, with each of the changes. */
    private static Stream<Specimen> crossed(String changes) {
        return changes.lines().map(change -> change.split(" [|]", -1)).flatMap(parts -> METHODS.stream().map(method ->
                String.join("|", "Mine", method + ", " + parts[0], parts[1], method, parts[0])))
                .flatMap(row -> SolverTable.read(row).stream());
    }

    static List<Specimen> allRight() {
        return Stream.concat(crossed("""
                parts 2 |
                refuses-below 0 |
                refuses-NaN |
                """), SolverTable.read("""
                StrangSolver | refuses steps back | | LEAPFROG | refuses-below 0
                RichardsonStrang | not symmetric | | nystrom 1/2; 1/8; 1/4 0 1/4 -> 1/6 0 1/3 \
                -> 1/6 -1/6 2/3 1/3 @ 0 1 1/2 1
                EulerSolver | Euler | | rk -> 1
                MidpointSolver | midpoint | | rk 1/2 -> 0 1
                RK2Solver | midpoint as RK2 | | rk 1/2 -> 0 1
                RungeKutta2Solver | Heun as order 2 | | rk HEUN
                HeunSolver | Heun | | rk HEUN
                ModifiedEulerSolver | Heun by another name | | rk HEUN
                ImprovedEuler | midpoint by another name | | rk 1/2 -> 0 1
                ExplicitTrapezoid | Heun by a third name | | rk HEUN
                RalstonSolver | Ralston | | rk 2/3 -> 1/4 3/4
                RalstonRK4 | as printed | | rk 2/5; .29697761 .15875964; .21810040 -3.05096516 3.83286476 \
                -> .17476028 -.55148066 1.20553560 .17118478
                RungeKutta3Solver | Heun's method of order 3 | | rk 1/3; 0 2/3 -> 1/4 0 3/4
                RK3Solver | Ralston of order 3 | | rk 1/2; 0 3/4 -> 2/9 1/3 4/9
                MySolver | Kutta of order 3 | | rk 1/2; -1 2 -> 1/6 2/3 1/6
                SSPRK3Solver | Shu and Osher | | rk 1; 1/4 1/4 -> 1/6 1/6 2/3
                SSPRK2 | Shu and Osher, two stages | | rk HEUN
                SSPRK43Solver | order 3 in four stages | | rk 1/2; 1/2 1/2; 1/6 1/6 1/6 -> 1/6 1/6 1/6 1/2
                RungeKuttaOrder3Solver | Kutta | | rk 1/2; -1 2 -> 1/6 2/3 1/6
                RK4Solver | RK4 | | rk RK4 SIXTHS
                RungeKutta38Solver | the 3/8 rule | | rk THREE_EIGHTHS EIGHTHS
                RungeKutta4 | the 3/8 rule as order 4 | | rk THREE_EIGHTHS EIGHTHS
                GillSolver | Gill | | rk 1/2; 0.20710678118654757 0.2928932188134524; 0 -0.7071067811865476 \
                1.7071067811865475 -> 1/6 0.09763107293781749 0.5690355937288492 1/6
                RungeKuttaFehlbergSolver | order 5 | | rk FEHLBERG FEHLBERG5
                RungeKuttaSix | Butcher | | rk 1/3; 0 2/3; 1/12 1/3 -1/12; 25/48 -55/24 35/48 15/8; \
                3/20 -11/24 -1/8 1/2 1/10; -261/260 33/13 43/156 -118/39 32/195 80/39 \
                -> 13/200 0 11/40 11/40 4/25 4/25 13/200
                RKF45Solver | order 4 | | rk FEHLBERG FEHLBERG4
                DormandPrinceSolver | fixed steps | | rk DOPRI DOPRI5
                CashKarpSolver | fixed steps | | rk CASH_KARP CASH_KARP5
                BogackiShampine | fixed steps | | rk 1/2; 0 3/4; 2/9 1/3 4/9 -> 2/9 1/3 4/9 0
                SmallEuler | ten Euler steps | | rk -> 1 | parts 10
                RichardsonEuler | extrapolated Euler | | rk 1/2 -> 0 1
                GraggSolver | extrapolated midpoint | | rk 1/2; 0 1; 0 0 0; 0 0 0 1/4 \
                ; 0 0 0 0 1/2; 0 0 0 1/4 0 1/2; 0 0 0 0 1/2 0 1/2 \
                -> -1/12 -1/6 -1/12 1/6 1/3 1/3 1/3 1/6 @ 0 1/2 1 0 1/4 1/2 3/4 1
                DopriAdaptive | 1e-6 | | pair DOPRI DOPRI5 -> DOPRI4 : 1e-6 5
                DormandPrince45 | 1e-3 | | pair DOPRI DOPRI5 -> DOPRI4 : 1e-3 5
                AdaptiveFehlberg | 1e-8 | | pair FEHLBERG FEHLBERG4 -> FEHLBERG5 : 1e-8 5
                CashKarp | 1e-5 | | pair CASH_KARP CASH_KARP5 -> CASH_KARP4 : 1e-5 5
                HeunEuler | pair of orders 2 and 1 | | pair HEUN -> 1 0 : 1e-4 2
                SymplecticEulerSolver | kick, drift | | turns 0 1 -> 1
                SemiImplicitEuler | drift, kick | | turns 1 0 -> 1
                EulerCromer | from the derivative's halves | | nystrom -> 1 -> 1 @ 0
                VelocityVerletSolver | kick, drift, kick | | LEAPFROG
                LeapfrogSolver | drift, kick, drift | | DKD
                VerletSolver | x first, then both accelerations | | nystrom 1/2 -> 1/2 0 -> 1/2 1/2 @ 0 1
                StoermerVerlet | drift, kick, drift | | DKD
                Yoshida4Solver | three leapfrogs | | THREE_LEAPFROGS
                Yoshida | four drifts | | YOSHIDA
                ForestRuth | three leapfrogs | | THREE_LEAPFROGS
                Ruth3Solver | Ruth of order 3 | | turns 1 -2/3 2/3 -> -1/24 3/4 7/24
                Pefrl | Omelyan, order 4 | | turns 0.1786178958448091 -0.06626458266981849 0.7752933736500188 \
                -0.06626458266981849 0.1786178958448091 -> 0.7123418310626054 -0.2123418310626054 \
                -0.2123418310626054 0.7123418310626054
                NystromSolver | Nystrom of order 4 | | nystrom 1/8; 0 1/2 -> 1/6 1/3 0 -> 1/6 2/3 1/6 @ 0 1/2 1
                BackwardEulerSolver | Newton | | BACKWARD NEWTON
                ImplicitEuler | simple iteration | | BACKWARD SIMPLE
                ImplicitMidpointSolver | Newton | | IMPLICIT_MIDPOINT NEWTON
                TrapezoidalRule | Newton | | TRAPEZOID : newton 1e-9 50
                CrankNicolson | simple iteration | | TRAPEZOID SIMPLE
                ThetaMethod | 0.6 at the end | | irk ; 0.4 0.6 -> 0.4 0.6 NEWTON
                RadauSolver | Radau IIA of order 3 | | irk 5/12 -1/12; 3/4 1/4 -> 3/4 1/4 NEWTON
                SDIRK2 | two stages | | irk 0.2928932188134524; 0.7071067811865476 0.2928932188134524 \
                -> 0.7071067811865476 0.2928932188134524 : newton 1e-11 50
                GaussLegendre4 | two stages | | irk 1/4 -0.03867513459481287; 0.5386751345948129 1/4 -> 1/2 1/2 \
                : newton 1e-11 60
                TrBdf2Solver | a BDF method in one step | | irk ; 0.2928932188134524 0.2928932188134524; \
                0.3535533905932738 0.3535533905932738 0.2928932188134524 \
                -> 0.3535533905932738 0.3535533905932738 0.2928932188134524 : newton 1e-11 60
                AdamsBashforth2 | Euler at first | | adams 2 1
                AB3Solver | RK4 at first | | adams 3 4
                AB2Solver | weights for any deltaT | | adams 2 4 : any-deltaT adapts
                DormandPrince5 | the last stage is the new state | | rk DOPRI DOPRI5 | end-not-set
                AdamsBashforth4Solver | RK4 at first | | adams 4 4
                PredictorCorrector | Adams-Moulton, RK4 at first | | adams 4 4 : corrects
                BDF2 | backward Euler at first | | bdf 2/3
                CarefulRK4 | refuses negative steps | | rk RK4 SIXTHS | refuses-below 0
                OwnException | refuses NaN | | rk -> 1 | refuses-NaN
                LowStorage | Williamson of order 3 | | rk 1/3; -3/16 15/16 -> 1/6 3/10 8/15
                EulerMethod | as on the slide | | rk -> 1
                MidPoint | arrays in fields | | rk 1/2 -> 0 1
                Ralston | with helpers | | rk 2/3 -> 1/4 3/4
                MySolver | 3/8 rule | | rk THREE_EIGHTHS EIGHTHS
                Solver2 | Butcher's order 5 | | rk 1/4; 1/8 1/8; 0 -1/2 1; 3/16 0 0 9/16; -3/7 2/7 12/7 -12/7 8/7 \
                -> 7/90 0 32/90 12/90 32/90 7/90
                DormandPrinceAdaptive | 1e-9 | | pair DOPRI DOPRI5 -> DOPRI4 : 1e-9 5
                BogackiShampineSolver | fixed steps | | rk 1/2; 0 3/4 -> 2/9 1/3 4/9
                BestSolver | drift, kick, drift | | DKD
                EulerBackward | words in another order | | BACKWARD NEWTON
                NewtonEuler | Euler, solved for | | BACKWARD NEWTON
                IteratedHeun | corrected twice | | rk 1; 1/2 1/2 -> 1/2 0 1/2
                PECECESolver | corrected twice | | rk 1; 1/2 1/2 -> 1/2 0 1/2
                SecondOrderRungeKutta | midpoint | | rk 1/2 -> 0 1
                RichardsonMidpoint | whole and half steps | | rk 1/2; 1/4; 0 0 1/2; 0 0 1/2 1/4 -> 0 -1/3 2/3 0 2/3 \
                @ 0 1/2 1/4 1/2 3/4
                Ruth3 | kick first | | turns 0 2/3 -2/3 1 -> 7/24 3/4 -1/24
                BackwardEulerNewton | full Newton | | BACKWARD : newton 1e-12 50
                ImplicitMidpoint | simple iteration | | IMPLICIT_MIDPOINT : simple 1e-13 500
                MersonSolver | Merson | | rk 1/3; 1/6 1/6; 1/8 0 3/8; 1/2 0 -3/2 2 -> 1/6 0 0 2/3 1/6
                TextTableSolver | Nystrom of order 3 | | rk 2/3; 0 2/3 -> 1/4 3/8 3/8
                GenericRK2Solver | alpha is 3/5 | | rk 3/5 -> 1/6 5/6
                McLachlanSolver | two stages | | turns 0.1931833275037836 0.6136333449924328 0.1931833275037836 \
                -> 1/2 1/2
                BlanesMoanSolver | six stages, order 4 | | turns 0.0792036964311957 0.353172906049774 \
                -0.0420650803577195 0.2193769557534996 -0.0420650803577195 0.353172906049774 0.0792036964311957 \
                -> 0.209515106613362 -0.143851773179818 0.434336666566456 0.434336666566456 -0.143851773179818 \
                0.209515106613362
                R01HeunSolver | Heun, numbered | | rk HEUN
                A3HeunSolver | Heun, numbered | | rk HEUN
                R03KuttaThirdOrderSolver | Kutta | | rk 1/2; -1 2 -> 1/6 2/3 1/6
                R05ClassicRK4 | RK4 | | rk RK4 SIXTHS
                R07ThreeEighthsSolver | 3/8 | | rk THREE_EIGHTHS EIGHTHS
                R09EulerVerfahren | Euler | | rk -> 1
                R12FehlbergFixedStep | order 5 | | rk FEHLBERG FEHLBERG5
                R15AdamsBashforth4 | RK4 start | | adams 4 4
                R17LeapfrogKDK | leapfrog | | LEAPFROG
                R18LeapfrogDKD | leapfrog | | DKD
                R21YoshidaSolver | four drifts | | YOSHIDA
                R24Trapezoid | Newton | | TRAPEZOID NEWTON
                R26BDF2 | begun by backward Euler | | bdf 2/3
                R27AdaptiveHeunEuler | 1e-6 | | pair HEUN -> 1 0 : 1e-6 2
                R28BogackiShampine | adaptive | | pair BOGACKI : 1e-8 3
                AdaptifPasVariable | Fehlberg | | pair FEHLBERG FEHLBERG4 -> FEHLBERG5 : 1e-7 5
                R47SubstepRK4 | ten sub-steps | | rk RK4 SIXTHS | parts 10
                R48SubstepEuler | two sub-steps | | rk 1/2 -> 1/2 1/2
                R60ClassicRK4 | refuses negative steps | | rk RK4 SIXTHS | refuses-below 0
                R61LeapfrogKDK | refuses negative steps | | LEAPFROG | refuses-below 0
                R64Trapezoid | refuses negative steps | | TRAPEZOID NEWTON | refuses-below 0
                R40ClassicRK4 | refuses 0 as well | | rk RK4 SIXTHS | refuses-below 4.9e-324
                R41LeapfrogKDK | refuses 0 as well | | LEAPFROG | refuses-below 4.9e-324
                R42EulerVerfahren | refuses 0 as well | | rk -> 1 | refuses-below 4.9e-324
                """).stream()).toList();
    }

    static List<Specimen> allWrong() {
        return Stream.concat(crossed("""
                clock-still | never moves/or/at t[ ;,]
                then-clock 1 | 2 deltaT
                trials-not-set | setState is missing
                end-not-set | setState with the new state is missing
                old-state-lost | old state is lost
                float | float
                left-at-end 0 -1 | new state: 23;
                left-in-trials 6 0 | trial state at evaluation 2: 0, 1, 2,
                repeated 2 | 2 deltaT
                sign-lost | sign of deltaT
                swallows | do not catch
                """), SolverTable.read("""
                EulerSolver | half the step | half/or/1/2/or/k1/2/or/deltaS/2 | rk -> 1/2
                EulerSolver | sign | sign | rk -> -1
                MidpointSolver | half missing | half is missing | rk 1 -> 0 1 @ 0 1/2
                MidpointSolver | clock at t | gMid is evaluated at t; | rk 1/2 -> 0 1 @ 0 0
                MidpointSolver | clock at t + deltaT | gMid is evaluated at t \\+ deltaT | rk 1/2 -> 0 1 @ 0 1
                Middle | 1/2 of whole numbers | 1/2 is 0 | rk 0 -> 0 1 @ 0 1/2
                HeunSolver | half missing | half is missing/or/add up to | rk 1 -> 1 1
                HeunSolver | midpoint instead | midpoint | rk 1/2 -> 0 1
                HeunSolver | weights swapped for Ralston's | weight | rk 1 -> 1/4 3/4
                RalstonSolver | weights the other way round | weight/or/other way round | rk 2/3 -> 3/4 1/4
                RK3Solver | k3 without -k1 | k3 is evaluated at | rk 1/2; 0 2 -> 1/6 2/3 1/6 @ 0 1/2 1
                RungeKutta3Solver | weights add up to 7/6 | weight/or/add up | rk 1/2; -1 2 -> 1/6 2/3 1/3
                SSPRK3Solver | last weight | weight/or/add up | rk 1; 1/4 1/4 -> 1/6 1/6 1/3
                RK4Solver | weight of k3 | weight of k3 | rk RK4 1/6 1/3 1/6 1/6
                RK4Solver | weights in disorder | weight | rk RK4 1/3 1/6 1/6 1/3
                RK4Solver | all weights 1/4 | weight | rk RK4 1/4 1/4 1/4 1/4
                RK4Solver | not divided by 6 | 6 times | rk RK4 1 2 2 1
                RK4Solver | whole numbers divided | 1/6 is 0 | rk RK4 0 0 0 0
                RK4Mine | weights of k3 and k4 swapped | weight of k3 | rk RK4 1/6 1/3 1/6 1/3
                Rk | k4 at s + k3/2 | k4 is evaluated at | rk 1/2; 0 1/2; 0 0 1/2 -> SIXTHS @ 0 1/2 1/2 1
                RK4Solver | k3 from k1 | k3 is evaluated at s \\+ k1/2 | rk 1/2; 1/2 0; 0 0 1 -> SIXTHS
                RK4Solver | k3 without the half | k3 is evaluated at s \\+ k2[;:].*half is missing \
                | rk 1/2; 0 1; 0 0 1 -> SIXTHS @ 0 1/2 1/2 1
                RK4Solver | clock at t | evaluated at t[ ;,:].*clock | rk RK4 SIXTHS @ 0 0 0 0
                RungeKutta | k2 at t | k2 is evaluated at t; | rk RK4 SIXTHS @ 0 0 1/2 1
                RungeKuttaSolver | clock moved at once | t \\+ deltaT | rk RK4 SIXTHS @ 0 1 1 1
                RungeKutta4th | k4 at t + deltaT/2 | k4 is evaluated at t \\+ deltaT/2 | rk RK4 SIXTHS @ 0 1/2 1/2 1/2
                Rk4Mine | trial state never taken back | go back to the start/or/one array \
                | rk 1/2; 1/2 1/2; 1/2 1/2 1 -> 2/3 5/6 4/3 1/6 @ 0 1/2 1/2 1
                RungeKutta38Solver | weights of RK4 | weight | rk THREE_EIGHTHS SIXTHS
                RK38 | sign of a coefficient | k3 is evaluated at | rk 1/3; 1/3 1; 1 -1 1 -> EIGHTHS @ 0 1/3 2/3 1
                DormandPrinceSolver | coefficient of row 4 | k4 is evaluated/or/order | rk 1/5; 3/40 9/40; \
                44/45 -55/15 32/9; 19372/6561 -25360/2187 64448/6561 -212/729; \
                9017/3168 -355/33 46732/5247 49/176 -5103/18656; 35/384 0 500/1113 125/192 -2187/6784 11/84 -> DOPRI5 \
                @ 0 1/5 3/10 4/5 8/9 1 1
                DoPri5 | two digits swapped | k5 is evaluated at | rk 1/5; 3/40 9/40; \
                44/45 -56/15 32/9; 19327/6561 -25360/2187 64448/6561 -212/729; \
                9017/3168 -355/33 46732/5247 49/176 -5103/18656; 35/384 0 500/1113 125/192 -2187/6784 11/84 -> DOPRI5 \
                @ 0 1/5 3/10 4/5 8/9 1 1
                DormandPrinceSolver | weight | weight | rk DOPRI 35/384 0 500/1113 125/129 -2187/6784 11/84 0
                DormandPrince | adaptive, wrong row | k3 is evaluated/or/order \
                | pair 1/5; 3/40 9/20; 44/45 -56/15 32/9; \
                19372/6561 -25360/2187 64448/6561 -212/729; 9017/3168 -355/33 46732/5247 49/176 -5103/18656; \
                35/384 0 500/1113 125/192 -2187/6784 11/84 -> DOPRI5 -> DOPRI4 : 1e-6 5
                FehlbergSolver | sign in row 5 | k5 is evaluated/or/order | rk 1/4; 3/32 9/32; \
                1932/2197 -7200/2197 7296/2197; 439/216 8 3680/513 -845/4104; \
                -8/27 2 -3544/2565 1859/4104 -11/40 -> FEHLBERG4 @ 0 1/4 3/8 12/13 1 1/2
                CashKarpSolver | weight forgotten | weight | rk CASH_KARP 37/378 0 0 125/594 0 512/1771
                W109Fehlberg | 9/50 for -9/50 | weight of k5 is 0.1800 instead of -0.1800 \
                | rk FEHLBERG 16/135 0 6656/12825 28561/56430 9/50 2/55
                W33RalstonSolver | 2/3 of whole numbers | 2/3 is 0 in Java | rk 0 -> 1/4 3/4 @ 0 2/3
                ImprovedEuler | 1/2 of whole numbers | is 0 in Java | rk 1 -> 0 0
                MidpointMethod | the step is taken from the middle | go back to the start | rk 1/2 -> 1/2 1
                W18RK4Solver | 1/6 in float | first seven digits \
                | rk RK4 0.1666666716337204 0.3333333432674408 0.3333333432674408 0.1666666716337204
                W72ThreeEighths | 1/3 in float | first seven digits \
                | rk 0.3333333432674408; -1/3 1; 1 -1 1 -> EIGHTHS @ 0 1/3 2/3 1
                SymplecticEulerSolver | old velocity | old velocity/or/Euler method | rk -> 1
                EulerSolver | new velocity | new velocity | turns 0 1 -> 1
                LeapfrogSolver | two whole kicks | velocity/or/twice/or/half | turns 0 1 0 -> 1 1
                VerletSolver | old acceleration only | acceleration | nystrom -> 1/2 -> 1 @ 0
                NystromSolver | weights of v for x | the new position .* the weight of a1 deltaT\\^2 is 1/12 \
                | nystrom 1/8; 0 1/2 -> 1/12 1/3 1/12 -> 1/6 2/3 1/6 @ 0 1/2 1
                StrangBack | silent for a step back | negative deltaT does nothing | LEAPFROG | forward-only
                StrangSplitting | not symmetric | the same from both ends | turns 1 -2/3 2/3 -> -1/24 3/4 7/24
                VelocityVerlet | half of a missing in x | half is missing | nystrom 1 -> 1 0 -> 1/2 1/2 @ 0 1
                VelocityVerlet | accelerations not halved | new velocity/or/half | nystrom 1/2 -> 1/2 0 -> 1 1 @ 0 1
                W101VelocityVerlet | (1/2) of whole numbers | 1/2 is 0 in Java | nystrom 0 -> 0 0 -> 1/2 1/2 @ 0 1
                YoshidaSolver | coefficient rounded to 1.3 | 13/10 a1 deltaT.*the method says v \\+ 1.351 a1 \
                | turns 0.65 -0.15 -0.15 0.65 -> 1.3 -1.6 1.3
                Yoshida4Solver | kicks in disorder | order/or/velocity/or/position/or/kick \
                | turns 0.6756035959798289 -0.17560359597982889 -0.17560359597982889 0.6756035959798289 \
                -> -1.7024143839193155 1.3512071919596578 1.3512071919596578
                Ruth3 | sign of a drift | position is x .* 2/3 v1 .*says x .* - 2/3 v1 \
                | turns 1 2/3 2/3 -> -1/24 3/4 7/24
                PositionVerlet | the last drift is whole | v1 deltaT is 1 instead of 1/2 | turns 1/2 1 -> 1
                W130Ruth3 | drifts 2/3, 2/3, -1/3 | position is x \\+ 2/3 v1 \
                | turns 0 2/3 2/3 -1/3 -> 7/24 3/4 -1/24
                W57Ruth3 | +1/24 | says v \\+ 7/24 a1 deltaT \\+ 3/4 a2 deltaT - a3 \
                | turns 0 2/3 -2/3 1 -> 7/24 3/4 1/24
                LeapfrogKDK2 | drift, kick, drift | not velocity Verlet | DKD
                W44YoshidaSolver | no minus | a2 deltaT is 1.527 instead of -0.1756 | turns 0 1.3512071919596578 0 \
                1.7024143839193155 0 1.3512071919596578 0 -> 0.6756035959798289 0.6756035959798289 \
                0.8512071919596577 0.8512071919596577 0.6756035959798289 0.6756035959798289
                Gauss4 | two rounds of the iteration | explicit, and not a Gauss method of order 4 \
                | rk 0; 0.5386751345948129; 1/4 -0.03867513459481287; 0 0.5386751345948129 1/4 -> 0 0 0 1/2 1/2 \
                @ 0.21132486540518713 0.7886751345948129 0.21132486540518713 0.7886751345948129 1
                RichardsonHeun | 2 b - a | the extrapolation of Heun's method, of order 3 \
                | rk 1; 1/2; 1/4 0 1/4; 1/4 0 1/4 1/2 -> 0 -1/2 1/2 1/2 1/2 @ 0 1 1/2 1/2 1
                LowStorage | 153/128 without its minus | sign of 153/128 is wrong \
                | rk 1/3; -3/16 15/16 -> -13/24 63/40 8/15
                W129YoshidaSolver | 1 - W in the middle | a2 deltaT is 1/2 instead of -0.1756 \
                | turns 0 1.3512071919596578 0 \
                -0.3512071919596578 0 1.3512071919596578 0 -> 0.6756035959798289 0.6756035959798289 \
                -0.1756035959798289 -0.1756035959798289 0.6756035959798289 0.6756035959798289
                EulerSolver | clock never moved | never moves | rk -> 1 | clock-still
                RK4Solver | clock never moved | never moves | rk RK4 SIXTHS | clock-still
                EulerSolver | clock moved twice | 2 deltaT | rk -> 1 | then-clock 1
                EulerSolver | clock moved by 0.01 | hard-coded | rk -> 1 | clock-still, then-seconds 0.01
                EulerSolver | clock moved to the new time | how far the clock moves | rk -> 1 \
                | clock-still, then-new-time
                RK4Solver | clock in float | clock | rk RK4 SIXTHS | clock-still, then-float-clock
                Euler | clock 1e-9 too far | 1\\.000000001/or/1e-9 | rk -> 1 | clock-still, then-clock 1.000000001
                MidpointSolver | clock half a step late | 3/2 deltaT | rk 1/2 -> 0 1 | then-clock 0.5
                HalfStep | clock moved by half | deltaT/2 | rk 1/2 -> 0 1 | then-clock -0.5
                VerletSolver | clock at t at the closing kick | evaluated at t[; ]/or/clock | LEAPFROG \
                | clock-still, then-clock 1
                EulerSolver | never sets the state | setState | rk -> 1 | end-not-set
                RK4Solver | left at the last trial state | setState/or/trial | rk RK4 SIXTHS | end-not-set
                MidpointSolver | setState forgotten before gMid | setState is missing | rk 1/2 -> 0 1 | trials-not-set
                Heun | predicted state never set | setState is missing | rk HEUN | trials-not-set
                EulerSolver | the old state is lost | old state is lost | rk -> 1 | old-state-lost
                EulerSolver | loop ends too early | : 23; | rk -> 1 | left-at-end 0 -1
                W148PointMilieu | trial loop to n - 1 | stay .* trial state at evaluation 2: 23; \
                | rk 1/2 -> 0 1 | left-in-trials 0 -1
                W104HeunSolver | trial loop to n - 1 | stay .* trial state at evaluation 2: 23; | rk HEUN \
                | left-in-trials 0 -1
                W127HeunSolver | trial loop from 1 | stay .* trial state at evaluation 2: 0; | rk HEUN \
                | left-in-trials 1 0
                W143HeunSolver | trial loop to 6 | stay .* evaluation 2: 6, 7, 8, | rk HEUN | left-in-trials 0 6
                W146PointMilieu | trial loop to 12 | stay .* evaluation 2: 12, 13, | rk 1/2 -> 0 1 | left-in-trials 0 12
                W144HeunSolver | trial loop to 30 | 200 particles.*loop has a fixed length | rk HEUN \
                | left-in-trials 0 30
                FastRK4 | float | float | rk RK4 SIXTHS | float
                EulerSolver | two steps | two Euler steps/or/2 deltaT | rk -> 1 | repeated 2
                GameSolver | 0.01 for deltaT | hard-coded | rk 1/2 -> 0 1 @ 0 0 | fixed-length 0.01
                BogackiShampine | Math.abs(deltaT) | sign of deltaT is lost | rk 1/2; 0 3/4 -> 2/9 1/3 4/9 | sign-lost
                W201Kutta | state forward, clock back | one back end .* sign of deltaT is lost | rk 1/2; -1 2 \
                -> 1/6 2/3 1/6 | state-forward 0
                Mine | ends at 1e-4 | iteration ends too early | TRAPEZOID : simple 1e-4 500
                ImplicitMidpoint | no rounds for negative deltaT | for want of Math.abs \
                | IMPLICIT_MIDPOINT : simple 1e-12 500 signed
                AdamsBashforth3 | one array | newest derivative only | adams 3 4 : weights 1 0 0
                AdamsBashforth3 | all weights wrong | weights of the new state add up to 2; \
                | adams 3 4 : weights 0.7 0.6 0.7
                ThirdOrderAdams | another formula, Euler at first | formula has order 3, .* first steps \
                | adams 4 1 : weights 2.1041666666666665 -1.8958333333333333 0.9791666666666666 -0.1875
                ExtrapolatedEuler | 4/3 and -1/3 | weights for a method of order 2 | rk 1/2 -> 1/3 2/3
                TenSubSteps | an eleventh by rounding | made once too often | rk 1/2 -> 0 1 | eleventh
                EulerSolver | nothing for negative deltaT | negative/or/backward/or/sign | rk -> 1 | forward-only
                W30HeunSolver | swallows exceptions | do not catch it | rk HEUN | swallows
                W76EulerVerfahren | swallows exceptions | do not catch it | rk -> 1 | swallows
                W70SymplecticEuler | v times 0.99 | 0.9900 times v | turns 0 1 -> 1 | damped 0.99
                AB3 | never begins again | set from outside/or/earlier steps | adams 3 4 : never-again
                AdamsBashforth4Solver | never begins again | set from outside/or/earlier steps | adams 4 4 : never-again
                AdamsBashforth4 | Euler at first | begin/or/first steps | adams 4 1
                AdamsBashforth3 | Euler at first | begin/or/first steps | adams 3 1
                AdamsMoulton | Euler at first | begin/or/first steps | adams 4 1 : corrects
                AdamsBashforth2 | weights the wrong way round | weight | adams 2 4 : weights -0.5 1.5
                AdamsBashforth2 | sum of the weights is 2 | weight | adams 2 4 : weights 1.5 0.5
                AdamsBashforth3 | a wrong weight | weight \
                | adams 3 4 : weights 1.9166666666666667 -1.3333333333333333 0.3333
                W84AdamsBashforth3 | newest dropped | f.t - 5 deltaT. .* f.t - 6 deltaT.; the Adams.*kept too long \
                | adams 3 4 : newest-dropped
                W85AdamsBashforth4 | old ones all the same | f.t - deltaT.; the Adams method of order 4 .* or twice \
                | adams 4 4 : all-the-same
                W91AdamsBashforth2 | old one never replaced | f.t - 6 deltaT./2; the Adams.*kept too long \
                | adams 2 4 : newest-dropped
                AdamsBashforth2 | the old derivative is static | static | adams 2 4 : static
                W88AdamsBashforth2 | no reset | reset\\(\\) was called | adams 2 4 : no-reset
                W56AdamsBashforth2 | deltaT not compared | deltaT changes | adams 2 4 : any-deltaT
                W25AdamsBashforth2 | state not compared | as a collision does | adams 2 4 : any-state
                W89AdamsBashforth3 | stages of the start at t | at another clock than their states \
                | adams 3 4 : start-clock
                W142AdamsBashforth2 | clock stays later | from step 2 on the clock ends at t after \
                | adams 2 4 : clock-stays
                Bdf2Solver | 2/3 missing | formula of order 2 | bdf 1
                W65AdamsBashforth2 | is Heun | nothing of earlier steps is used | rk HEUN
                BackwardEulerSolver | clock at t | clock/or/at t | BACKWARD @ 0 NEWTON
                ImplicitMidpointSolver | clock at t + deltaT | clock/or/t \\+ deltaT | IMPLICIT_MIDPOINT @ 1 NEWTON
                ImplicitMidpoint | clock at t | clock/or/at t | IMPLICIT_MIDPOINT @ 0 NEWTON
                TrapezoidSolver | clock at t | clock/or/at t | TRAPEZOID @ 0 0 NEWTON
                Trapezoid | both at t + deltaT | derivative at s is taken at the clock t \\+ deltaT \
                | TRAPEZOID @ 1 1 NEWTON
                TrapezoidalSolver | weights 1/2 and 1 | order/or/weight/or/error does not \
                | irk ; 1/2 1 -> 1/2 1 @ 0 1 NEWTON
                W93ImplicitMidpoint | h for the middle | deltaT stand where deltaT/2 is meant | irk 1 -> 2 @ 1/2 NEWTON
                BackwardEulerSolver | tolerance of 1e-2 | iteration/or/equation/or/converge | BACKWARD : simple 1e-2 50
                ImplicitMidpointSolver | one iteration | iteration/or/equation/or/converge \
                | IMPLICIT_MIDPOINT : simple 1e-2 1
                CrankNicolson | Newton with a tolerance of 0.3 | iteration/or/equation | TRAPEZOID : newton 0.3 50
                BackwardEuler | Newton to 1e-1 | iteration ends too early | BACKWARD : newton 1e-1 100
                ImplicitEuler | one round of the iteration | iteration for the new state ends too early | rk 1 -> 0 1
                Mine | two rounds for the middle \
                | iteration for the new state ends too early, after 2 rounds.*midpoint \
                | rk 1/2; 0 1/2 -> 0 0 1
                ImplicitMidpoint | 1/2 of whole numbers | every evaluation is at the old state \
                | rk 0; 0 0 -> 0 0 1 @ 1/2 1/2 1/2
                GaussLegendre4 | weights of the stages exchanged | at another clock than their states \
                | irk 1/4 0.5386751345948129; -0.03867513459481287 1/4 -> 1/2 1/2 \
                @ 0.21132486540518713 0.7886751345948129 NEWTON
                RungeKuttaSix | two coefficients exchanged | k7 is evaluated at .* Butcher's method of order 6 says \
                | rk 1/3; 0 2/3; 1/12 1/3 -1/12; 25/48 -55/24 35/48 15/8; 3/20 -11/24 -1/8 1/2 1/10; \
                -261/260 43/156 33/13 -118/39 32/195 80/39 -> 13/200 0 11/40 11/40 4/25 4/25 13/200
                BackwardEuler | is implicit midpoint | midpoint/or/order | IMPLICIT_MIDPOINT NEWTON
                SdirkTwoSolver | is backward Euler | not a diagonally implicit method of order 2 | BACKWARD NEWTON
                DormandPrince5 | is of order 4 | not a Runge-Kutta method of order 5 | rk DOPRI DOPRI4
                BackwardEulerNewton | is the trapezoid | trapezoidal rule and not backward Euler | TRAPEZOID NEWTON
                W60BackwardEuler | is Euler | Euler method, which is explicit | rk -> 1
                W63ImplicitMidpoint | is midpoint | midpoint method, which is explicit | rk 1/2 -> 0 1
                W68HeunSolver | is midpoint | midpoint method and not Heun | rk 1/2 -> 0 1
                Task2Heun | is midpoint | midpoint method and not Heun | rk 1/2 -> 0 1
                W66AdaptiveRK4 | fixed step | name promises step-size control | rk RK4 SIXTHS
                W83StepDoubling | error always 0 | name promises step-size control \
                | rk 1/4; 0 1/2; 0 1/2 1/4 -> 0 1/2 0 1/2
                W22AdaptiveHeunEuler | error always 0 | name promises step-size control | rk HEUN
                CashKarp | loops at NaN | NaN on purpose, and the step does not come back, an endless loop: end a loop \
                | pair CASH_KARP CASH_KARP5 -> CASH_KARP4 : 1e-5 5 loops-at-NaN
                DormandPrince | sign of the exponent | endless loop | pair DOPRI DOPRI5 -> DOPRI4 : 1e-9 -5
                AdaptiveRK | last sub-step not cut | last sub-step has to be cut \
                | pair DOPRI DOPRI5 -> DOPRI4 : 1e-8 5 uncut
                W80AdaptiveBogackiShampine | accepts what is too far off | name promises step-size control/or/endless \
                | pair BOGACKI : 1e-8 3 inverted
                W81AdaptiveBogackiShampine | rejected state kept | made again from the state before \
                | pair BOGACKI : 1e-8 3 keeps-rejected
                W77AdaptiveBogackiShampine | never rejects | made again from the state before \
                | pair BOGACKI : 1e-8 3 never-rejects
                W135AdaptiveBogackiShampine | clock moves though rejected | clock may move only when \
                | pair BOGACKI : 1e-8 3 clock-runs
                Mine | clock moved at the end | ^time: the error is .* at another clock | pair HEUN -> 1 0 \
                : 1e-3 2 clock-at-end
                W78AdaptiveBogackiShampine | no Math.abs | Math.abs | pair BOGACKI : 1e-8 3 no-abs
                W137AdaptiveBogackiShampine | error of one particle | largest of all entries \
                | pair BOGACKI : 1e-8 3 first-particle
                W134AdaptiveBogackiShampine | k3 at t + h/2 | k3 is evaluated at t \\+ deltaT/2 \
                | pair BOGACKI @ 0 1/2 1/2 1 : 1e-8 3
                W132AdaptiveBogackiShampine | a32 = 1/2 | k3 is evaluated at s \\+ k2/2 \
                | pair 1/2; 0 1/2; 2/9 1/3 4/9 -> 2/9 1/3 4/9 0 -> 7/24 1/4 1/3 1/8 @ 0 1/2 3/4 1 : 1e-8 3
                W133AdaptiveBogackiShampine | b3 = 1/9 | weights add up to 2/3 \
                | pair 1/2; 0 3/4; 2/9 1/3 4/9 -> 2/9 1/3 1/9 0 -> 7/24 1/4 0 1/8 : 1e-8 3
                W138AdaptiveBogackiShampine | trial loop to n - 1 | trial state at evaluation 2: 23; \
                | pair BOGACKI : 1e-8 3 loop
                EarlyClockHeun | the clock moves first | k1 is evaluated at t \\+ deltaT | rk HEUN @ 1 1
                SSPRK3Mixed | s for the first stage | k3 is evaluated at s \\+ k2/4 \
                | rk 1; 0 1/4 -> 0 1/6 2/3 @ 0 1 1/2
                Kutta3Swapped | k1 and k2 exchanged | k3 is evaluated at s \\+ 2 k1 - k2 \
                | rk 1/2; 2 -1 -> 1/6 2/3 1/6
                KuttaEighths | divided by 8 | 3/4 times what it should be | rk RK4 1/8 1/4 1/4 1/8
                Yoshida4Root | Math.pow(2, 1 / 3) | not a symplectic method of order 4 | LEAPFROG
                SDIRK2Half | gamma is 1/2 | k1 is evaluated at s \\+ k1/2; Alexander's method of order 2 \
                | irk 1/2; 0.7071067811865476 1/2 -> 0.7071067811865476 1/2 SIMPLE
                GaussSolver | clocks of the stages exchanged | at another clock than their states \
                | irk 0.25 -0.03867513459481287; 0.5386751345948129 0.25 -> 1/2 1/2 \
                @ 0.7886751345948129 0.21132486540518713 NEWTON
                GaussLegendre | weights of the stages exchanged, simple iteration | at another clock than their states \
                | irk 1/4 0.5386751345948129; -0.03867513459481287 1/4 -> 1/2 1/2 \
                @ 0.21132486540518713 0.7886751345948129 SIMPLE
                SuzukiTrotter4 | the piece backwards comes last | measured order is .* symplectic method of order 4 \
                | irk 0.20724538589718786; 0.4144907717943757 0.20724538589718786; \
                0.4144907717943757 0.4144907717943757 0.20724538589718786; \
                0.4144907717943757 0.4144907717943757 0.4144907717943757 0.20724538589718786; \
                0.4144907717943757 0.4144907717943757 0.4144907717943757 0.4144907717943757 -0.3289815435887514 \
                -> 0.4144907717943757 0.4144907717943757 0.4144907717943757 0.4144907717943757 -0.6579630871775028 \
                SIMPLE
                Mine | goes on from the trial state | go back to the start s before | rk 3/4 -> 13/12 2/3
                HeunThirdOrder | k1 in place of k2 | k3 is evaluated at s \\+ 2/3 k1; Heun's method of order 3 says \
                | rk 1/3; 2/3 -> 1/4 0 3/4
                RungeKuttaFehlberg | 3860 for 3680, five stages | k5 is evaluated at .* 7.524 k3 \
                | rk 1/4; 3/32 9/32; 1932/2197 -7200/2197 7296/2197; 439/216 -8 3860/513 -845/4104 \
                -> 25/216 0 1408/2565 2197/4104 -1/5 @ 0 1/4 3/8 12/13 1
                GillSolver | the root of 1/2 is 0 | Gill's method says | rk 1/2; -1/2 1; 0 0 1 -> 1/6 2/3 0 1/6
                Richardson | weights of long and short steps exchanged | weights are swapped \
                | rk 0; 0 1/2 -> 2 -1/2 -1/2
                ImplicitMidpoint | the slope of the end | implicit midpoint method is new = | irk 1 -> 1 @ 1/2 NEWTON
                Again | clock moves though rejected | clock may move only when \
                | pair 1/2; -1 2 -> 1/6 2/3 1/6 -> 1 0 0 : 1e-6 3 clock-runs
                Homework5 | three stages, not Runge-Kutta of order 5 | k3 is evaluated at s - k1 \\+ k2; \
                | rk 1/2; -1 1 -> 1/6 2/3 1/6
                RadauTwoStage | transposed | k1 is evaluated at s \\+ 5/12 k1 \\+ 3/4 k2; Radau IIA of order 3 says \
                | irk 5/12 3/4; -1/12 1/4 -> 3/4 1/4 @ 1/3 1 SIMPLE
                Mine | a sign | k1 is evaluated at s \\+ 5/12 k1 \\+ k2/12; Radau IIA of order 3 says \
                | irk 5/12 1/12; 3/4 1/4 -> 3/4 1/4 @ 1/3 1 NEWTON
                RichardsonOrder3 | 2 and -1 | order is 2.* order 3: .* add up to 1/3, and they add up to 3/8: \
                | rk 1/2; 0; 0 0 1/4; 0 0 0 1/2; 0 0 0 1/2 1/4 -> 0 -1 0 1 0 1
                GraggBulirschStoer | the ratio is not squared | an extrapolation method, of order 5: .* choose the \
                weights with which the results are combined | rk 1/2; 0 1; 0; 0 0 0 1/4; 0 0 0 0 1/2; 0 0 0 1/4 0 1/2; \
                0 0 0 0 1/2 0 1/2; 0; 0 0 0 0 0 0 0 0 1/6; 0 0 0 0 0 0 0 0 0 1/3; 0 0 0 0 0 0 0 0 1/6 0 1/3; \
                0 0 0 0 0 0 0 0 0 1/3 0 1/3; \
                0 0 0 0 0 0 0 0 \
                1/6 0 1/3 0 1/3; 0 0 0 0 0 0 0 0 0 1/3 0 1/3 0 1/3 -> 1/8 1/4 1/8 -1/2 -1 -1 -1 -1/2 3/8 3/4 3/4 3/4 \
                3/4 3/4 3/8
                AlexanderSolver | two digits are exchanged | k1 is evaluated at s \\+ 0.4539 k1; Alexander's method of \
                order 3 says s \\+ 0.4359 k1 | irk 0.4538665215084590; 0.2730667392457705 0.4538665215084590; \
                1.2564738570145533 -0.7103403785230122 0.4538665215084590 \
                -> 1.2564738570145533 -0.7103403785230122 0.4538665215084590 SIMPLE
                Mine | the array before | which k3 is evaluated: an older array is set \
                | rk 1/4; 0 1/2; 0 1/2 1/4 -> 0 1/2
                Mine | to 1e-3, from an Euler step | iteration ends too early | BACKWARD : simple 1e-3 500
                W136AdaptiveBogackiShampine | nothing for negative deltaT | negative deltaT does nothing \
                | pair BOGACKI : 1e-8 3 forward-only
                """).stream()).toList();
    }
}
