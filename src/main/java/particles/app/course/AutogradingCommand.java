package particles.app.course;

import java.io.PrintWriter;
import particles.app.cli.ResultsCommand;
import particles.output.files.OutputFolder;
import picocli.CommandLine.Command;

/** {@code gradle autograding}: a workflow for GitHub Classroom, and a script for Moodle's Virtual Programming Lab. */
@Command(name = "autograding", description = "Writes a workflow for GitHub Classroom and a script for Moodle VPL.")
public final class AutogradingCommand extends ResultsCommand {
    private static final String WORKFLOW = """
            # For .github/workflows/ of the assignment's template. The reporter reads grade.json.
            name: Autograding Tests
            # Numbers come from the login: repositories are called homework-login, or change it here.
            env:
              ASSIGNMENT: homework
            on: [push, workflow_dispatch]
            permissions:
              checks: write
              actions: read
              contents: read
            jobs:
              run-autograding-tests:
                runs-on: ubuntu-latest
                if: github.actor != 'github-classroom[bot]'
                steps:
                  - uses: actions/checkout@v4
                  - uses: actions/setup-java@v4
                    with:
                      distribution: temurin
                      java-version: '21'
                  - id: grade
                    env:
                      REPOSITORY: ${{ github.event.repository.name }}
                    run: |
                      STUDENT=${REPOSITORY#"$ASSIGNMENT"-}
                      if [ "$STUDENT" = "$REPOSITORY" ]; then echo "$REPOSITORY: not $ASSIGNMENT-login"; exit 1; fi
                      rm -rf build/out
                      # a wrong answer fails, too, but has marks
                      gradle grade "-Pstudent=$STUDENT" || test -s build/out/grade/grade.json
                      echo "result=$(base64 -w0 build/out/grade/grade.json)" >> "$GITHUB_OUTPUT"
                  - uses: classroom-resources/autograding-grading-reporter@v1
                    env:
                      GRADE_RESULTS: "${{ steps.grade.outputs.result }}"
                    with:
                      runners: grade
            """;
    private static final String VPL = """
            #!/bin/bash
            # For Moodle's VPL: makes vpl_execution. Put what gradle installDist makes into /opt/desolver on the
            # execution server, and assignment.yaml into the execution files. Numbers come from Moodle's user id.
            { cat vpl_environment.sh; cat << 'END'; } > vpl_execution

            export JAVA_OPTS=-Ddesolver.exercises=.
            "${DESOLVER:-/opt/desolver/bin/desolver}" grade "--student=$MOODLE_USER_ID" --out=marks > marks.txt 2>&1
            echo '<|--'
            sed 's/^/>/' marks.txt
            echo '--|>'
            sed -n 's/^\\([0-9.]*\\) of \\([0-9.]*\\) points .*/\\1 \\2/p' marks.txt | tail -n 1 |
                awk -v low="${VPL_GRADEMIN:-0}" -v high="${VPL_GRADEMAX:-10}" \\
                '$2 > 0 { print "Grade :=>> " low + (high - low) * $1 / $2 }'
            END
            chmod +x vpl_execution
            """;

    @Override
    public void run(PrintWriter out) {
        try (OutputFolder files = OutputFolder.open(getFolder())) {
            files.write("classroom.yml", WORKFLOW);
            files.write("vpl_evaluate.sh", VPL);
        }
        out.println("classroom.yml, vpl_evaluate.sh: " + getFolder());
    }
}
