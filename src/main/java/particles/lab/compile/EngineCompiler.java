package particles.lab.compile;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;
import org.teavm.backend.javascript.JSModuleType;
import org.teavm.diagnostics.Problem;
import org.teavm.tooling.EmptyTeaVMToolLog;
import org.teavm.tooling.TeaVMTargetType;
import org.teavm.tooling.TeaVMTool;
import org.teavm.tooling.TeaVMToolException;
import org.teavm.vm.TeaVMOptimizationLevel;

/** Compiles {@code particles.lab.browser.Engine}, and all that it needs, from Java to JavaScript. */
final class EngineCompiler {
    private static final String ENGINE = "particles.lab.browser.Engine";
    private static final String FILE = "engine.js";

    private EngineCompiler() {
    }

    /**
     * @param classes finds the classes to be compiled
     * @param folder  receives the files of the compiler
     * @return the JavaScript
     * @throws IllegalArgumentException if something that is reached cannot be compiled
     */
    static String compile(ClassLoader classes, Path folder) throws IOException {
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
}
