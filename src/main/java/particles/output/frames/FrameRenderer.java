package particles.output.frames;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Optional;
import particles.law.Sphere;
import particles.output.painters.BlobPainter;
import particles.output.painters.DrawnSizes;
import particles.output.painters.FrameState;
import particles.output.painters.GlowPainter;
import particles.output.painters.OpaquePainter;
import particles.output.painters.TrailPainter;
import particles.output.painters.VisibilityFilter;
import particles.output.raster.Backdrop;
import particles.output.raster.Backdrop.Foreground;
import particles.output.raster.CameraProjection;
import particles.output.raster.Colours;
import particles.output.raster.Lighting;
import particles.output.raster.Raster;
import particles.output.raster.RoundShapes;
import particles.output.raster.ShadowMap;
import particles.output.raster.Sky;
import particles.view.Camera;
import particles.view.ParticleStyle;
import particles.view.RenderOptions;
import particles.view.Scenery;

/**
 * Software renderer of frames, without a screen: surfaces shaded on both sides, springs coloured by their strain,
 * particles in their style, on planes with a grid and soft shadows under a sky. For one thread at a time.
 */
public final class FrameRenderer {
    /** A picture, its samples, the layers of trails or light, and the compressed file. */
    private static final int BYTES_PER_PIXEL = 60;

    private final FrameSetup stage;
    private final BufferedImage image;
    private final int[] pixels;
    private final RoundShapes shapes;
    private final CameraProjection view;
    private final VisibilityFilter shown;
    // only the layers that the settings need
    private final Optional<BlobPainter> blobs;
    private final Optional<GlowPainter> glow;
    private final Optional<TrailPainter> trails;
    private final Optional<FrameMarks> marks;
    private final Optional<FrameText> text;
    // set by the first frame
    private DrawnSizes sizes;
    private Backdrop backdrop;
    private OpaquePainter opaque;
    private Optional<ShadowMap> shadows;
    private Optional<OpaquePainter> seenByLamp;

    /**
     * @param stage    the settings of the frames
     * @param width    the width of the pictures (pixels)
     * @param height   the height of the pictures (pixels)
     * @param decimals the number of decimals of the time in the pictures
     * @throws IllegalArgumentException if the size or the camera cannot be
     */
    public FrameRenderer(FrameSetup stage, int width, int height, int decimals) {
        this(stage, width, height, Optional.of(new FrameText(stage, width, height, decimals)));
    }

    /** @param text the words in the pictures, if there are any */
    public FrameRenderer(FrameSetup stage, int width, int height, Optional<FrameText> text) {
        if (width < 16 || height < 16 || (long) width * height > 40_000_000) {
            throw new IllegalArgumentException("pictures of " + width + " x " + height
                    + " pixels; from 16 x 16 to 40 million are possible");
        }
        this.stage = stage;
        image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        pixels = ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
        view = new CameraProjection(stage.camera(), width, height);
        shapes = new RoundShapes(new Raster(width, height), new CameraProjection(stage.camera(),
                Raster.SAMPLES * width, Raster.SAMPLES * height), new Lighting(view, stage.camera().up()));
        shown = new VisibilityFilter(stage.look(), stage.scenery().surfaces());
        blobs = style().kind() == ParticleStyle.Kind.BLOBS
                ? Optional.of(new BlobPainter(stage.look().colours().particle())) : Optional.empty();
        glow = style().kind() == ParticleStyle.Kind.GLOW ? Optional.of(new GlowPainter(style().ageColours(), view))
                : Optional.empty();
        trails = style().longestTrail() > 0 ? Optional.of(new TrailPainter(view, style().trail())) : Optional.empty();
        marks = style().arrows() > 0 || !style().marks().isEmpty() ? Optional.of(new FrameMarks(view, stage.look()))
                : Optional.empty();
        this.text = text;
    }

    /**
     * A renderer of the same pictures for another thread; the first one asked for is this one.
     *
     * @param opening the first frame, which decides the sizes of balls and the background
     */
    synchronized FrameRenderer another(FrameState opening) {
        if (backdrop == null) {
            prepare(opening);
            return this;
        }
        FrameRenderer other = new FrameRenderer(stage, view.width, view.height, text);
        other.prepare(sizes, backdrop);
        return other;
    }

