package particles.output.frames;

import deSolvers.text.Digits;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.font.FontRenderContext;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import particles.output.files.FontCheck;
import particles.output.frames.FrameRenderer.FrameSetup;
import particles.output.painters.FrameState;
import particles.output.raster.Colours;
import particles.output.raster.Sky;

/**
 * The text in a picture: the scene's title, time and solver, and the scale of strain. Without a font there is none.
 */
final class FrameText {
    /** The most decimals of a time that is shown exactly, since steps are shorter than frames. */
    private static final int MOST_DECIMALS = 6;
    /** The opacity of the ground behind text, of 255: the picture shows through as a shade. */
    private static final int BACKING = 220;

    private final FrameSetup stage;
    private final int width;
    private final int height;
    private final Sky sky;
    private final float unit;
    private final int decimals;

    /** @param decimals the number of decimals of the time (s), enough to distinguish two frames */
    FrameText(FrameSetup stage, int width, int height, int decimals) {
        this.stage = stage;
        this.width = width;
        this.height = height;
        this.sky = Sky.of(stage.look());
        this.unit = Math.max(0.5f, height / 720f);
        this.decimals = decimals;
    }

    void draw(Graphics2D g, FrameState state, boolean withStrain) {
        if (!FontCheck.isAvailable()) {
            return;
        }
        TextLine.smooth(g);
        if (!state.notes().isEmpty()) {
            drawBacking(g, boxes(state, withStrain));
        }
        if (withStrain) {
            drawScale(g);
        }
        lines(state, withStrain).forEach(line -> line.draw(g));
    }

    /** Draws a ground behind the text in each corner, since a blow-up spreads over the whole picture. */
    private void drawBacking(Graphics2D g, List<Rectangle2D> boxes) {
        Map<List<Boolean>, Rectangle2D> corners = boxes.stream().collect(Collectors.toMap(
                box -> List.of(box.getCenterX() < width / 2.0, box.getCenterY() < height / 2.0), box -> box,
                Rectangle2D::createUnion));
        double room = 8 * unit;
        Color halo = sky.text().halo();
        g.setColor(new Color(halo.getRed(), halo.getGreen(), halo.getBlue(), BACKING));
        corners.values().forEach(all -> g.fill(new RoundRectangle2D.Double(all.getX() - room, all.getY() - room,
                all.getWidth() + 2 * room, all.getHeight() + 2 * room, 2 * room, 2 * room)));
    }

    /** @return the rectangles that words and the scale of strain take up (pixels); bodies should stay clear of them */
    List<Rectangle2D> boxes(FrameState state, boolean withStrain) {
        List<Rectangle2D> boxes = new ArrayList<>();
        lines(state, withStrain).forEach(line -> boxes.add(line.box()));
        if (withStrain) {
            boxes.add(scale());
        }
        return boxes;
    }

    private List<TextLine> lines(FrameState state, boolean withStrain) {
        float margin = 26 * unit;
        List<TextLine> lines = new ArrayList<>();
        Font large = FontCheck.font(Font.BOLD, 24 * unit);
        Font small = FontCheck.font(Font.PLAIN, 18 * unit);
        add(lines, stage.title(), large, sky.text().ink(), margin, margin + 17 * unit);
        float y = margin + 17 * unit;
        for (String note : state.notes()) {
            boolean first = note.equals(state.notes().get(0));
            y += (first ? 36 : 28) * unit;
            add(lines, note, first ? large : small, first ? sky.text().warning() : sky.text().soft(), margin, y);
        }
        add(lines, "t = " + seconds(state) + " s", FontCheck.font(Font.PLAIN, 24 * unit), sky.text().ink(), margin,
                height - margin - 29 * unit);
        String arrows = stage.look().style().arrows() > 0 ? "arrows: velocity" : "";
        String between = stage.caption().isEmpty() || arrows.isEmpty() ? "" : "; ";
        add(lines, stage.caption() + between + arrows, small, sky.text().soft(), margin, height - margin);
        if (withStrain) {
            addScale(lines, height - margin);
        }
        return lines;
    }

    private static void add(List<TextLine> lines, String text, Font font, Color colour, double x, double y) {
        if (!text.isEmpty()) {
            lines.add(new TextLine(text, font, colour, x, y));
        }
    }

    String seconds(FrameState state) {
        if (decimals > MOST_DECIMALS) {
            return Digits.few(state.time());              // an atom, for example
        }
        BigDecimal time = BigDecimal.valueOf(state.time());
        BigDecimal exact = time.setScale(MOST_DECIMALS, RoundingMode.HALF_EVEN).stripTrailingZeros();
        boolean between = !state.notes().isEmpty() && exact.scale() > decimals;
        return (between ? exact : time.setScale(decimals, RoundingMode.HALF_EVEN)).toPlainString();
    }

    /** @return the rectangle of the bar, from compressed to stretched */
    private Rectangle2D scale() {
        int length = Math.round(220 * unit);
        int thickness = Math.round(11 * unit);
        return new Rectangle2D.Double(Math.round(width - 26 * unit) - length,
                Math.round(height - 51 * unit) - thickness, length, thickness);
    }

    private void drawScale(Graphics2D g) {
        Rectangle2D bar = scale();
        double range = stage.look().strainRange();
        int length = (int) bar.getWidth();
        for (int k = 0; k < length; k++) {
            g.setColor(new Color(Colours.ofStrain((2.0 * (k + 0.5) / length - 1) * range, range)));
            g.fillRect((int) bar.getX() + k, (int) bar.getY(), 1, (int) bar.getHeight());
        }
    }

    /** Adds the labels of the bar: its ends in per cent, and its quantity. */
    private void addScale(List<TextLine> lines, double y) {
        Rectangle2D bar = scale();
        String percent = Digits.few(100 * stage.look().strainRange());
        List<String> texts = List.of("\u2212" + percent + " %", "strain", "+" + percent + " %");
        Font font = FontCheck.font(Font.PLAIN, 16 * unit);
        for (int k = 0; k < texts.size(); k++) {
            double room = bar.getWidth() - TextLine.width(texts.get(k), font);
            add(lines, texts.get(k), font, sky.text().soft(), bar.getX() + room * k / 2, y);
        }
    }

    /** A line of text in a picture: its left end, and its baseline from the top (pixels). */
    record TextLine(String text, Font font, Color colour, double x, double y) {
        private static final FontRenderContext SMOOTH = new FontRenderContext(null, true, true);

        static void smooth(Graphics2D g) {
            g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
            g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        }

        static double width(String text, Font font) {
            return font.getStringBounds(text, SMOOTH).getWidth();
        }

        /** @return the rectangle that it takes up (pixels) */
        Rectangle2D box() {
            Rectangle2D box = font.getStringBounds(text, SMOOTH);
            return new Rectangle2D.Double(x, y + box.getY(), box.getWidth(), box.getHeight());
        }

        void draw(Graphics2D g) {
            g.setColor(colour);
            g.setFont(font);
            g.drawString(text, (float) x, (float) y);
        }
    }
}
