package particles.teaching.exercises;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Function;
import particles.scene.SceneReader;

/** An exercise: one task with the student's own numbers. */
public interface Exercise {

    /** @return its subject, in a few words */
    String title();

    /**
     * @param draw the student's numbers
     * @return the task
     */
    String text(Draw draw);

    /**
     * @param draw   the student's numbers
     * @param answer the answer as the student typed it
     * @param files  reads the file that an answer names, or throws an
     *               {@link particles.spec.messages.InvalidInputException}
     * @return whether the answer is right, and if not, the likely mistake
     */
    Mark mark(Draw draw, String answer, Function<String, byte[]> files);

    /** The same, with files relative to the working directory. */
    default Mark mark(Draw draw, String answer) {
        return mark(draw, answer, path -> SceneReader.bytes(Path.of(path)));
    }

    /**
     * The mark of an answer.
     *
     * @param right whether it is right
     * @param lines the comments: the likely mistake, or the conditions that hold and that do not
     */
    record Mark(boolean right, List<String> lines) {

        private static final int MOST = 60;
        private static final int LONGEST = 1000;

        /**
         * Copies the list, cut short and with control characters made visible: lines hold what a student's class said.
         */
        public Mark {
            lines = lines.stream().limit(MOST).map(line -> line.substring(0, Math.min(LONGEST, line.length()))
                    .replaceAll("[\\p{Cc}\\p{Cf}\\p{Cs}]", "\ufffd")).toList();
        }

        /** @return an answer that is not right, for this reason */
        public static Mark wrong(String line) {
            return new Mark(false, List.of(line));
        }
    }
}
