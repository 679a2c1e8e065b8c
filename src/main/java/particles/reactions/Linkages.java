package particles.reactions;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import particles.law.Particles;

/** The linkages of a system: the sets of particles that rods and wires connect. */
final class Linkages {
    private final List<Linkage> all = new ArrayList<>();
    private int[] linkageOf = {};                       // by particle; -1 for none

    /** Finds the linkages that the rows form. */
    void arrange(ConstraintRows rows, Particles particles) {
        all.clear();
        linkageOf = new int[particles.count()];
        Arrays.fill(linkageOf, -1);
        for (int[] part : new RowGraph(rows, particles).parts()) {
            Linkage linkage = new Linkage(rows, part, particles);
            for (int i : linkage.particles()) {
                linkageOf[i] = all.size();
            }
            all.add(linkage);
        }
    }

    int count() {
        return all.size();
    }

    Linkage get(int l) {
        return all.get(l);
    }

    boolean holds(int particle) {
        return particle < linkageOf.length && linkageOf[particle] >= 0;
    }

    /** The linkage of a particle on a rod or wire. */
    Linkage of(int particle) {
        return all.get(linkageOf[particle]);
    }
}
