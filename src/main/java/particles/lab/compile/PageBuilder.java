package particles.lab.compile;

import java.io.IOException;
import java.io.InputStream;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.teavm.backend.javascript.JSModuleType;
import org.teavm.diagnostics.Problem;
import org.teavm.model.BasicBlock;
import org.teavm.model.ClassHolder;
import org.teavm.model.ClassHolderTransformer;
import org.teavm.model.ClassHolderTransformerContext;
import org.teavm.model.Instruction;
import org.teavm.model.MethodHolder;
import org.teavm.model.MethodReference;
import org.teavm.model.instructions.InvocationType;
import org.teavm.model.instructions.InvokeInstruction;
import org.teavm.tooling.EmptyTeaVMToolLog;
import org.teavm.tooling.TeaVMTargetType;
import org.teavm.tooling.TeaVMTool;
import org.teavm.tooling.TeaVMToolException;
import org.teavm.vm.TeaVMOptimizationLevel;
import particles.lab.LabBuilder;
import particles.lab.PageParts;
import particles.lab.Session;
import particles.spec.ClassNames;

/** Builds the lab's page: compiles its engine, and adds the scenes with their pictures. */
public final class PageBuilder implements LabBuilder {
    private static final String ENGINE = "particles.lab.browser.Engine";
    private static final String FILE = "engine.js";

    /** Made without parameters, by its name. */
    public PageBuilder() {
    }

    @Override
    public String build(Contents contents, Path folder) throws IOException {
        return PageParts.page(engine(contents.classes(), folder), scenes(contents) + Formulas.script(),
                List.of(PageParts.own("licences.txt"), apache()));
    }

    /**
     * Compiles {@code particles.lab.browser.Engine}, and all that it needs, from Java to JavaScript.
     *
     * @param classes finds the classes to be compiled
     * @param folder  receives the files of the compiler
     * @return the JavaScript
     * @throws IllegalArgumentException if something that is reached cannot be compiled
     */
    private static String engine(ClassLoader classes, Path folder) throws IOException {
        TeaVMTool tool = new TeaVMTool();
        tool.setTargetType(TeaVMTargetType.JAVASCRIPT);
        tool.setMainClass(ENGINE);
        tool.setTargetDirectory(folder.toFile());
        tool.setTargetFileName(FILE);
        tool.setJsModuleType(JSModuleType.NONE);
        tool.setObfuscated(true);
        tool.setOptimizationLevel(TeaVMOptimizationLevel.ADVANCED);
        tool.setClassLoader(classes);
        tool.setLog(new EmptyTeaVMToolLog());
        tool.getTransformers().add(Substitutions.class.getName());
        try {
            tool.generate();
        } catch (TeaVMToolException e) {
            throw new IOException(e);
        }
        Map<String, String> problems = new TreeMap<>();
        for (Problem problem : tool.getProblemProvider().getSevereProblems()) {
            problems.put(problem.getText() + ' ' + Arrays.toString(problem.getParams()),
                    problem.getLocation() == null ? "" : " in " + problem.getLocation().getMethod());
        }
        if (!problems.isEmpty()) {
            throw new IllegalArgumentException("the page cannot compile this: " + problems);
        }
        return Files.readString(folder.resolve(FILE));
    }

    private static String scenes(Contents contents) throws IOException {
        StringBuilder all = new StringBuilder();
        for (Path file : contents.scenes().keySet()) {
            String name = file.getFileName().toString();
            String text = contents.scenes().get(file);
            String first = file.equals(contents.first()) ? first(name, text, contents) : "";
            byte[] picture = contents.pictures().getOrDefault(file, new byte[0]);
            all.append(PageParts.scene(name, text, first + " data-picture=\""
                    + Base64.getEncoder().encodeToString(picture) + '"'));
        }
        return all.toString();
    }

    /** What the page knows before its engine runs. A law of your own is found by the engine alone. */
    private static String first(String name, String text, Contents contents) throws IOException {
        String opening = new Session(ClassNames.none()).opening(name, text, contents.solver());
        return " data-first=\"%s\" data-opening=\"%s\" data-own=\"%s\"".formatted(contents.solver(),
                PageParts.packed(opening), String.join(" ", contents.solvers()));
    }

    /** The text of the Apache License, from the first library that contains it. */
    private static String apache() throws IOException {
        for (URL found : Collections.list(PageBuilder.class.getClassLoader().getResources("META-INF/LICENSE.txt"))) {
            try (InputStream stream = found.openStream()) {
                String text = new String(stream.readAllBytes(), StandardCharsets.UTF_8);
                if (text.contains("Apache License")) {
                    return text;
                }
            }
        }
        throw new IOException("no library has the text of the Apache License");
    }

    /**
     * Replaces calls of methods that a page lacks, or that are wrong or slow there, by calls of the methods of the same
     * names in {@code particles.lab.browser.Missing}.
     */
    public static final class Substitutions implements ClassHolderTransformer {
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
}
