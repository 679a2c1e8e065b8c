package particles.teaching.marking;

/** One task for a student, with numbers of the student's own. */
public interface Exercise {

    /** @return what it is about, in a few words */
    String title();

    /**
     * @param draw the student's numbers
     * @return the task
     */
    String text(Draw draw);

    /**
     * @param draw   the student's numbers
     * @param answer what the student typed
     * @return whether it is right, and if not, what is known of the reason
     */
    Mark mark(Draw draw, String answer);
}
