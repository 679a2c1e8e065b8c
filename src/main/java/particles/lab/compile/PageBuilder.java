package particles.lab.compile;

import java.io.IOException;
import java.io.InputStream;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import particles.lab.LabBuilder;
import particles.lab.PageParts;
import particles.lab.Session;

/** Builds the lab's page: compiles the classes, and adds the scenes with their pictures. */
public final class PageBuilder implements LabBuilder {
    /** Made without parameters, by its name. */
    public PageBuilder() {
    }

    @Override
    public String build(Contents contents) throws IOException {
        Path folder = Files.createTempDirectory("lab");
        try {
            String engine = EngineCompiler.compile(StudentCompiler.compile(contents, folder), folder);
            return PageParts.page(engine, scenes(contents), List.of(PageParts.own("licences.txt"), apache()));
        } finally {
            try (Stream<Path> files = Files.walk(folder)) {
                for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                    Files.delete(file);
                }
            }
        }
    }

    private static String scenes(Contents contents) throws IOException {
        StringBuilder all = new StringBuilder();
        for (Path file : contents.scenes()) {
            String name = file.getFileName().toString();
            String text = Files.readString(file);
            String first = file.equals(contents.first()) ? first(name, text, contents) : "";
            byte[] picture = contents.pictures().getOrDefault(file, new byte[0]);
            all.append(PageParts.scene(name, text, first + " data-picture=\""
                    + Base64.getEncoder().encodeToString(picture) + '"'));
        }
        return all.toString();
    }

    /** What the page knows before its engine runs. A law of your own is found by the engine alone. */
    private static String first(String name, String text, Contents contents) throws IOException {
        String opening = new Session().opening(name, text, contents.solver());
        return " data-first=\"%s\" data-opening=\"%s\" data-own=\"%s\"".formatted(contents.solver(),
                PageParts.packed(opening), String.join(" ", contents.solvers()));
    }

    /** The text of the Apache License, from the first library that contains it. */
    private static String apache() throws IOException {
        for (URL found : Collections.list(PageBuilder.class.getClassLoader().getResources("META-INF/LICENSE.txt"))) {
            try (InputStream stream = found.openStream()) {
                String text = new String(stream.readAllBytes(), StandardCharsets.UTF_8);
                if (text.contains("Apache License")) {
                    return text;
                }
            }
        }
        throw new IOException("no library has the text of the Apache License");
    }
}
