package particles.scene.checks;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import particles.effects.SharedKeys;
import particles.scene.format.RenderFormat;
import particles.scene.format.SceneFormat;
import particles.scene.parts.ParticleDescription;
import particles.scene.parts.ParticleIndex;
import particles.scene.parts.RuleKind;
import particles.scene.parts.ShapeDescription;
import particles.spec.Values;
import particles.spec.messages.Problems;
import particles.view.ParticleStyle;
import particles.view.ParticleStyle.ParticleMark;
import particles.view.RenderOptions;

/** Draws balls with their radius: that of an effect, or their own. A shape's mark is that of its particles. */
final class LookCheck {
    private LookCheck() {
    }

    /** @return the look of a scene without problems, which may leave it out */
    static RenderOptions of(Values scene, ParticleIndex index) {
        RenderOptions look = RenderFormat.of(scene.mapping(SceneFormat.LOOK));
        DoubleStream ofEffects = scene.list(SceneFormat.EFFECTS).stream()
                .mapToDouble(effect -> effect.kind().ballRadius(effect.values()));
        DoubleStream ofRules = scene.list(SceneFormat.RULES).stream().filter(RuleKind::hasBalls)
                .mapToDouble(rule -> rule.values().get(SharedKeys.BALL_RADIUS));
        double radius = look.particleRadius() > 0 ? look.particleRadius()
                : DoubleStream.concat(ofEffects, ofRules).filter(own -> own > 0).findFirst().orElse(0);
        Map<String, ParticleMark> marks = new LinkedHashMap<>();
        Stream.concat(index.getParticles().stream(), index.getShapes().stream().filter(shape ->
                shape.radius().isPresent()).flatMap(ShapeDescription::particles)).forEach(particle ->
                particle.radius().ifPresent(own -> marks.put(particle.id(),
                        new ParticleMark(particle.id(), Optional.empty(), own, ""))));
        for (ParticleMark mark : look.style().marks()) {
            Stream<String> ids = index.shape(mark.particle()).map(shape -> shape.particles()
                    .map(ParticleDescription::id)).orElse(Stream.of(mark.particle()));
            ids.forEach(id -> {
                double own = marks.containsKey(id) ? marks.get(id).radius() : 0;
                marks.put(id, new ParticleMark(id, mark.colour(), mark.radius() > 0 ? mark.radius() : own,
                        mark.label()));
            });
        }
        ParticleStyle style = look.style();
        return look.withBalls(radius, new ParticleStyle(style.kind(), style.ageColours(), style.trail(), style.night(),
                style.arrows(), List.copyOf(marks.values())));
    }

    static void check(Values scene, Problems problems, KnownParticles known) {
        scene.find(SceneFormat.LOOK).ifPresent(look -> {
            RenderFormat.check(look, problems);
            look.list(RenderFormat.MARKS).stream()
                    .filter(mark -> mark.find(RenderFormat.MARKED).flatMap(known.getIndex()::shape).isEmpty())
                    .forEach(mark -> known.has(mark, RenderFormat.MARKED));
        });
    }
}
