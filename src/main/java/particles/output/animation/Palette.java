package particles.output.animation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

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

    /** Some of the different colours, in a box of their own. */
    private record Box(int from, int to, long weight, int axis, int extent) {
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
        int[] cells = new int[counts.length];
        int n = 0;
        for (int cell = 0; cell < counts.length; cell++) {
            if (counts[cell] > 0) {
                cells[n++] = cell;
            }
        }
        List<Box> boxes = new ArrayList<>();
        boxes.add(box(cells, counts, 0, n));
        while (boxes.size() < size) {
            // the box that matters most: long, and of many pixels
            Box widest = boxes.stream().filter(box -> box.to - box.from > 1)
                    .max(Comparator.comparingDouble(box -> box.extent * (double) box.extent * Math.sqrt(box.weight)))
                    .orElse(null);
            if (widest == null) {
                break;
            }
            boxes.remove(widest);
            cut(cells, counts, widest, boxes);
        }
        return new Palette(boxes.stream().mapToInt(box -> mean(cells, counts, box)).toArray());
    }

    private static int cell(int rgb) {
        return (rgb >> 16 & 255) >> SHIFT << 2 * BITS | (rgb >> 8 & 255) >> SHIFT << BITS | (rgb & 255) >> SHIFT;
    }

    private static int part(int cell, int axis) {
        return cell >> axis * BITS & (1 << BITS) - 1;
    }

    private static Box box(int[] cells, long[] counts, int from, int to) {
        long weight = 0;
        int axis = 0;
        int extent = -1;
        for (int a = 0; a < 3; a++) {
            int low = Integer.MAX_VALUE;
            int high = -1;
            for (int k = from; k < to; k++) {
                low = Math.min(low, part(cells[k], a));
                high = Math.max(high, part(cells[k], a));
            }
            if (high - low > extent) {
                extent = high - low;
                axis = a;
            }
        }
        for (int k = from; k < to; k++) {
            weight += counts[cells[k]];
        }
        return new Box(from, to, weight, axis, extent);
    }

    /** Cuts a box in two, with about half of the weight on either side. */
    private static void cut(int[] cells, long[] counts, Box box, List<Box> boxes) {
        int axis = box.axis();
        int[] sorted = Arrays.stream(cells, box.from(), box.to()).boxed()
                .sorted(Comparator.comparingInt(cell -> part(cell, axis))).mapToInt(Integer::intValue).toArray();
        System.arraycopy(sorted, 0, cells, box.from(), sorted.length);
        long half = 0;
        int middle = box.from();
        while (middle < box.to() - 1 && (middle == box.from() || half < box.weight() / 2)) {
            half += counts[cells[middle++]];
        }
        boxes.add(box(cells, counts, box.from(), middle));
        boxes.add(box(cells, counts, middle, box.to()));
    }

    private static int mean(int[] cells, long[] counts, Box box) {
        int rgb = 0;
        for (int axis = 0; axis < 3; axis++) {
            double sum = 0;
            for (int k = box.from(); k < box.to(); k++) {
                sum += counts[cells[k]] * ((part(cells[k], axis) << SHIFT) + (1 << SHIFT) / 2.0);
            }
            rgb |= (int) (sum / box.weight()) << 8 * axis;
        }
        return rgb;
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
