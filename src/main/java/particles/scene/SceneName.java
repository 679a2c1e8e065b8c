package particles.scene;

import java.nio.file.Path;

/**
 * The parts of a scene file's name: {@code 02-one-spring.yaml} has number {@code 02} and bare name {@code one-spring}.
 *
 * @param whole  the name without extension, used for results
 * @param number the digits before the first dash, or empty
 * @param bare   the whole name without the number
 */
public record SceneName(String whole, String number, String bare) {

    /** @return the parts of a scene file's name */
    public static SceneName of(Path file) {
        return of(file.getFileName().toString());
    }

    static SceneName of(String file) {
        String whole = file.replaceFirst("\\.ya?ml$", "");
        if (!whole.matches("\\d+-.+")) {
            return new SceneName(whole, "", whole);
        }
        int dash = whole.indexOf('-');
        return new SceneName(whole, whole.substring(0, dash), whole.substring(dash + 1));
    }

    /** Whether the scene can be called so: by its name, with or without number, or by its number. */
    boolean isCalled(String name) {
        return whole.equals(name) || bare.equals(name)
                || number.length() > 0 && (number.equals(name) || number.replaceFirst("^0+(?=.)", "").equals(name));
    }
}