    /** @return about the memory that a renderer takes (bytes) */
    long bytes() {
        return (long) BYTES_PER_PIXEL * pixels.length;
    }

    /** @return the drawing style of particles */
    ParticleStyle style() {
        return stage.look().style();
    }

    /** @return the pixels, 0xRRGGBB row by row, valid until the next call */
    public int[] render(FrameState state) {
        if (backdrop == null) {
            prepare(state);
        }
        return label(state, draw(state));
    }

    /** Draws a frame without its text, and returns whether a spring is visible whose colour shows its strain. */
    boolean draw(FrameState state) {
        shapes.raster().clear();
        blobs.ifPresent(painter -> painter.build(state, shown, sizes.ball(), view.viewHeight / view.height));
        boolean strained = opaque.paint(state, blobs);
        shadows.ifPresent(map -> castShadows(map, state));
        compose();
        Foreground drawn = new Foreground(shapes.raster(), backdrop);
        trails.ifPresent(layer -> layer.paint(state, shown, stage.look().colours().particle(), drawn, pixels));
        glow.ifPresent(layer -> layer.paint(state, shown, sizes.ball(), drawn, pixels));
        return strained;
    }

    /** Adds the text, and returns the pixels. */
    int[] label(FrameState state, boolean withStrain) {
        if (text.isPresent() || marks.isPresent()) {
            Graphics2D g = image.createGraphics();
            marks.ifPresent(layer -> layer.draw(g, state, sizes.ball()));
            text.ifPresent(words -> words.draw(g, state, withStrain));
            g.dispose();
        }
        return pixels;
    }

    /** @return the background without shadows, after the last frame */
    public int[] renderBackdrop() {
        backdrop.paint(pixels, Optional.empty());
        return pixels;
    }

    private void prepare(FrameState state) {
        DrawnSizes drawn = DrawnSizes.of(state, stage.look(), view.viewHeight);
        prepare(drawn, new Backdrop(view, shapes.lighting(), stage.scenery(), Sky.of(stage.look()), stage.camera(),
                drawn.reach(state, stage.look(), shown)));
    }

    private void prepare(DrawnSizes drawn, Backdrop behind) {
        sizes = drawn;
        backdrop = behind;
        opaque = painter(shapes);
        shadows = behind.newShadows();
        seenByLamp = shadows.map(map -> painter(map.getShapes()));
    }

    /** What the lamp sees is in the light, and hides from it what lies behind. */
    private void castShadows(ShadowMap map, FrameState state) {
        map.clear();
        seenByLamp.orElseThrow().paint(state, blobs);
        RoundShapes lamp = map.getShapes();
        for (Sphere sphere : stage.scenery().spheres()) {
            if (!sphere.hollow()) {
                CameraProjection.Place place = lamp.view().place(sphere.centre());
                lamp.ball(place, place.scale() * sphere.radius(), sphere.radius(), 0);
            }
        }
        map.blur();
    }

    private OpaquePainter painter(RoundShapes camera) {
        return OpaquePainter.of(camera, stage.look(), stage.scenery(), stage.camera().target(), sizes, shown);
    }

    /**
     * Computes each pixel as the mean of its samples; empty samples, and those behind a plane, show the background.
     */
    private void compose() {
        backdrop.paint(pixels, shadows);
        Raster raster = shapes.raster();
        for (int y = raster.firstRow(); y < raster.endRow(); y++) {
            for (int x = raster.firstColumn(); x < raster.endColumn(); x++) {
                int p = y * view.width + x;
                float behind = backdrop.near(p);
                int at = Raster.SAMPLES * (y * raster.width + x);
                pixels[p] = Colours.mean(k -> {
                    int sample = at + (k >> 1) * raster.width + (k & 1);
                    return raster.near[sample] > behind ? raster.colour[sample] : pixels[p];
                });
            }
        }
    }

    /**
     * The fixed settings of all frames of a run: everything but the moving particles and springs.
     *
     * @param camera   the camera
     * @param look     the render options
     * @param scenery  the things besides particles and springs
     * @param title    the scene's title, at the top; may be empty
     * @param caption  the text below the time, such as the solver and its deltaT; may be empty
     */
    public record FrameSetup(Camera camera, RenderOptions look, Scenery scenery, String title, String caption) {
    }
}
