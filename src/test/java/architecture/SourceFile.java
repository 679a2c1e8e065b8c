package architecture;

import com.sun.source.tree.BlockTree;
import com.sun.source.tree.CatchTree;
import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.ImportTree;
import com.sun.source.tree.MemberSelectTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.NewClassTree;
import com.sun.source.tree.Tree;
import com.sun.source.tree.VariableTree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.TreePathScanner;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.lang.model.element.Modifier;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/** One parsed source file: the packages it uses, and its violations of the project's rules. */
record SourceFile(Path path, String packageName, int codeLines, List<Integer> wideLines, Set<String> usedPackages,
        List<String> emptyCatches, List<String> standardStreams, List<String> mutableStatics,
        List<String> bareAccessors) {
    /** A name that starts with packages: deSolvers.catalog.SolverCatalog, java.awt.Color, particles.effects.*. */
    private static final Pattern QUALIFIED = Pattern.compile(
            "((?:deSolvers|particles|exercises|java|javax|ar|com|org|info|picocli|net|io)"
            + "(?:\\.[a-z]\\w*)*)\\.(?:[A-Z*].*)");
    private static final Pattern TEXT_OR_COMMENT = Pattern.compile(
            "\"\"\".*?\"\"\"|\"(?:\\\\.|[^\"\\\\\n])*\"|'(?:\\\\.|[^'\\\\\n])+'|/[*].*?[*]/|//[^\n]*", Pattern.DOTALL);
    private static final int WIDTH = 120;
    private static final Pattern MUTABLE = Pattern.compile(
            "(java\\.util\\.)?(Array|Linked|Hash|Tree|Priority|Weak|Identity|Concurrent|Enum)\\w*"
            + "(List|Map|Set|Queue|Deque)|Atomic\\w+|\\w*Adder|\\w*Random|StringBuilder|ThreadLocal");

    private static SourceFile of(Path path, CompilationUnitTree unit) throws IOException {
        String text = Files.readString(path);
        SourceFile source = new SourceFile(path, String.valueOf(unit.getPackageName()), codeLines(text),
                wideLines(text), new TreeSet<>(), new ArrayList<>(), new ArrayList<>(), new ArrayList<>(),
                new ArrayList<>());
        source.new Scanner().scan(unit, null);
        return source;
    }

    /** @return every source file below a folder; none if the folder is not there */
    static List<SourceFile> readAll(Path folder) {
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        try (Stream<Path> tree = Files.walk(folder);
                StandardJavaFileManager files = compiler.getStandardFileManager(null,
                null, null)) {
            List<Path> paths = tree.filter(file -> file.toString().endsWith(".java")).sorted().toList();
            if (paths.isEmpty()) {
                return List.of();
            }
            JavacTask parser = (JavacTask) compiler.getTask(null, files, null, List.of("-proc:none"), null,
                    files.getJavaFileObjectsFromPaths(paths));
            List<SourceFile> sources = new ArrayList<>();
            for (CompilationUnitTree unit : parser.parse()) {
                sources.add(of(Path.of(unit.getSourceFile().toUri()), unit));
            }
            return sources;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Counts lines with more than comments and blanks; comment marks inside strings are ignored. */
    static int codeLines(String text) {
        String code = TEXT_OR_COMMENT.matcher(text).replaceAll(found -> {
            String all = found.group();
            return all.startsWith("/") ? all.replaceAll("[^\n]", "") : Matcher.quoteReplacement(all);
        });
        return (int) code.lines().filter(line -> !line.isBlank()).count();
    }

    /** The numbers of lines over 120 columns, except imports. */
    static List<Integer> wideLines(String text) {
        List<String> all = text.lines().toList();
        return IntStream.range(0, all.size()).filter(i -> all.get(i).length() > WIDTH
                && !all.get(i).startsWith("import "))
                .mapToObj(i -> i + 1).toList();
    }

    @Override
    public String toString() {
        return packageName + "/" + path.getFileName();
    }

    private final class Scanner extends TreePathScanner<Void, Void> {
        @Override
        public Void visitImport(ImportTree node, Void none) {
            use(node.getQualifiedIdentifier().toString());
            return null;
        }

        @Override
        public Void visitMemberSelect(MemberSelectTree node, Void none) {
            String name = node.toString();
            use(name);
            if (name.matches("(java\\.lang\\.)?System\\.(out|err|exit)")) {
                standardStreams.add(SourceFile.this + " uses " + name);
            }
            return super.visitMemberSelect(node, null);
        }

        @Override
        public Void visitCatch(CatchTree node, Void none) {
            BlockTree block = node.getBlock();
            if (block.getStatements().isEmpty()) {
                emptyCatches.add(SourceFile.this + " catches " + node.getParameter().getType() + " and does nothing");
            }
            return super.visitCatch(node, null);
        }

        @Override
        public Void visitVariable(VariableTree node, Void none) {
            Set<Modifier> flags = node.getModifiers().getFlags();
            Tree parent = getCurrentPath().getParentPath().getLeaf();
            boolean constant = parent.getKind() == Tree.Kind.INTERFACE || parent.getKind() == Tree.Kind.ENUM
                    && !flags.contains(Modifier.STATIC);
            if (parent instanceof ClassTree
                    && (flags.contains(Modifier.STATIC) || parent.getKind() == Tree.Kind.INTERFACE)) {
                String why = whyMutable(node, flags, constant);
                if (!why.isEmpty()) {
                    mutableStatics.add(SourceFile.this + ": static " + node.getName() + " " + why);
                }
            }
            return super.visitVariable(node, null);
        }

        /** Finds methods of classes that return a field and have its name, unless an interface gives them theirs. */
        @Override
        public Void visitMethod(MethodTree node, Void none) {
            boolean ofClass = getCurrentPath().getParentPath().getLeaf().getKind() == Tree.Kind.CLASS;
            String modifiers = node.getModifiers().toString();
            if (ofClass && node.getParameters().isEmpty() && node.getBody() != null
                    && !modifiers.matches("(?s).*(@Override|private|static).*")
                    && node.getBody().getStatements().toString().matches("return [a-z]\\w*([.]clone\\(\\))?;")
                    && !node.getBody().getStatements().toString().matches("return (true|false|this|null);")
                    && !node.getName().toString().matches("(get|is|has|can|have|may)[A-Z].*|size|count")) {
                bareAccessors.add(SourceFile.this + ": " + node.getName());
            }
            return super.visitMethod(node, null);
        }

        private String whyMutable(VariableTree node, Set<Modifier> flags, boolean constant) {
            if (!constant && !flags.contains(Modifier.FINAL)) {
                return "is not final";
            }
            String type = String.valueOf(node.getType());
            if (type.endsWith("]") && !flags.contains(Modifier.PRIVATE)) {
                return "is an array that others can write to";
            }
            if (MUTABLE.matcher(type.replaceFirst("<.*", "")).matches()) {
                return "is a " + type;
            }
            return node.getInitializer() instanceof NewClassTree made
                    && MUTABLE.matcher(made.getIdentifier().toString().replaceFirst("<.*", "")).matches()
                    ? "is a new " + made.getIdentifier() : "";
        }

        private void use(String name) {
            Matcher qualified = QUALIFIED.matcher(name);
            if (qualified.matches()) {
                usedPackages.add(qualified.group(1));
            }
        }
    }
}
