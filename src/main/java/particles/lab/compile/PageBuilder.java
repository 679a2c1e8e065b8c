package particles.lab.compile;

import java.io.ByteArrayInputStream;
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
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.DeflaterInputStream;
import particles.lab.LabBuilder;

/** Builds the page: one file with the compiled classes, the libraries, the scenes, and the licences of all. */
public final class PageBuilder implements LabBuilder {
    private static final String JARS = "META-INF/resources/webjars/";
    private static final String THREE = JARS + "three/0.181.1/";
    private static final String UPLOT = JARS + "uplot/1.6.30/";
    private static final String CODEMIRROR = JARS + "codemirror/5.65.18/";
    private static final String PAGE = "particles/lab/page/";

    /** The scripts of the page that import each other, in an order in which each comes after its imports. */
    private static final List<String> OWN_MODULES = List.of("dom", "packing", "address", "gallery", "keys", "camera",
            "lines", "marks", "scenery", "view", "plots", "editor", "parameters", "saving", "settings", "panels",
            "stability", "tables", "words", "hand", "inspector", "main");
    private static final Pattern PLACE = Pattern.compile("<!--\\{(\\w+)}-->");

    /** Made without parameters, by its name. */
    public PageBuilder() {
    }

    @Override
    public String build(Contents contents) throws IOException {
        Path folder = Files.createTempDirectory("lab");
        try {
            String engine = EngineCompiler.compile(StudentCompiler.compile(contents, folder), folder);
            return page(contents, engine);
        } finally {
            try (Stream<Path> files = Files.walk(folder)) {
                for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                    Files.delete(file);
                }
            }
        }
    }

    private static String page(Contents contents, String engine) throws IOException {
        Map<String, String> parts = Map.of(
                "style", read(UPLOT + "dist/uPlot.min.css", CODEMIRROR + "lib/codemirror.css", PAGE + "lab.css"),
                "engine", script(" type=\"text/plain\" id=\"engine\"", packed(engine + read(PAGE + "worker.js"))),
                "scenes", scenes(contents),
                "libraries", script("", read(UPLOT + "dist/uPlot.iife.min.js"))
                        + script("", read(CODEMIRROR + "lib/codemirror.js", CODEMIRROR + "mode/yaml/yaml.js")),
                "modules", modules(),
                "loader", script("", read(PAGE + "loader.js")),
                "licences", licences());
        return PLACE.matcher(read(PAGE + "index.html"))
                .replaceAll(place -> Matcher.quoteReplacement(parts.get(place.group(1))));
    }

    private static String scenes(Contents contents) throws IOException {
        StringBuilder all = new StringBuilder();
        for (Path file : contents.scenes()) {
            String first = file.equals(contents.first())
                    ? " data-first=\"" + escaped(contents.solver().orElse("")) + '"' : "";
            String name = file.getFileName().toString();
            Path drawn = file.resolveSibling("pictures").resolve(name.replace(".yaml", ".png"));
            String picture = Files.exists(drawn)
                    ? " data-picture=\"" + Base64.getEncoder().encodeToString(Files.readAllBytes(drawn)) + '"' : "";
            all.append(script(" type=\"text/plain\" class=\"scene\" data-name=\"" + escaped(name) + '"' + first
                    + picture, Files.readString(file)));
        }
        return all + script(" type=\"text/plain\" id=\"students\"", String.join(" ", contents.solvers()));
    }

    /** The page stays small although the compiled classes are large. */
    private static String packed(String text) throws IOException {
        return Base64.getEncoder().encodeToString(new DeflaterInputStream(
                new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8))).readAllBytes());
    }

    private static String modules() throws IOException {
        StringBuilder all = new StringBuilder(module("./three.core.min.js", THREE + "build/three.core.min.js"))
                .append(module("three", THREE + "build/three.module.min.js"))
                .append(module("orbit", THREE + "examples/jsm/controls/OrbitControls.js"));
        for (String name : OWN_MODULES) {
            all.append(module("./" + name + ".js", PAGE + name + ".js"));
        }
        return all.toString();
    }

    private static String module(String name, String file) throws IOException {
        return script(" type=\"text/plain\" class=\"module\" data-name=\"" + name + '"', read(file));
    }

    private static String script(String attributes, String text) {
        return "<script" + attributes + ">" + closed(text) + "</script>\n";
    }

    private static String licences() throws IOException {
        return Stream.of(read(PAGE + "licences.txt"), "three.js\n\n" + read(THREE + "LICENSE"),
                        "uPlot\n\n" + read(UPLOT + "LICENSE"), "CodeMirror\n\n" + read(CODEMIRROR + "LICENSE"),
                        apache())
                .map(PageBuilder::escaped).collect(Collectors.joining("\n----\n\n"));
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

    /** A script's text may not hold the end of a script. */
    private static String closed(String text) {
        return text.replace("</script", "<\\/script").replace("<!--", "<\\!--");
    }

    private static String escaped(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace("\"", "&quot;");
    }

    private static String read(String... resources) throws IOException {
        StringBuilder text = new StringBuilder();
        for (String resource : resources) {
            try (InputStream stream = PageBuilder.class.getClassLoader().getResourceAsStream(resource)) {
                if (stream == null) {
                    throw new IOException("the page's part " + resource + " is missing");
                }
                text.append(new String(stream.readAllBytes(), StandardCharsets.UTF_8));
            }
        }
        return text.toString();
    }
}
