package particles.output.charts;

import java.awt.Color;
import java.util.Optional;

/**
 * The colours of energy charts: total energy, work that drives the system, all other work, such as that of dampers and
 * bounces, and numerical error.
 */
final class EnergyColour {
    static final Color TOTAL = new Color(0x000000);
    static final Color DRIVEN = new Color(0x6a3d9a);
    static final Color OTHER = new Color(0x2f7f8f);
    static final Color ERROR = new Color(0xb3261e);

    private EnergyColour() {
    }

    /**
     * @param series a series' name
     * @return its colour, if it is one of these
     */
    static Optional<Color> of(String series) {
        if (series.startsWith("work: ")) {
            boolean drives = series.endsWith("(driven)") || series.equals("work: moving anchors");
            return Optional.of(drives ? DRIVEN : OTHER);
        }
        return series.startsWith("total") ? Optional.of(TOTAL)
                : series.equals("numerical error") ? Optional.of(ERROR) : Optional.empty();
    }
}
