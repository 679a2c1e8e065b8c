package particles.app.run;

import particles.scene.format.OutputDescription.Video;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Parses the option for the kind of film, with the same names as in scenes. */
final class VideoOption implements ITypeConverter<Video> {
    @Override
    public Video convert(String value) {
        return Video.find(value).orElseThrow(() -> new TypeConversionException("'" + value
                + "' is not a kind of film; allowed: "
                + String.join(", ", Video.names())));
    }
}
