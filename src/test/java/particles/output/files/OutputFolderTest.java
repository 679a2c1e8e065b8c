package particles.output.files;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;
import particles.OtherSystems;

/** Output files are written whole or not at all, and other people's files are left alone. */
class OutputFolderTest {
    @TempDir
    Path top;

    private static void put(OutputFile file, String text) {
        try (file) {
            byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
            file.write(bytes, 0, bytes.length);
            file.commit();
        }
    }

    private static void assertRefused(String message, Executable what) {
        assertEquals(message, assertThrows(OutputException.class, what).getMessage());
    }

    private static Set<String> filesOf(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(f -> !f.equals(folder)).map(f -> folder.relativize(f).toString().replace('\\', '/'))
                    .collect(Collectors.toSet());
        }
    }

    @Test
    void aNewRunRemovesWhatTheOldOneMadeAndNothingElse() throws IOException {
        Path out = top.resolve("a b/größe");
        try (OutputFolder folder = OutputFolder.open(out, OutputFolder.FRAMES)) {
            put(folder.create("energy.png"), "old");
            for (int i = 0; i < 12; i++) {
                put(folder.createFrame(i, "png"), "old");
            }
        }
        assertTrue(Files.exists(out.resolve("frames/frame-00011.png")));
        Files.writeString(out.resolve("notes.txt"), "mine");
        Files.writeString(out.resolve("frames/best-frame.png"), "mine");
        Files.writeString(out.resolve("frames/.frame-00012.png.part"), "left by a killed run");
        Files.writeString(out.resolve(".energy.png.part"), "left by a killed run");
        try (OutputFolder folder = OutputFolder.open(out, OutputFolder.FRAMES)) {
            put(folder.createFrame(0, "png"), "new");
        }
        assertEquals(Set.of(".desolver-made", "notes.txt", "frames", "frames/best-frame.png",
                "frames/frame-00000.png"), filesOf(out));
        assertEquals("new", Files.readString(out.resolve("frames/frame-00000.png")));
    }

    @Test
    void aSecondRunIntoAFolderIsToldWhoWritesThere() throws IOException {
        OutputFolder first = OutputFolder.open(top, "run.json");
        put(first.create("run.json"), "first");
        assertRefused("cannot write into " + top + ": another run, process " + ProcessHandle.current().pid()
                + ", is writing there; wait until it ends, or choose another folder",
                () -> OutputFolder.open(top, "run.json"));
        assertEquals("first", Files.readString(top.resolve("run.json")), "nothing of the first run is touched");
        first.close();
        OutputFolder.open(top, "run.json").close();
        Files.writeString(top.resolve(".desolver-writing"), "1");
        OutputFolder.open(top, "run.json").close();     // a killed run's file is locked by nobody
        assertEquals(Set.of(".desolver-made"), filesOf(top));
    }

    /** On Windows nobody reads what another program has locked: the number of the process is not in the locked part. */
    @Test
    void theOwnerOfALockCanBeReadWhereALockedPartCannot() throws IOException {
        try (OutputFolder folder = OutputFolder.open(top);
                FileChannel file = FileChannel.open(top.resolve(".desolver-writing"), StandardOpenOption.READ,
                        StandardOpenOption.WRITE)) {
            assertFalse(Disk.REAL.lock(file), folder.getPath() + " is locked");
            assertTrue(file.tryLock(0, 1 << 20, false).isValid(), "but not where the number is");
        }
    }

    /** As on Windows: a file that another program shows can be neither renamed nor replaced. */
    private record Windows(Path shown) implements Disk {
        @Override
        public OutputStream create(Path file) throws IOException {
            return Disk.REAL.create(file);
        }

        @Override
        public void rename(Path from, Path to) throws IOException {
            if (from.equals(shown) || to.equals(shown)) {
                throw new FileSystemException(shown.toString(), null, "it is being used by another process");
            }
            Disk.REAL.rename(from, to);
        }
    }

    @Test
    void aResultThatAnotherProgramShowsKeepsTheOthers() throws IOException {
        try (OutputFolder folder = OutputFolder.open(top)) {
            put(folder.create("energy.png"), "old");
            put(folder.createFrame(0, "png"), "old");
            put(folder.createFrame(1, "png"), "old");
        }
        Set<String> before = filesOf(top);
        for (String name : List.of("energy.png", "frames/frame-00001.png")) {
            Path shown = top.resolve(name);
            assertRefused("cannot remove " + shown + ": it is being used by another process",
                    () -> OutputFolder.open(top, new Windows(shown), "energy.png"));
            assertEquals(before, filesOf(top));
        }
        assertEquals("old", Files.readString(top.resolve("energy.png")));
    }

    @Test
    void anEmptyFramesFolderGoesWithItsFrames() throws IOException {
        try (OutputFolder folder = OutputFolder.open(top)) {
            put(folder.createFrame(0, "png"), "old");
        }
        OutputFolder.open(top).close();
        assertFalse(Files.exists(top.resolve("frames")));
    }

    @Test
    void aFileThatNoRunMadeIsRefusedBeforeTheRun() throws IOException {
        Files.writeString(top.resolve("energy.png"), "mine");
        assertThrows(OutputException.class, () -> OutputFolder.open(top, "energy.png"));
        OutputFolder folder = OutputFolder.open(top);
        assertThrows(OutputException.class, () -> folder.create("energy.png"));
        assertEquals("mine", Files.readString(top.resolve("energy.png")));
        Files.createDirectory(top.resolve("frames"));
        assertThrows(OutputException.class, () -> folder.createFrame(0, "png"));
    }

    @Test
    void aLinkThatTookTheNameOfAFileIsNotFollowed() throws IOException {
        try (OutputFolder folder = OutputFolder.open(top.resolve("out"))) {
            put(folder.createFrame(0, "png"), "old");
            put(folder.create("run.json"), "old");
        }
        Path elsewhere = Files.createDirectory(top.resolve("elsewhere"));
        Files.writeString(elsewhere.resolve("frame-00000.png"), "mine");
        Files.delete(top.resolve("out/frames/frame-00000.png"));
        Files.delete(top.resolve("out/frames"));
        OtherSystems.link(top.resolve("out/frames"), elsewhere);
        Files.delete(top.resolve("out/run.json"));
        OtherSystems.link(top.resolve("out/run.json"), elsewhere.resolve("frame-00000.png"));
        assertThrows(OutputException.class, () -> OutputFolder.open(top.resolve("out"), OutputFolder.FRAMES));
        assertThrows(OutputException.class, () -> OutputFolder.open(top.resolve("out"), "run.json"));
        assertEquals("mine", Files.readString(elsewhere.resolve("frame-00000.png")));
    }

    @Test
    void aFileIsThereAsAWholeOrNotAtAll() throws IOException {
        OutputFolder folder = OutputFolder.open(top);
        put(folder.create("run.json"), "first");
        OutputFile second = folder.create("run.json");
        second.write("seco".getBytes(StandardCharsets.UTF_8));
        assertEquals("first", Files.readString(top.resolve("run.json")));
        second.close();
        assertEquals("first", Files.readString(top.resolve("run.json")));
        OutputFile third = folder.create("run.json");
        third.write("third".getBytes(StandardCharsets.UTF_8));
        folder.close();                                             // as a stopping program does
        assertThrows(OutputException.class, third::commit);
        assertThrows(OutputException.class, () -> folder.create("late.txt"));
        assertEquals(Set.of(".desolver-made", "run.json"), filesOf(top));
    }

    @Test
    void aFullDiskLeavesNothingAndSaysSo() throws IOException {
        int[] room = {1000};
        Disk disk = path -> new OutputStream() {
            private final OutputStream stream = Disk.REAL.create(path);

            @Override
            public void write(int b) throws IOException {
                if (room[0]-- <= 0) {
                    throw new IOException("No space left on device");
                }
                stream.write(b);
            }

            @Override
            public void close() throws IOException {
                stream.close();
            }
        };
        OutputFolder folder = OutputFolder.open(top, disk);
        put(folder.create("small.txt"), "fits");
        OutputFile big = folder.create("big.txt");
        assertRefused("cannot write " + top.resolve("big.txt") + ": the disk is full", () -> {
            big.write(new byte[2000]);
            big.commit();
        });
        folder.close();
        assertEquals(Set.of(".desolver-made", "small.txt"), filesOf(top));
    }

    @Test
    void namesStayInTheFolder() {
        OutputFolder folder = OutputFolder.open(top.resolve("out"));
        for (String name : List.of("../x", "a/b", "", ".hidden", "/tmp/x", "..")) {
            assertThrows(IllegalArgumentException.class, () -> folder.create(name), name);
        }
    }

    /** As where a folder is to be made in /proc. */
    @Test
    void aFileThatTheSystemRefusesDoesNotBlameItsFolder() {
        IOException refused = new NoSuchFileException(top.resolve("x").toString());
        assertEquals("cannot write " + top.resolve("x") + ": the system does not allow it",
                new OutputException(top.resolve("x"), "write", refused).getMessage());
        assertEquals("cannot write " + top.resolve("none/x") + ": its folder does not exist",
                new OutputException(top.resolve("none/x"), "write", refused).getMessage());
    }
}
