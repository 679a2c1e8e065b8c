package particles.lab.compile;

import java.awt.Image;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
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
import javax.imageio.ImageIO;
import particles.lab.LabBuilder;
import particles.lab.PageParts;

/** Builds the lab's page: compiles the classes, and adds the scenes with their pictures. */
public final class PageBuilder implements LabBuilder {
    private static final int WIDTH = 320;
    private static final int HEIGHT = 180;

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
            String first = file.equals(contents.first())
                    ? " data-first=\"" + PageParts.escaped(contents.solver().orElse("")) + '"' : "";
            String name = file.getFileName().toString();
            Path drawn = file.resolveSibling("pictures").resolve(name.replace(".yaml", ".png"));
            String picture = Files.exists(drawn)
                    ? " data-picture=\"" + Base64.getEncoder().encodeToString(small(drawn)) + '"' : "";
            all.append(PageParts.scene(name, Files.readString(file), first + picture));
        }
        return all + PageParts.students(contents.solvers());
    }

    /** A picture as large as the page shows it: all of them in full size would be half of the page. */
    private static byte[] small(Path file) throws IOException {
        BufferedImage small = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        Image picture = ImageIO.read(file.toFile()).getScaledInstance(WIDTH, HEIGHT, Image.SCALE_AREA_AVERAGING);
        small.createGraphics().drawImage(picture, 0, 0, null);
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageIO.write(small, "png", png);
        return png.toByteArray();
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
