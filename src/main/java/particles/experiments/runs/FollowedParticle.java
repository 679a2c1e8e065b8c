package particles.experiments.runs;

import java.util.stream.IntStream;
import particles.law.Particles;

/** A particle that is followed by its id, since births and deaths may move it to another index. */
public final class FollowedParticle {
    private final String id;
    private int index = -1;

    /** @param id its id */
    public FollowedParticle(String id) {
        this.id = id;
    }

    /** @return its present index; -1 if there is no such particle, or no more */
    public int in(Particles particles) {
        if (index < 0 || index >= particles.count() || !particles.id(index).equals(id)) {
            index = IntStream.range(0, particles.count()).filter(i -> particles.id(i).equals(id)).findFirst()
                    .orElse(-1);
        }
        return index;
    }
}
