package particles.lab.compile;

import java.util.Set;
import org.teavm.model.BasicBlock;
import org.teavm.model.ClassHolder;
import org.teavm.model.ClassHolderTransformer;
import org.teavm.model.ClassHolderTransformerContext;
import org.teavm.model.Instruction;
import org.teavm.model.MethodHolder;
import org.teavm.model.MethodReference;
import org.teavm.model.instructions.InvocationType;
import org.teavm.model.instructions.InvokeInstruction;

/**
 * Replaces calls of methods that a page lacks, or that are wrong or slow there, by calls of the methods of the same
 * names in {@code particles.lab.browser.Missing}.
 */
public final class Substitutions implements ClassHolderTransformer {
    private static final String MISSING = "particles.lab.browser.Missing";
    private static final Set<String> REPLACED = Set.of("java.lang.Math.fma", "java.lang.Math.ulp",
            "java.lang.Runtime.maxMemory", "deSolvers.catalog.SolverCatalog.ofClass",
            "particles.effects.springs.SpringKernel.isOrdinary");

    @Override
    public void transformClass(ClassHolder owner, ClassHolderTransformerContext context) {
        for (MethodHolder method : owner.getMethods()) {
            if (method.getProgram() == null || owner.getName().equals(MISSING)) {
                continue;
            }
            for (BasicBlock block : method.getProgram().getBasicBlocks()) {
                for (Instruction instruction : block) {
                    if (instruction instanceof InvokeInstruction call) {
                        substitute(call);
                    }
                }
            }
        }
    }

    private static void substitute(InvokeInstruction call) {
        MethodReference method = call.getMethod();
        if (REPLACED.contains(method.getClassName() + "." + method.getName())) {
            call.setMethod(new MethodReference(MISSING, method.getDescriptor()));
            call.setType(InvocationType.SPECIAL);
            call.setInstance(null);
        }
    }
}
