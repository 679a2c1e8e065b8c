package particles.app;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import particles.effects.EffectContext;
import particles.effects.EffectKind;
import particles.law.PerParticleEffect;
import particles.spec.Values;

/**
 * A force of 0 that a scene names; it prints one line when a thread other than the caller's evaluates it. The caller
 * waits in later parts of the particles until another thread has come, or two seconds in all: a machine may be busy.
 */
public final class ThreadWitness implements PerParticleEffect {
    /** The first word of the line. */
    static final String HELPED = "helped";

    private final AtomicBoolean said = new AtomicBoolean();
    private final AtomicInteger sleeps = new AtomicInteger();

    @Override
    public String getName() {
        return "witness";
    }

    @Override
    public void addForces(double[] state, double time, double[] force, int from, int to) {
        String thread = Thread.currentThread().getName();
        if (thread.startsWith("ForkJoinPool") && !said.getAndSet(true)) {
            System.out.println(HELPED + " " + thread);
        }
        while (from > 0 && !said.get() && sleeps.getAndIncrement() < 2000) {
            LockSupport.parkNanos(1_000_000);
        }
    }

    /** The law in a scene: {@code - particles.app.ThreadWitness}. */
    public static final class Keys extends EffectKind {
        public Keys() {
            super(ThreadWitness.class.getName(), "A force of 0.");
        }

        @Override
        public void build(Values values, EffectContext scene) {
            scene.add(new ThreadWitness());
        }
    }
}
