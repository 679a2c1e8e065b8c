/**
 * The commands for students' classes: skeletons, checks, exercises and marks. Code that calls a student's class runs in
 * a child process.
 *
 * <p>{@code gradeClass} marks each student's hand-in as {@code grade} does, in three passes: it copies all hand-ins,
 * marks all answers, and only then runs classes, one student on each core. Solvers, answers.yaml and the scene may
 * lie in any folder of the hand-in; of two hand-ins the later one counts. With {@code -Pstudents=list.csv}, each line
 * has an id, from which the numbers come, and then the names by which hand-ins are known: the name or number in
 * {@code Name_123_assignsubmission_file_}, or the login in {@code assignment-login}. Without it, the id is Moodle's
 * number or the folder's name. It writes class.csv, class.html and for each student a folder with grade.md. Classes
 * that are the same but for names, comments and layout, and those that use the project's solvers, are listed; nobody
 * loses a mark for it.
 *
 * <p>What both promise:
 * <ul>
 * <li>A line of {@code answers.yaml} that cannot be read costs only its own answer. A scene is read only from the
 * folder of that file, and links are not followed.
 * <li>All classes are read before any of them runs, and are handed to the check's process through its input. A class
 * that rewrites another's file changes no mark.
 * <li>Each class is checked in a process of its own, with limits on memory and CPU time. It may loop, print as much as
 * it likes or call {@code System.exit}. Only a verdict that is signed with a secret of this run counts; it is written
 * once, and the process ends at once. Control characters in messages are replaced.
 * </ul>
 *
 * <p>What it does not promise: it is no sandbox. A class can read and write the files of the user who runs it, and one
 * that is written to fool this very check, by replacing the checker's classes in memory or by behaving differently
 * later on, may succeed. For code that you do not trust, use a container without network, after {@code gradle
 * installDist}:
 *
 * <pre>
 * docker run --rm --network none --memory 2g -v "$PWD":/work -w /work eclipse-temurin:21 \
 *     build/install/desolver/bin/desolver grade --student=ID
 * </pre>
 */
package particles.app.student;
