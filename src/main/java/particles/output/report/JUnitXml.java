package particles.output.report;

import java.io.StringWriter;
import java.util.List;
import java.util.Optional;
import javax.xml.stream.XMLOutputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;
import particles.output.files.OutputException;
import particles.output.files.OutputFolder;

/** Writes results as JUnit XML reports, which autograders read. */
public final class JUnitXml {
    private JUnitXml() {
    }

    /**
     * One result.
     *
     * @param name    the name of the item
     * @param failure the mistake in one line; empty if it is right
     * @param details further comments in either case, a line each
     */
    public record Case(String name, Optional<String> failure, List<String> details) {
    }

    /**
     * Writes TEST-SUITE.xml.
     *
     * @param folder the output folder
     * @param suite  the name of the test suite; the class name of all results
     * @param cases  the results
     * @throws OutputException if it cannot be written
     */
    public static void write(OutputFolder folder, String suite, List<Case> cases) {
        StringWriter text = new StringWriter();
        try {
            XMLStreamWriter xml = XMLOutputFactory.newInstance().createXMLStreamWriter(text);
            xml.writeStartDocument("UTF-8", "1.0");
            xml.writeCharacters("\n");
            start(xml, "testsuite", "name", suite, "tests", Integer.toString(cases.size()), "failures",
                    Long.toString(cases.stream().filter(c -> c.failure().isPresent()).count()), "errors", "0",
                    "skipped",
                            "0", "time", "0");
            for (Case result : cases) {
                xml.writeCharacters("\n  ");
                start(xml, "testcase", "classname", suite, "name", result.name(), "time", "0");
                String details = String.join("\n", result.details());
                if (result.failure().isPresent()) {
                    start(xml, "failure", "type", "mark", "message", result.failure().get());
                } else {
                    start(xml, "system-out");
                }
                xml.writeCharacters(clean(details));
                xml.writeEndElement();
                xml.writeEndElement();
            }
            xml.writeCharacters("\n");
            xml.writeEndElement();
            xml.writeEndDocument();
        } catch (XMLStreamException e) {
            throw new IllegalStateException("XML cannot be written to memory", e);
        }
        folder.write("TEST-" + suite + ".xml", text + "\n");
    }

    private static void start(XMLStreamWriter xml, String element, String... attributes) throws XMLStreamException {
        xml.writeStartElement(element);
        for (int k = 0; k < attributes.length; k += 2) {
            xml.writeAttribute(attributes[k], clean(attributes[k + 1]));
        }
    }

    /** Removes control characters that XML cannot express. */
    private static String clean(String text) {
        return text.replaceAll(Html.NO_CHARACTER, "?");
    }
}
