package particles.app.run;

import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import particles.app.cli.ProgramCommand;
import picocli.CommandLine.Command;

/** {@code gradle solvers}: lists the solvers, one line each. */
@Command(name = "solvers", description = "Lists the solvers with their orders.")
public final class SolversCommand extends ProgramCommand {
    @Override
    public void run(PrintWriter out) {
        List<SolverInfo> all = SolverCatalog.all();
        int widest = all.stream().mapToInt(solver -> solver.name().length()).max().orElse(0);
        for (SolverInfo solver : all) {
            out.printf(Locale.ROOT, "%-" + widest + "s  order %d  %s%n", solver.name(), solver.order(),
                    solver.sentence());
        }
    }
}
