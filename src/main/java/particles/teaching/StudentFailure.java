package particles.teaching;

import java.security.CodeSource;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** Finds the line of a student's class at which an exception was thrown. */
public final class StudentFailure {
    private StudentFailure() {
    }

    /** @return the exception and the line of the student's class that led to it, if there is one */
    public static String describe(Throwable thrown) {
        return thrown + place(thrown.getStackTrace());
    }

    /**
     * @return whether the class threw this on purpose, because it cannot do what was asked; false for the exceptions of
     * the JVM, which are mistakes
     */
    public static boolean isRefusal(RuntimeException thrown) {
        return !(thrown instanceof NullPointerException || thrown instanceof IndexOutOfBoundsException
                || thrown instanceof NegativeArraySizeException || thrown instanceof ClassCastException
                || thrown instanceof ArrayStoreException || "/ by zero".equals(thrown.getMessage()));
    }

    /**
     * @return the place, such as {@code ", in MySolver.stepState, line 17 of MySolver.java"}: the innermost line that
     * is neither the JDK's nor the program's; if there is none, the innermost of the program outside the checker; empty
     * without either
     */
    public static String place(StackTraceElement[] stack) {
        List<StackTraceElement> written = Arrays.stream(stack).filter(StudentFailure::isWritten).toList();
        Optional<StackTraceElement> found = written.stream().filter(frame -> !isOurs(frame)).findFirst()
                .or(() -> written.stream().filter(frame ->
                        !frame.getClassName().startsWith("particles.teaching.")).findFirst());
        return found.map(frame -> ", in " + frame.getClassName().replaceAll(".*[.$]", "") + "."
                + frame.getMethodName() + ", line "
                + frame.getLineNumber() + " of " + frame.getFileName()).orElse("");
    }

    /**
     * Whether a frame is of written code, and not the JDK's. Between a lambda and its caller the JVM puts a class of
     * its own, with no lines and a '/' in its name.
     */
    private static boolean isWritten(StackTraceElement frame) {
        return frame.getLineNumber() > 0 && !frame.getClassName().matches("(java|javax|jdk|sun)[.].*|.*/.*");
    }

    /**
     * Whether a class belongs to the program. Students' classes are in their own package, or come from another place
     * than the program's.
     */
    private static boolean isOurs(StackTraceElement frame) {
        if (frame.getClassName().startsWith("exercises.")) {
            return false;
        }
        try {
            return from(Class.forName(frame.getClassName(), false, Thread.currentThread().getContextClassLoader()))
                    .equals(from(StudentFailure.class));
        } catch (ClassNotFoundException e) {
            return false;                               // not even in sight of the program
        }
    }

    private static Optional<CodeSource> from(Class<?> type) {
        return Optional.ofNullable(type.getProtectionDomain().getCodeSource());
    }
}
