package particles.teaching;

/** Says where in a student's class something went wrong. */
final class StudentFailure {
    private StudentFailure() {
    }

    /** @return the exception and the first line of a class that is neither the JDK's nor the checker's, if there is one */
    static String describe(Throwable thrown) {
        return thrown + place(thrown.getStackTrace());
    }

    /** @return such as {@code ", in MySolver.stepState, line 17 of MySolver.java"}; empty if no such line is there */
    static String place(StackTraceElement[] stack) {
        for (StackTraceElement frame : stack) {
            String name = frame.getClassName();
            boolean machinery = name.startsWith("java.") || name.startsWith("jdk.") || name.startsWith("sun.")
                    || name.startsWith("particles.teaching.") && !name.contains("Planted");
            if (!machinery) {
                return ", in " + name.replaceAll(".*[.$]", "") + "." + frame.getMethodName() + ", line " + frame.getLineNumber() + " of "
                        + frame.getFileName();
            }
        }
        return "";
    }
}
