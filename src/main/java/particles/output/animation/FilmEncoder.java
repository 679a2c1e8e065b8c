package particles.output.animation;

import org.jcodec.codecs.h264.H264Encoder;
import org.jcodec.codecs.h264.encode.RateControl;
import org.jcodec.codecs.h264.io.model.SeqParameterSet;
import org.jcodec.codecs.h264.io.model.SliceType;
import org.jcodec.codecs.h264.io.model.VUIParameters;
import org.jcodec.common.model.Size;

/** The library's H.264 encoder, with one quality for all frames and the colour standard named in the stream. */
final class FilmEncoder extends H264Encoder {
    /**
     * The quantiser, from 0 to 51; each 6 double the steps of colours. At 20 the sky has a tint in places, at 12 it has
     * none.
     */
    private static final int QUANTISER = 12;
    /** Numbers in H.264's tables of primaries, transfer curves and matrices (Annex E): BT.709, and BT.601's matrix. */
    private static final int BT709 = 1;
    private static final int BT601 = 6;
    private static final int UNSPECIFIED_FORMAT = 5;

    FilmEncoder() {
        super(new SteadyQuality());
    }

    /** Adds the colour standard; without it, players guess it by the size of the picture. */
    @Override
    public SeqParameterSet initSPS(Size size) {
        SeqParameterSet parameters = super.initSPS(size);
        int blocks = (parameters.picWidthInMbsMinus1 + 1) * (parameters.picHeightInMapUnitsMinus1 + 1);
        parameters.levelIdc = blocks <= 8192 ? 40 : blocks <= 36_864 ? 51 : 60;     // Table A-1: frame size by level
        VUIParameters usability = new VUIParameters();
        usability.videoSignalTypePresentFlag = true;
        usability.videoFormat = UNSPECIFIED_FORMAT;
        usability.videoFullRangeFlag = false;
        usability.colourDescriptionPresentFlag = true;
        usability.colourPrimaries = BT709;
        usability.transferCharacteristics = BT709;
        usability.matrixCoefficients = BT601;
        parameters.vuiParams = usability;
        return parameters;
    }

    /** Rate control with constant quality: frames of a still scene are small, those of a wild one large. */
    private static final class SteadyQuality implements RateControl {
        @Override
        public int startPicture(Size size, int maxSize, SliceType sliceType) {
            return QUANTISER;
        }

        @Override
        public int initialQpDelta() {
            return 0;
        }

        @Override
        public int accept(int bits) {
            return 0;
        }
    }
}
