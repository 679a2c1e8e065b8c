package particles.app;

import java.io.PrintWriter;
import java.util.List;

/** Where the program starts: {@code desolver COMMAND --option=value ...}, or {@code gradle COMMAND -Poption=value ...}. */
public final class Main {
    private Main() {
    }

    /** @param args a command and its options */
    public static void main(String[] args) {
        System.setProperty("java.awt.headless", "true");
        Program program = new Program(commands(), OptionStyle.current(), new PrintWriter(System.out, true),
                new PrintWriter(System.err, true));
        System.exit(program.execute(args).code());
    }

    /** @return all commands, in the order in which help lists them; build.gradle has a task for each */
    static List<ProgramCommand> commands() {
        return List.of(new SolversCommand());
    }
}
