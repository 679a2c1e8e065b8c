package particles.lab;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.DeflaterInputStream;

/**
 * Assembles the page: one file with an engine that runs or replays scenes, the libraries, the scenes, and the licences
 * of all. The libraries and our own files are resources that only the tasks have which write pages.
 */
public final class PageParts {
    private static final String JARS = "META-INF/resources/webjars/";
    private static final String THREE = JARS + "three/0.181.1/";
    private static final String UPLOT = JARS + "uplot/1.6.30/";
    private static final String CODEMIRROR = JARS + "codemirror/5.65.18/";
    private static final String OWN = "particles/lab/page/";
    private static final String BETWEEN_LICENCES = "\n----\n\n";

    /** The scripts of the page that import each other, in an order in which each comes after its imports. */
    private static final List<String> OWN_MODULES = List.of("dom", "equations", "packing", "address", "gallery", "keys",
            "camera", "sky", "blobs", "glow", "marks", "opening", "structure", "tubes", "scenery", "surface", "trails",
            "view", "plots", "bars", "editor", "parameters", "saving", "settings", "panels", "phase", "nearest",
            "player", "stability", "hand", "builder", "inspector", "lecture", "main");
    private static final Pattern PLACE = Pattern.compile("<!--\\{(\\w+)}-->");

    private PageParts() {
    }

    /** @return whether the libraries and our own files are here: only the tasks that write pages have them */
    public static boolean areHere() {
        return Stream.of(OWN + "index.html", THREE + "LICENSE").allMatch(resource ->
                PageParts.class.getClassLoader().getResource(resource) != null);
    }

    /**
     * @param engine   the functions that the page's worker calls
     * @param scenes   the scripts of the scenes
     * @param licences the licences of what is in the engine
     * @return the page
     * @throws IOException if a part cannot be read
     */
    public static String page(String engine, String scenes, List<String> licences) throws IOException {
        Map<String, String> parts = Map.of(
                "style", read(UPLOT + "dist/uPlot.min.css", CODEMIRROR + "lib/codemirror.css", OWN + "lab.css"),
                "engine", script(" type=\"text/plain\" id=\"engine\"", packed(engine + own("worker.js"))),
                "scenes", scenes,
                "stations", script(" type=\"application/json\" id=\"stations\"", own("stations.json")),
                "libraries", script("", read(UPLOT + "dist/uPlot.iife.min.js"))
                        + script("", read(CODEMIRROR + "lib/codemirror.js", CODEMIRROR + "mode/yaml/yaml.js")),
                "modules", modules(),
                "texts", script("", own("texts.js")),
                "starter", script("", own("starter.js")), "loader", script("", own("loader.js")),
                "licences", Stream.concat(Stream.of("three.js\n\n" + read(THREE + "LICENSE"),
                        "uPlot\n\n" + read(UPLOT + "LICENSE"), "CodeMirror\n\n" + read(CODEMIRROR + "LICENSE")),
                        licences.stream()).map(PageParts::escaped).collect(Collectors.joining(BETWEEN_LICENCES)));
        return PLACE.matcher(own("index.html"))
                .replaceAll(place -> Matcher.quoteReplacement(parts.get(place.group(1))));
    }

    /** @return one of our own files */
    public static String own(String name) throws IOException {
        return read(OWN + name);
    }

    /**
     * @param name       the scene file's name
     * @param text       its text
     * @param attributes further ones of the script
     * @return its script
     */
    public static String scene(String name, String text, String attributes) {
        return script(" type=\"text/plain\" class=\"scene\" data-name=\"" + escaped(name) + '"' + attributes, text);
    }

    /** @return a text, compressed, as base64: the page stays small although the engine is large */
    public static String packed(String text) throws IOException {
        return Base64.getEncoder().encodeToString(new DeflaterInputStream(
                new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8))).readAllBytes());
    }

    private static String modules() throws IOException {
        StringBuilder all = new StringBuilder(module("./three.core.min.js", THREE + "build/three.core.min.js"))
                .append(module("three", THREE + "build/three.module.min.js"))
                .append(module("orbit", THREE + "examples/jsm/controls/OrbitControls.js"));
        for (String name : OWN_MODULES) {
            all.append(module("./" + name + ".js", OWN + name + ".js"));
        }
        return all.toString();
    }

    private static String module(String name, String file) throws IOException {
        return script(" type=\"text/plain\" class=\"module\" data-name=\"" + name + '"', read(file));
    }

    /** A script; its text may not hold the end of a script. */
    private static String script(String attributes, String text) {
        String open = text.replace("</script", "<\\/script").replace("<!--", "<\\!--");
        return "<script" + attributes + ">" + open + "</script>\n";
    }

    /** @return a text as an attribute's value or an element's content */
    public static String escaped(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace("\"", "&quot;");
    }

    /** @return the text of resources, one after the other */
    public static String read(String... resources) throws IOException {
        StringBuilder text = new StringBuilder();
        for (String resource : resources) {
            try (InputStream stream = PageParts.class.getClassLoader().getResourceAsStream(resource)) {
                if (stream == null) {
                    throw new IOException("the page's part " + resource + " is missing");
                }
                text.append(new String(stream.readAllBytes(), StandardCharsets.UTF_8));
            }
        }
        return text.toString();
    }
}
