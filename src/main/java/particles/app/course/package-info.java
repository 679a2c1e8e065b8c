/**
 * The commands with which a lecturer marks a class, and a student sees before the hand-in what counts.
 *
 * <p>What counts stands in a file {@code assignment.yaml} ({@link particles.app.course.Assignment} shows one), which
 * {@code grade} and {@code gradeClass} both read.
 *
 * <p>{@code gradeClass -Pfolder=submissions} marks each student's hand-in as {@code grade -Phandin=...} does, in three
 * passes: it reads all hand-ins, marks all answers, and only then runs classes, one hand-in on each core. Solvers,
 * answers.yaml and the scene may lie in any folder of the hand-in; of several hand-ins the latest counts, with {@code
 * -Pattempt=best} the best. The date of a hand-in is that of its newest file; a git clone sets it to the time of
 * cloning. With {@code -Pstudents=list.csv}, each line has an id, from which the numbers come, and then the names by
 * which hand-ins are known: the name or number in {@code Name_123_assignsubmission_file_}, or the login in {@code
 * assignment-login}. Without it, the id is Moodle's number or the folder's name. It writes class.csv, class.html
 * (points, students to talk to, the commonest mistakes) and for each student a folder with grade.md and grade.json.
 * Classes that are the same but for names, comments and layout, and those that use the project's solvers, are listed;
 * nobody loses a mark for it. After a stop, the same command marks only those who have no result yet, or whose hand-in,
 * numbers or assignment changed.
 *
 * <p>For practice, a student's numbers come from the id, so anyone who knows an id can work out that student's numbers.
 * For graded work, {@code gradle sheets -Pstudents=list.csv -Pkey=key.csv} writes a printable sheet for each student
 * and a key file, which students never get, and {@code -Pkey=key.csv} marks with it; {@code numbers: sheet} in the
 * assignment tells {@code grade} of it. In a class of a hundred almost never is one student's answer also right for
 * another; with numbers from the id, at most ten share an answer with somebody in any exercise. {@code gradle
 * autograding} writes a workflow for GitHub Classroom and a script for VPL.
 *
 * <p>A large course is spread over processors or machines: one command marks one student, without knowing of others,
 * and the tables are made from the results. For hand-ins that are named by the students' ids (give {@code --student}
 * for others, and {@code --key} where there is one), after {@code gradle installDist}, with GNU parallel, in a job of a
 * CI matrix, or in a Slurm array:
 *
 * <pre>
 * export PATH=$PWD/build/install/desolver/bin:$PATH
 * ls submissions | parallel desolver grade --handin=submissions/{} --out=results/{}
 * desolver grade --handin="submissions/${{ matrix.student }}" --out="results/${{ matrix.student }}"
 * S=$(ls submissions | sed -n "${SLURM_ARRAY_TASK_ID}p"); desolver grade --handin="submissions/$S" --out="results/$S"
 * desolver gradeClass --collect=results
 * </pre>
 *
 * <p>What both promise:
 * <ul>
 * <li>A line of {@code answers.yaml} that cannot be read costs only its own answer. A scene is read only from the
 * folder of that file, and links are not followed.
 * <li>All classes are read before any of them runs, and are handed to the check's process through its input. A class
 * that rewrites another's file changes no mark, and {@code gradeClass} tells of it.
 * <li>Each class is checked in a process of its own, with limits on memory and CPU time. It may loop, print as much as
 * it likes or call {@code System.exit}. Only a verdict that is signed with a secret of this run counts; it is written
 * once, and the process ends at once. Control characters in messages are replaced.
 * <li>A right solver is run once more in a scene, with nothing of the check on the stack and after a random number
 * of further calls, in the thousands: it has to make the same steps there, bit for bit. The forces of a right effect
 * are asked for once more in this way, too.
 * <li>A check that the machine was too busy for, or that was stopped, is not decided; it is never a wrong answer.
 * </ul>
 *
 * <p>What they do not promise: they are no sandbox. A class can read and write the files of the user who runs it, also
 * earlier results. A class that is written to replace the checker's classes in memory may succeed. For code that you do
 * not trust, use a container without network, after {@code gradle installDist}:
 *
 * <pre>
 * docker run --rm --network none --memory 2g -v "$PWD":/desolver -v "$PWD/submissions":/desolver/submissions:ro \
 *     -w /desolver eclipse-temurin:21 build/install/desolver/bin/desolver gradeClass --folder=submissions
 * </pre>
 */
package particles.app.course;
