package particles.teaching.collection;

import static particles.teaching.collection.EffectSpecimen.right;
import static particles.teaching.collection.Law.each;
import static particles.teaching.collection.Law.law;
import static particles.teaching.collection.Law.pairEnergy;
import static particles.teaching.collection.Law.pairs;
import static particles.teaching.collection.Law.push;
import static particles.teaching.collection.Law.square;
import static particles.teaching.collection.Law.sum;

import java.util.List;
import particles.law.Effect.Trait;

/** Right force laws of kinds that the program has none of; EffectClaimsTest has the check pass all its own. */
final class RightEffects {
    private RightEffects() {
    }

    static List<EffectSpecimen> all() {
        return List.of(
                right("gravity in ranges", p -> new WrongEffects.InRanges(p, false, 0)),
                right("downhill", p -> law(Trait.CONSERVATIVE, Trait.TRANSLATION_INVARIANT).force(each(p, (s, f, x, m)
                        -> {
                            f[x + 3] += m * 9.81 * 0.5;
                            f[x + 4] -= m * 9.81 * 0.866;
                        })).energy(sum(p, (s, x, m) -> m * 9.81 * (0.866 * s[x + 1] - 0.5 * s[x])))),
                right("n-body, fixed ones left out", p -> law(Trait.INTERNAL, Trait.CONSERVATIVE,
                        Trait.TRANSLATION_INVARIANT, Trait.ROTATION_INVARIANT)
                        .force(pairs(p, -1, (r, mm) -> 3 * mm * r / Math.pow(r * r + 0.01, 1.5)))
                        .energy(pairEnergy(p, (r, mm) -> -3 * mm / Math.sqrt(r * r + 0.01)))
                        .times(i -> p.isFixed(i) ? 0 : 1)),
                right("molecules", p -> law(Trait.INTERNAL, Trait.CONSERVATIVE, Trait.ROTATION_INVARIANT)
                        .force(pairs(p, -1, (r, mm) -> -24 * (2 * Math.pow(r, -13) - Math.pow(r, -7))))
                        .energy(pairEnergy(p, (r, mm) -> 4 * (Math.pow(r, -12) - Math.pow(r, -6))))),
                right("rubber bands, slack when short", p -> law(Trait.INTERNAL, Trait.CONSERVATIVE)
                        .force(pairs(p, -1, (r, mm) -> 20 * Math.max(0, r - 1.2)))
                        .energy(pairEnergy(p, (r, mm) -> 10 * Math.pow(Math.max(0, r - 1.2), 2)))),
                right("a beam: bending, three at a time", p -> law(Trait.INTERNAL, Trait.CONSERVATIVE,
                        Trait.TRANSLATION_INVARIANT).force(RightEffects::bend).energy((s, t) -> {
                            double sum = 0;
                            for (int k = 0; k + 12 < s.length; k += k % 6 == 2 ? 4 : 1) {
                                sum += 2 * Math.pow(s[k] - 2 * s[k + 6] + s[k + 12], 2);
                            }
                            return sum;
                        })),
                right("centrifugal, with a negative energy", p -> law(Trait.CONSERVATIVE)
                        .force(each(p, (s, f, x, m) -> push(f, x, 3 * m, s, x)))
                        .energy(sum(p, (s, x, m) -> -1.5 * m * square(s, x)))),
                right("a wall with nothing near it", p -> law(Trait.CONSERVATIVE)
                        .force(each(p, (s, f, x, m) -> f[x + 3] += Math.max(0, -10 - s[x])))
                        .energy(sum(p, (s, x, m) -> Math.pow(Math.max(0, -10 - s[x]), 2) / 2))));
    }

    private static void bend(double[] s, double t, double[] f) {
        for (int k = 0; k + 12 < s.length; k += k % 6 == 2 ? 4 : 1) {
            double pull = 4 * (s[k] - 2 * s[k + 6] + s[k + 12]);
            f[k + 3] -= pull;
            f[k + 9] += 2 * pull;
            f[k + 15] -= pull;
        }
    }
}
