package particles.app.run;

import java.nio.file.Path;

/**
 * The name of a scene's file, in its parts: {@code 02-one-spring.yaml} is {@code one-spring}, number {@code 02}.
 *
 * @param whole  without its ending; what results are called by
 * @param number the digits before the first dash, or nothing
 * @param bare   the whole name without the number
 */
public record SceneName(String whole, String number, String bare) {

    public static SceneName of(Path file) {
        String whole = file.getFileName().toString().replaceFirst("\\.ya?ml$", "");
        if (!whole.matches("\\d+-.+")) {
            return new SceneName(whole, "", whole);
        }
        int dash = whole.indexOf('-');
        return new SceneName(whole, whole.substring(0, dash), whole.substring(dash + 1));
    }
}
