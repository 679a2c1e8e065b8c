package particles.lab.compile;

import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import particles.effects.EffectCatalog;
import particles.effects.EffectKind;
import particles.effects.springs.SpringForce;
import particles.lab.PageParts;
import particles.spec.JsonText;

/** The formulas of solvers and force laws, as their own javadoc has them: the text between the first pre tags. */
final class Formulas {
    private static final Pattern FORMULA = Pattern.compile("(?s)<pre>\n(.*?)\n \\* </pre>");

    private Formulas() {
    }

    /** @return a script with the formulas by name; the sources of the classes are resources beside the page's files */
    static String script() throws IOException {
        Map<String, Object> all = JsonText.map("springs", of(SpringForce.class));
        for (EffectKind kind : EffectCatalog.ALL) {
            all.put(kind.getName(), of(Optional.<Class<?>>ofNullable(kind.getClass().getEnclosingClass())
                    .orElse(kind.getClass())));
        }
        for (SolverInfo solver : SolverCatalog.all()) {
            all.put(solver.name(), of(SolverCatalog.create(solver.name()).getClass()));
        }
        return "<script type=\"application/json\" id=\"formulas\">" + JsonText.compact(all) + "</script>\n";
    }

    private static String of(Class<?> type) throws IOException {
        String source = PageParts.read(type.getName().replace('.', '/') + ".java");
        Matcher formula = FORMULA.matcher(source.substring(0, source.indexOf("\n */\n")));
        return formula.find() ? formula.group(1).replaceAll("(?m)^ \\*", "").replace("&gt;", ">").replace("&lt;", "<")
                .stripIndent() : "";
    }
}
