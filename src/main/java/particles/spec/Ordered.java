package particles.spec;

import java.util.LinkedHashMap;
import java.util.Map;

/** Maps that keep the order in which their entries are written. */
public final class Ordered {
    private Ordered() {
    }

    /**
     * @param keysAndValues keys and values in turn
     * @return a map that can be changed
     */
    public static Map<String, Object> map(Object... keysAndValues) {
        Map<String, Object> map = new LinkedHashMap<>();
        for (int k = 0; k < keysAndValues.length; k += 2) {
            map.put((String) keysAndValues[k], keysAndValues[k + 1]);
        }
        return map;
    }
}
