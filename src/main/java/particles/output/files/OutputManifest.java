package particles.output.files;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;

/**
 * The list of files that runs made in a folder, kept there in a small hidden file. A name is added before its file is
 * written, so that files of a killed run are known too.
 */
final class OutputManifest {
    /** The list's own name. */
    static final String NAME = ".desolver-made";
    private static final String HEAD =
            "# DESolver made these files and replaces them at its next run into this folder.";
    private static final Pattern PLAIN_NAME = Pattern.compile("[A-Za-z0-9][A-Za-z0-9._-]*");
    private static final Pattern FRAME = Pattern.compile("frame-\\d{5,10}\\.png|\\.frame-\\d{5,10}\\.png\\.part");

    private final Path folder;
    private final OutputFile.Opener opener;
    private final Set<String> names = new LinkedHashSet<>();

    OutputManifest(Path folder, OutputFile.Opener opener) {
        this.folder = folder;
        this.opener = opener;
    }

    boolean contains(String name) {
        return names.contains(name);
    }

    /** Adds a name, unless a file exists that no run made. */
    void claim(String name) {
        if (!PLAIN_NAME.matcher(name).matches()) {
            throw new IllegalArgumentException("'" + name + "' is not a plain file name");
        }
        Path file = folder.resolve(name);
        if (!names.contains(name) && Files.exists(file, LinkOption.NOFOLLOW_LINKS)) {
            throw new OutputException(file, "write",
                    "this file exists and no run made it; move it away or choose another folder", null);
        }
        names.add(name);
    }

    void write() {
        byte[] text = (HEAD + "\n" + String.join("\n", names) + "\n").getBytes(StandardCharsets.UTF_8);
        OutputFile.write(folder.resolve(NAME), opener, text);
    }

    /** @return the names in the list of a folder; empty if there is no list */
    static List<String> names(Path folder) throws IOException {
        Path list = folder.resolve(NAME);
        return !Files.isRegularFile(list, LinkOption.NOFOLLOW_LINKS) ? List.of()
                : Files.readAllLines(list, StandardCharsets.UTF_8).stream()
                        .filter(name -> PLAIN_NAME.matcher(name).matches()).toList();
    }

    /** Removes the listed files. The list itself stays until the new one replaces it. */
    void removeOldRun() {
        try {
            Files.deleteIfExists(OutputFile.partOf(folder.resolve(NAME)));
            for (String name : names(folder)) {
                if (name.equals(OutputFolder.FRAMES)) {
                    removeFrames();
                } else {
                    remove(folder.resolve(name));
                    remove(OutputFile.partOf(folder.resolve(name)));
                }
            }
        } catch (IOException e) {
            throw new OutputException(folder, "remove the previous run from", e);
        }
    }

    /** Removes a plain file; links and folders were not made by a run. */
    private static void remove(Path file) throws IOException {
        if (Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
            Files.delete(file);
        }
    }

    /** Removes frames only; a folder with other files stays and can still be used for frames. */
    private void removeFrames() throws IOException {
        Path frames = folder.resolve(OutputFolder.FRAMES);
        if (!Files.isDirectory(frames, LinkOption.NOFOLLOW_LINKS)) {
            return;
        }
        try (DirectoryStream<Path> entries = Files.newDirectoryStream(frames)) {
            for (Path entry : entries) {
                if (FRAME.matcher(entry.getFileName().toString()).matches()) {
                    remove(entry);
                }
            }
        }
        try {
            Files.delete(frames);
        } catch (DirectoryNotEmptyException e) {        // of files that no run made
            names.add(OutputFolder.FRAMES);
        }
    }
}
