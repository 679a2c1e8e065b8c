package particles.output.animation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.IntSummaryStatistics;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Colour quantisation: a few colours in place of many, chosen by the median cut (P. Heckbert, "Color image quantization
 * for frame buffer display", 1982). Each box is cut where it is longest. Colours are looked up with an ordered dither,
 * the same in every frame, so that things at rest do not flicker.
 */
final class Palette {
    /** The number of bits used of each of red, green and blue. */
    private static final int BITS = 6;
    private static final int SHIFT = 8 - BITS;
    /** The largest change of a colour by the dither, in steps of 1/256. */
    private static final int DITHER = 9;
    private static final int[] BAYER = {
        0, 8, 2, 10,
        12, 4, 14, 6,
        3, 11, 1, 9,
        15, 7, 13, 5};

    private final int[] colours;
    private final int[] nearest = new int[1 << 3 * BITS];

    /** Some of the different colours, in a box of their own that is longest along an axis. */
    private record Box(int[] cells, long weight, int axis, int extent) {
        static Box of(int[] cells, long[] counts) {
            int axis = 0;
            int extent = -1;
            for (int a = 0; a < 3; a++) {
                int along = a;
                IntSummaryStatistics parts = Arrays.stream(cells).map(cell -> part(cell, along)).summaryStatistics();
                if (parts.getMax() - parts.getMin() > extent) {
                    extent = parts.getMax() - parts.getMin();
                    axis = a;
                }
            }
            return new Box(cells, Arrays.stream(cells).mapToLong(cell -> counts[cell]).sum(), axis, extent);
        }

        /** How much it matters to cut it: a long box of many pixels. */
        double importance() {
            return extent * (double) extent * Math.sqrt(weight);
        }

        /** Cuts it in two, with about half of the weight on either side. */
        List<Box> halves(long[] counts) {
            int[] sorted = Arrays.stream(cells).boxed().sorted(Comparator.comparingInt(cell -> part(cell, axis)))
                    .mapToInt(Integer::intValue).toArray();
            long half = 0;
            int middle = 0;
            while (middle < sorted.length - 1 && (middle == 0 || half < weight / 2)) {
                half += counts[sorted[middle++]];
            }
            return List.of(of(Arrays.copyOf(sorted, middle), counts),
                    of(Arrays.copyOfRange(sorted, middle, sorted.length), counts));
        }

        int mean(long[] counts) {
            int rgb = 0;
            for (int a = 0; a < 3; a++) {
                int along = a;
                double sum = Arrays.stream(cells).mapToDouble(cell ->
                        counts[cell] * ((part(cell, along) << SHIFT) + (1 << SHIFT) / 2.0)).sum();
                rgb |= (int) (sum / weight) << 8 * a;
            }
            return rgb;
        }
    }

    private Palette(int[] colours) {
        this.colours = colours;
        Arrays.fill(nearest, -1);
    }

    /**
     * @param rgb    all pixels, 0xRRGGBB
     * @param others colours that will matter in other pictures
     * @param size   the largest number of colours
     */
    static Palette of(int[] rgb, int[] others, int size) {
        long[] counts = new long[1 << 3 * BITS];
        for (int colour : rgb) {
            counts[cell(colour)]++;
        }
        for (int colour : others) {
            counts[cell(colour)] += 1 + rgb.length / 400;
        }
        int[] cells = IntStream.range(0, counts.length).filter(cell -> counts[cell] > 0).toArray();
        List<Box> boxes = new ArrayList<>(List.of(Box.of(cells, counts)));
        while (boxes.size() < size && boxes.stream().anyMatch(box -> box.cells.length > 1)) {
            Box widest = boxes.stream().filter(box -> box.cells.length > 1)
                    .max(Comparator.comparingDouble(Box::importance)).orElseThrow();
            boxes.remove(widest);
            boxes.addAll(widest.halves(counts));
        }
        return new Palette(boxes.stream().mapToInt(box -> box.mean(counts)).toArray());
    }

    private static int cell(int rgb) {
        return (rgb >> 16 & 255) >> SHIFT << 2 * BITS | (rgb >> 8 & 255) >> SHIFT << BITS | (rgb & 255) >> SHIFT;
    }

    private static int part(int cell, int axis) {
        return cell >> axis * BITS & (1 << BITS) - 1;
    }

    /** @return the colours, 0xRRGGBB */
    int[] getColours() {
        return colours.clone();
    }

    /** @return the index of the colour for this one at pixel (x, y) */
    int index(int rgb, int x, int y) {
        int shift = (2 * BAYER[(y & 3) << 2 | x & 3] - 15) * DITHER / 32;
        int red = Math.max(0, Math.min(255, (rgb >> 16 & 255) + shift));
        int green = Math.max(0, Math.min(255, (rgb >> 8 & 255) + shift));
        int blue = Math.max(0, Math.min(255, (rgb & 255) + shift));
        int cell = red >> SHIFT << 2 * BITS | green >> SHIFT << BITS | blue >> SHIFT;
        int index = nearest[cell];
        if (index < 0) {
            index = search(red, green, blue);
            nearest[cell] = index;
        }
        return index;
    }

    private int search(int red, int green, int blue) {
        int best = 0;
        int least = Integer.MAX_VALUE;
        for (int k = 0; k < colours.length; k++) {
            int dr = red - (colours[k] >> 16 & 255);
            int dg = green - (colours[k] >> 8 & 255);
            int db = blue - (colours[k] & 255);
            int distance = 3 * dr * dr + 4 * dg * dg + 2 * db * db;     // eyes see green best and blue worst
            if (distance < least) {
                least = distance;
                best = k;
            }
        }
        return best;
    }
}
