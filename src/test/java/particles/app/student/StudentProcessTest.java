package particles.app.student;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import particles.app.cli.ExitCode;

/** A check's process cannot make up its own verdict. */
class StudentProcessTest {
    @Test
    void onlyAVerdictSignedInThisRunCounts() {
        Check check = new CheckEffectCommand.CheckOfEffect("gravity");
        StudentProcess.Task task = new StudentProcess.Task(new byte[] {1, 2}, new TreeMap<>(), check, "");
        StudentProcess.Task other = new StudentProcess.Task(new byte[] {1, 3}, new TreeMap<>(), check, "");
        StudentProcess.Outcome right = new StudentProcess.Outcome(ExitCode.DONE, List.of("a line", "", "another"));
        assertEquals(right, task.read(task.sign(right)));
        String wrong = new String(task.sign(new StudentProcess.Outcome(ExitCode.BAD_INPUT, List.of("a line"))));
        for (byte[] forged : List.of(other.sign(right), wrong.replace("BAD_INPUT", "DONE").getBytes(),
                (wrong + "\nDONE").getBytes(), "DONE\nDONE\na line".getBytes(), new byte[0])) {
            assertEquals(ExitCode.BAD_INPUT, task.read(forged).code());
        }
    }
}
