package particles.app.run;

import particles.scene.format.OutputDescription.Video;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads which film is wanted: the names that a scene has for it. */
final class VideoOption implements ITypeConverter<Video> {
    @Override
    public Video convert(String value) {
        return Video.find(value).orElseThrow(() -> new TypeConversionException("'" + value
                + "' is not a kind of film; allowed: "
                + String.join(", ", Video.names())));
    }
}
