package particles.app.student;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import particles.app.cli.ExitCode;

/** A check's process cannot make up its own verdict. */
class StudentProcessTest {
    @Test
    void onlyAVerdictSignedInThisRunCounts() {
        StudentProcess.Secret secret = new StudentProcess.Secret("12");
        StudentProcess.Secret other = new StudentProcess.Secret("13");
        StudentProcess.Outcome right = new StudentProcess.Outcome(ExitCode.DONE, List.of("a line", "", "another"));
        assertEquals(right, secret.read(secret.sign(right)));
        String wrong = new String(secret.sign(new StudentProcess.Outcome(ExitCode.BAD_INPUT, List.of("a line"))),
                StandardCharsets.UTF_8);
        for (byte[] forged : List.of(other.sign(right), bytes(wrong.replace("BAD_INPUT", "DONE")),
                bytes(wrong + "\nDONE"), bytes("DONE\nDONE\na line"), new byte[0])) {
            assertEquals(ExitCode.BAD_INPUT, secret.read(forged).code());
        }
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }
}
