package particles.effects;

import java.util.List;

/** The catalogue of all effects that scenes can name. */
public final class EffectCatalog {
    /** All effects in the order in which they are built: wind comes before drag, which uses it. */
    public static final List<EffectKind> ALL = List.of(
            new Gravity.Keys(),
            new Push.Keys(),
            new GustyWind.Keys(),
            new TurbulentWind.Keys(),
            new Vortex.Keys(),
            new AirDrag.LinearKeys(),
            new AirDrag.QuadraticKeys(),
            new PointAttraction.Keys(),
            new Gravitation.Keys(),
            new MagneticField.Keys(),
            new MuscleKeys(),
            new Cohesion.Keys(),
            new Repulsion.Keys(),
            new Penalty.PlaneKeys(),
            new Penalty.SphereKeys());

    private EffectCatalog() {
    }
}
