package particles.teaching.marking;

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
     * @return whether the answer is right, and if not, the likely mistake
     */
    Mark mark(Draw draw, String answer);
}
