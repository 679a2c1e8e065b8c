package particles;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.StreamSupport;
import javax.xml.parsers.DocumentBuilder;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.xpath.XPathExpressionException;
import javax.xml.xpath.XPathFactory;
import javax.xml.xpath.XPathNodes;
import org.w3c.dom.Document;
import org.w3c.dom.Node;
import org.xml.sax.SAXException;

/** A page or file that has to be XML; what is asked of it are XPath expressions. */
public record Xml(Document document) {
    /** @throws SAXException if the text is not well-formed */
    public static Xml of(String text) throws SAXException, IOException, ParserConfigurationException {
        DocumentBuilder builder = DocumentBuilderFactory.newInstance().newDocumentBuilder();
        builder.setErrorHandler(null);
        return new Xml(builder.parse(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8))));
    }

    /** @return the texts of all elements or attributes at a path */
    public List<String> all(String path) {
        try {
            XPathNodes nodes = XPathFactory.newInstance().newXPath().evaluateExpression(path, document,
                    XPathNodes.class);
            return StreamSupport.stream(nodes.spliterator(), false).map(Node::getTextContent).toList();
        } catch (XPathExpressionException e) {
            throw new AssertionError(path, e);
        }
    }

    /** @return the text of the only element or attribute at a path */
    public String one(String path) {
        List<String> all = all(path);
        if (all.size() != 1) {
            throw new AssertionError(path + " is there " + all.size() + " times");
        }
        return all.get(0);
    }
}
