package particles.app.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import org.junit.jupiter.api.Test;

class PrintedProgressTest {
    private long now;

    @Test
    void aLineIsPrintedEveryTwoSecondsAtMost() {
        StringWriter text = new StringWriter();
        PrintedProgress progress = new PrintedProgress(new PrintWriter(text), () -> now);
        double[][] reached = {{1, 0.01}, {5, 0.05}, {30, 0.5}, {31, 0.6}, {58, 0.95}};
        for (double[] at : reached) {
            now = (long) (at[0] * 1e9);
            progress.reached(at[1], "rk4");
        }
        assertEquals(List.of("5 %: rk4", "50 %: rk4", "95 %: rk4"), text.toString().lines().toList());
    }
}
