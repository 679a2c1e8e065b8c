package particles.app.run;

import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import java.io.PrintWriter;
import java.util.List;
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
            out.println(solver.name() + " ".repeat(widest - solver.name().length()) + "  order " + solver.order() + "  "
                    + solver.sentence());
        }
    }
}
