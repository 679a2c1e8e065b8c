package particles.app.course;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.app.course.ClassList.Student;
import particles.spec.messages.InvalidInputException;

/** Lists of students are read as people and Moodle write them, and each hand-in finds its student. */
class ClassListTest {
    @TempDir
    private Path folder;

    private ClassList list(String... lines) throws Exception {
        return ClassList.read(Files.writeString(folder.resolve("list.csv"), String.join("\n", lines)));
    }

    private static List<String> shown(ClassList list) {
        return list.students().values().stream().map(student -> student.id() + "|" + student.name() + "|"
                + student.mail() + "|" + student.number()).toList();
    }

    @Test
    void withoutAHeaderTheFirstLineIsAStudent() throws Exception {
        ClassList list = list("s1;Ann Lee;ann-lee", "s2;\"Doe; Jane\";7");
        assertEquals(List.of("s1|Ann Lee||", "s2|Doe; Jane||"), shown(list));
        assertEquals(List.of(folder.resolve("list.csv") + " has no header that is known: its first line is a student's,"
                + " with the id first"), list.remarks());
    }

    /** Quotes keep commas, semicolons, tabs and quotes within a name, whatever parts the columns. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            s1,"Doe, Jane"                | Doe, Jane
            "s1","Doe, Jane"              | Doe, Jane
            s1,"Doe, Jane, Mary"          | Doe, Jane, Mary
            s1,"Doe; Jane"                | Doe; Jane
            s1,Doe; Jane                  | Doe; Jane
            s1,"Jane ""JD"" Doe"          | Jane "JD" Doe
            s1,"Doe, ""JD"" Jane"         | Doe, "JD" Jane
            s1,"O'Hara, Kim"              | O'Hara, Kim
            s1,"Müller, Özlem"  | Müller, Özlem
            s1,Jane Doe,"x, y"            | Jane Doe
            s1,"de la Cruz, Ana, Jr."     | de la Cruz, Ana, Jr.
            """)
    void aNameInQuotesMayHaveAnySign(String line, String name) throws Exception {
        assertEquals(List.of("s1|" + name + "||"), shown(list("id,name,group", line)));
    }

    @Test
    void moodlesOwnListsAreRead() throws Exception {
        assertEquals(List.of("ann@x.nz|Ann Lee|ann@x.nz|"), shown(list("\ufeff\"First name\",\"Last name\","
                + "\"Email address\",Groups", "Ann,Lee,ann@x.nz,\"A, B\"")));
        assertEquals(List.of("a7|Lee, Ann|ann@x.nz|"), shown(list("First name,Last name,ID number,Email address,name",
                "x,y,a7,ann@x.nz,\"Lee, Ann\"")));
        assertEquals(List.of("Participant 12|Ann Lee||12"), shown(list("Identifier,Full name,Grade",
                "Participant 12,Ann Lee,-")));
        assertEquals(List.of("4|||"), shown(list("id\tgrade", "4\t")));
    }

    @Test
    void aListOfAnotherEncodingIsRead() throws Exception {
        Path file = folder.resolve("latin.csv");
        Files.write(file, "id;name\n1;J\u00f6rg\n".getBytes(StandardCharsets.ISO_8859_1));
        assertEquals(List.of("1|J\u00f6rg||"), shown(ClassList.read(file)));
    }

    @Test
    void anIdInTwoLinesIsRefusedAndOneThatIsMissingIsReported() throws Exception {
        String file = folder.resolve("list.csv").toString();
        InvalidInputException twice = assertThrows(InvalidInputException.class, () -> list("id,name", "s1,Ann",
                "s2,Bob", "S1,Cy", "s2,Di"));
        assertEquals(List.of(file + ":4: the id 'S1' is in an earlier line, too", file
                + ":5: the id 's2' is in an earlier line, too"), twice.getLines());
        ClassList list = list("id,name", ",Guest", "", "s1,Ann");
        assertEquals(List.of("s1|Ann||"), shown(list));
        assertEquals(List.of(file + ":2: left out, since it has no id"), list.remarks());
        assertThrows(InvalidInputException.class, () -> list("id,name", "s1,\"Ann\"x"));
        assertThrows(InvalidInputException.class, () -> ClassList.read(folder.resolve("none.csv")));
    }

    /** Two of one name, with Moodle's numbers 11 and 12; who has 13 is called Ann in the list. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            Dora Berg_11_assignsubmission_file_  | s1
            Dora Berg_12_assignsubmission_file_  | s2
            Dora Berg_99_assignsubmission_file_  | nobody
            Dora Berg_13_assignsubmission_file_  | nobody
            Ann_13_assignsubmission_file_        | s3
            Anna_13_assignsubmission_file_       | s3
            Ann_99_assignsubmission_file_        | s3
            Participant_13_assignsubmission_file | s3
            Dora Berg                            | nobody
            homework-1-mary-ann                  | s4
            homework-1-ann                       | s3
            ANN                                  | s3
            s2                                   | s2
            homework-joanna                      | nobody
            """)
    void everyClueToAStudentHasToAgree(String handIn, String student) throws Exception {
        ClassList list = list("id,identifier,name,login", "s1,Participant 11,Dora Berg,dora", "s2,Participant 12,"
                + "\"Berg, Dora\",dberg", "s3,Participant 13,Ann,ann", "s4,Participant 14,Mary,mary-ann");
        assertEquals(Optional.of(student).filter(id -> !id.equals("nobody")), list.owner(handIn).map(Student::id));
    }
}
