/**
 * The commands with which a lecturer marks a class, and a student sees before the hand-in what counts.
 *
 * <p>What counts stands in a file {@code assignment.yaml} ({@link particles.app.course.Assignment} shows one), which
 * {@code grade} and {@code gradeClass} both read.
 *
 * <p>{@code gradeClass -Pfolder=submissions -Pstudents=list.csv} first reads all hand-ins, and then marks each as
 * {@code grade} does, one on each core. Classes, answers and scenes may lie in any folder of the hand-in, in a zip or a
 * .tar.gz; of several hand-ins of a student, the one with the latest file counts. A git clone sets the dates of files
 * to the time of cloning. Whether a hand-in is late is for Moodle or GitHub to say. After a stop, the same command
 * marks only those who have no result yet, or whose hand-in, numbers or assignment changed; dates of files do not
 * matter there.
 *
 * <p>The list is one that Moodle exports (participants, or the grading worksheet), or has an id in each line, from
 * which the numbers come, and then a name and other names by which hand-ins are known: the name or number in {@code
 * Name_123_assignsubmission_file_}, the login in {@code assignment-login}. A hand-in is a student's if its number and
 * its name mean this one and nobody else. Without a list, the id is Moodle's number or the folder's name.
 *
 * <p>It writes class.csv (all marks), class.html (points, the commonest mistakes) and for each hand-in a folder with
 * grade.md and grade.json. Folders of hand-ins from Moodle have names that Moodle knows: a zip of them is what it takes
 * as multiple feedback files. A grading worksheet is written with the grades, as worksheet.csv. At the top are hand-ins
 * of which a person has to ask whose they are, and those that cannot be read; they have no mark. Hand-ins are not
 * compared with each other: <a href="https://github.com/jplag/JPlag">JPlag</a> does that.
 *
 * <p>For practice, a student's numbers come from the id, so anyone who knows an id can work out that student's numbers.
 * For graded work, {@code gradle sheets -Pstudents=list.csv -Pkey=key.csv} writes a printable sheet for each student
 * and a key file, which students never get, and {@code -Pkey=key.csv} marks with it; {@code numbers: sheet} in the
 * assignment tells {@code grade} of it. A secret is drawn again if an answer is also right for another student: in
 * classes of 100, 300 and 1,000, no answer was shared in any exercise. After 100 draws without success, {@code sheets}
 * names the student. With numbers from the id, at most ten of a hundred share an answer with somebody in any exercise.
 * {@code gradle autograding} writes a workflow for GitHub Classroom and a script for VPL.
 *
 * <p>A large course is marked in parts, on any number of processors or machines; README's section on exercises has the
 * commands for GNU parallel and for Slurm. A part's exit code is 0 when it has marked its hand-ins, whatever the marks
 * are; a part that was stopped goes on where it was. A result that is damaged costs one student.
 *
 * <p>What both commands promise:
 * <ul>
 * <li>A hand-in with a file that cannot be read has no marks; both say which file it is, and why.
 * <li>A line of the answers that cannot be read costs only its own answer. A scene is read only from the hand-in, and
 * links are not followed.
 * <li>{@code grade} takes no result that is there already; {@code gradeClass} only results of the same hand-in.
 * <li>All hand-ins of a run are read before a class of them runs, and are handed to the check's process through its
 * input. A class that rewrites another's file changes no mark of this run.
 * <li>Each class is checked in a process of its own, with limits on memory and CPU time. It may loop, print as much as
 * it likes or call {@code System.exit}. Only a verdict that is signed with a secret of this run counts; it is written
 * once, and the process ends at once. Control characters in messages are replaced.
 * <li>A right solver is run once more as in a scene, with nothing of the check on the stack and for 10,000 to 20,000
 * steps, a random number. Its steps there have to be those of a new solver from the same state, and after a reset it
 * has to repeat its first steps bit for bit. The forces of a right effect are asked for once more in this way, too.
 * <li>A check that the machine was too busy for, or that was stopped, is not decided; it is never a wrong answer.
 * </ul>
 *
 * <p>What they do not promise: they are no sandbox. A class can read and write the files of the user who runs it, also
 * earlier results. A class that is written to replace the checker's classes in memory may succeed. For code that you do
 * not trust, use a container without network, in which only the folder of the marks can be written; README has the
 * command.
 */
package particles.app.course;
