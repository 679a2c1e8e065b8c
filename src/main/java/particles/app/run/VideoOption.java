package particles.app.run;

import particles.scene.format.OutputDescription;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Checks the option for the kind of film, with the same names as in scenes. */
final class VideoOption implements ITypeConverter<String> {
    @Override
    public String convert(String value) {
        if (!OutputDescription.FILMS.contains(value)) {
            throw new TypeConversionException("'" + value + "' is not a kind of film; allowed: "
                    + String.join(", ", OutputDescription.FILMS));
        }
        return value;
    }
}
