package particles.spec;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.CoderResult;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Optional;
import org.snakeyaml.engine.v2.scanner.StreamReader;
import particles.spec.messages.Place;

/** Reads a text file safely: limited size, UTF-8, printable characters only; anything else is a clear problem. */
public final class SourceText {
    /** The largest file (bytes); a scene of 10,000 single particles takes a third of it. */
    static final int LARGEST = 2 << 20;
    /** The longest word; the parser's time grows with the square of a word's length. */
    static final int LONGEST_WORD = 100_000;
    /** Printable by YAML 1.2, and refused by its parser. */
    private static final int DELETE = 0x7f;
    /** The two bytes of UTF-16's byte order mark. */
    private static final byte LOW = (byte) 0xfe;
    private static final byte HIGH = (byte) 0xff;

    private SourceText() {
    }

    /**
     * Reads a file up to the largest size.
     *
     * @param file   the file
     * @param in     its name, and the list that receives problems
     * @return its bytes, or empty if a problem was reported
     */
    public static Optional<byte[]> read(Path file, Reading in) {
        return read(file, LARGEST, in);
    }

    /** The same up to another size (bytes), and one byte more if there are more. */
    public static Optional<byte[]> read(Path file, int largest, Reading in) {
        String problem;
        if (Files.isDirectory(file)) {
            problem = "this is a folder; it has to be a file";
        } else {
            try (InputStream stream = Files.newInputStream(file)) {
                return Optional.of(stream.readNBytes(largest + 1));
            } catch (NoSuchFileException e) {
                problem = "there is no such file";
            } catch (AccessDeniedException e) {
                problem = "no permission to read the file";
            } catch (IOException e) {
                problem = "the file cannot be read: " + e.getMessage();
            }
        }
        return in.problem(problem);
    }

    /**
     * Decodes a student's file as a person would read it.
     *
     * @return the text of bytes in UTF-8, in UTF-16 with a byte order mark, or else in windows-1252
     */
    public static String lenient(byte[] bytes) {
        try {
            return (isUtf16(bytes) ? StandardCharsets.UTF_16 : StandardCharsets.UTF_8).newDecoder()
                    .decode(ByteBuffer.wrap(bytes)).toString().replaceFirst("^\ufeff", "");
        } catch (CharacterCodingException e) {
            return new String(bytes, Charset.forName("windows-1252"));
        }
    }

    private static boolean isUtf16(byte[] bytes) {
        return bytes.length >= 2 && (bytes[0] == LOW && bytes[1] == HIGH || bytes[0] == HIGH && bytes[1] == LOW);
    }

    /**
     * Decodes bytes as UTF-8, with or without a byte order mark.
     *
     * @param bytes the contents of a file
     * @param in    its name, and the list that receives problems
     * @return the text, or empty if a problem was reported
     */
    static Optional<String> decode(byte[] bytes, Reading in) {
        if (bytes.length > LARGEST) {
            return in.problem("the file is longer than " + (LARGEST >> 20)
                    + " MiB; use shapes to make many particles");
        }
        if (isUtf16(bytes)) {
            return in.problem("the file is in UTF-16; save it as UTF-8");
        }
        CharBuffer characters = CharBuffer.allocate(bytes.length);
        CoderResult result = StandardCharsets.UTF_8.newDecoder().onMalformedInput(CodingErrorAction.REPORT)
                .decode(ByteBuffer.wrap(bytes), characters, true);
        String text = characters.flip().toString().replaceAll("\r\n?", "\n");
        if (result.isError()) {
            return in.problems().add(end(text, in), "a byte here is not UTF-8; save the file as UTF-8");
        }
        text = text.startsWith("\uFEFF") ? text.substring(1) : text;
        int word = 0;
        for (int i = 0, c; i < text.length(); i += Character.charCount(c)) {    // the page's patterns are recursive
            c = text.codePointAt(i);
            word = c == ' ' || c == '\t' || c == '\n' ? 0 : word + 1;
            String problem = word > LONGEST_WORD
                    ? "more than " + LONGEST_WORD + " characters without a space between them; break the line"
                    : StreamReader.isPrintable(c) && c != DELETE ? "" : "a character here is not printable: "
                            + (c == 0 ? "a zero byte; is this a text file?" : String.format("U+%04X", c));
            if (!problem.isEmpty()) {
                return in.problems().add(end(text.substring(0, i), in), problem);
            }
        }
        return Optional.of(text);
    }

    /** The place right after the end of a text. */
    static Place end(String text, Reading in) {
        String[] lines = text.split("\n", -1);
        String last = lines[lines.length - 1];
        return new Place(in.source(), lines.length, last.codePointCount(0, last.length()) + 1);
    }
}
