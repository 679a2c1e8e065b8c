package particles.scene.format;

import java.util.List;
import java.util.Optional;
import particles.law.Vector3;
import particles.spec.Key;
import particles.spec.MappingType;
import particles.spec.NameType;
import particles.spec.NumberType;
import particles.spec.Values;
import particles.spec.VectorType;
import particles.spec.messages.Problems;
import particles.view.Camera;

/** The keys of a scene's camera. */
public final class CameraFormat {
    private static final String PERSPECTIVE = "perspective";

    static final Key<Vector3> POSITION = VectorType.of("m").required("position", "The position of the camera (m).");
    static final Key<Vector3> TARGET = VectorType.of("m").required("target",
            "The point at the centre of the picture (m).");
    static final Key<Vector3> UP = VectorType.notZero("").withDefault("up", new Vector3(0, 1, 0),
            "The direction that is up in the picture.");
    static final Key<String> PROJECTION = NameType.of("projection", List.of(PERSPECTIVE, "orthographic"))
            .withDefault("projection", PERSPECTIVE,
            "perspective: distant things look smaller; orthographic: parallel lines stay parallel.");
    static final Key<Double> FIELD_OF_VIEW = NumberType.between(1, 170, "degrees").withDefault("fieldOfView", 35.0,
            "The vertical angle of a perspective picture (degrees).");
    static final Key<Double> HEIGHT = NumberType.positive("m").optional("height",
            "The height of an orthographic picture (m); by default the height of a perspective one at the target.");

    static final MappingType TYPE = MappingType.of("the camera", POSITION, TARGET, UP, PROJECTION, FIELD_OF_VIEW,
            HEIGHT);

    private CameraFormat() {
    }

    /** @return the camera with these values, if they have no problem */
    public static Optional<Camera> of(Values values, Problems problems) {
        Vector3 away = values.get(POSITION).minus(values.get(TARGET));
        if (away.length() == 0) {
            return problems.add(values.place(TARGET),
                    "the camera's target is at the camera's position; choose another point");
        }
        if (away.normalized().cross(values.get(UP).normalized()).length() < 1e-6) {
            return problems.add(values.place(UP),
                    "the camera looks along its 'up' direction; give another 'up', such as [0, 0, -1]");
        }
        double halfAngle = StrictMath.toRadians(values.get(FIELD_OF_VIEW)) / 2;
        double height = values.find(HEIGHT).orElse(2 * away.length() * StrictMath.tan(halfAngle));
        return Optional.of(new Camera(values.get(POSITION), values.get(TARGET), values.get(UP),
                values.get(PROJECTION).equals(PERSPECTIVE), values.get(FIELD_OF_VIEW), height));
    }
}
