package particles.output.files;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

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
    private static final Pattern FRAME = Pattern.compile("frame-\\d{5,10}\\.(png|obj)");

    private final Path folder;
    private final Disk disk;
    private final Set<String> names = new LinkedHashSet<>();

    OutputManifest(Path folder, Disk disk) {
        this.folder = folder;
        this.disk = disk;
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
        OutputFile.write(folder.resolve(NAME), disk, text);
    }

    /** @return the names in the list of a folder; empty if there is no list */
    static List<String> names(Path folder) throws IOException {
        Path list = folder.resolve(NAME);
        return !Files.isRegularFile(list, LinkOption.NOFOLLOW_LINKS) ? List.of()
                : Files.readAllLines(list, StandardCharsets.UTF_8).stream()
                        .filter(name -> PLAIN_NAME.matcher(name).matches()).toList();
    }

    /**
     * Removes the listed files: all, or none if another program has one open, which on Windows keeps its name then. The
     * list itself stays until the new one replaces it.
     */
    void removeOldRun() {
        Map<Path, Path> renamed = new LinkedHashMap<>();
        try {
            List<Path> made = files();
            for (Path file : made) {
                if (isPlain(file)) {
                    disk.rename(file, OutputFile.partOf(file));
                    renamed.put(file, OutputFile.partOf(file));
                }
            }
            for (Path file : made) {
                if (isPlain(OutputFile.partOf(file))) {         // or left by a killed run
                    Files.delete(OutputFile.partOf(file));
                    renamed.remove(file);
                }
            }
            Files.deleteIfExists(OutputFile.partOf(folder.resolve(NAME)));
            removeFramesFolder();
        } catch (IOException e) {
            Path failed = e instanceof FileSystemException which ? Path.of(which.getFile()) : folder;
            OutputException failure = new OutputException(failed, "remove", e);
            renamed.forEach((file, part) -> {
                try {
                    disk.rename(part, file);
                } catch (IOException second) {
                    failure.addSuppressed(second);
                }
            });
            throw failure;
        }
    }

    /** A plain file; links and folders were not made by a run. */
    private static boolean isPlain(Path file) {
        return Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS);
    }

    /** The listed files and the frames, whether they are there or not. */
    private List<Path> files() throws IOException {
        List<Path> files = new ArrayList<>();
        for (String name : names(folder)) {
            if (!name.equals(OutputFolder.FRAMES)) {
                files.add(folder.resolve(name));
            } else if (hasFrames()) {
                try (Stream<Path> frames = Files.list(folder.resolve(name))) {
                    frames.map(file -> FRAME.matcher(file.getFileName().toString())).filter(Matcher::find)
                            .map(found -> folder.resolve(name).resolve(found.group())).distinct().forEach(files::add);
                }
            }
        }
        return files;
    }

    private boolean hasFrames() {
        return Files.isDirectory(folder.resolve(OutputFolder.FRAMES), LinkOption.NOFOLLOW_LINKS);
    }

    /** A folder with other files stays and can still be used for frames. */
    private void removeFramesFolder() throws IOException {
        if (names(folder).contains(OutputFolder.FRAMES) && hasFrames()) {
            try {
                Files.delete(folder.resolve(OutputFolder.FRAMES));
            } catch (DirectoryNotEmptyException e) {    // of files that no run made
                names.add(OutputFolder.FRAMES);
            }
        }
    }
}
