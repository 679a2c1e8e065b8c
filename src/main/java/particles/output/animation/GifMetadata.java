package particles.output.animation;

import javax.imageio.metadata.IIOInvalidTreeException;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;

/** The metadata of a GIF, in the format of ImageIO's "GIF Metadata Format Specification". */
final class GifMetadata {
    private static final String IMAGE = "javax_imageio_gif_image_1.0";
    /** Netscape's extension: block 1, then the number of runs, 0 for ever. */
    private static final byte[] FOR_EVER = {1, 0, 0};

    private GifMetadata() {
    }

    /**
     * A frame that stays under the next one.
     *
     * @param delay the delay in hundredths of a second
     */
    static void describeFrame(IIOMetadata metadata, int x, int y, int transparent, int delay, boolean first)
            throws IIOInvalidTreeException {
        IIOMetadataNode root = (IIOMetadataNode) metadata.getAsTree(IMAGE);
        IIOMetadataNode place = child(root, "ImageDescriptor");
        place.setAttribute("imageLeftPosition", Integer.toString(x));
        place.setAttribute("imageTopPosition", Integer.toString(y));
        IIOMetadataNode control = child(root, "GraphicControlExtension");
        control.setAttribute("disposalMethod", "doNotDispose");
        control.setAttribute("userInputFlag", "FALSE");
        control.setAttribute("transparentColorFlag", "TRUE");
        control.setAttribute("transparentColorIndex", Integer.toString(transparent));
        control.setAttribute("delayTime", Integer.toString(delay));
        if (first) {
            IIOMetadataNode extensions = child(root, "ApplicationExtensions");
            add(extensions, "ApplicationExtension", "applicationID", "NETSCAPE", "authenticationCode", "2.0")
                    .setUserObject(FOR_EVER.clone());
        }
        metadata.setFromTree(IMAGE, root);
    }

    private static IIOMetadataNode child(IIOMetadataNode parent, String name) {
        for (int k = 0; k < parent.getLength(); k++) {
            if (parent.item(k).getNodeName().equals(name)) {
                return (IIOMetadataNode) parent.item(k);
            }
        }
        return add(parent, name);
    }

    /** @param attributes names and values in turn */
    private static IIOMetadataNode add(IIOMetadataNode parent, String name, Object... attributes) {
        IIOMetadataNode node = new IIOMetadataNode(name);
        for (int k = 0; k < attributes.length; k += 2) {
            node.setAttribute((String) attributes[k], attributes[k + 1].toString());
        }
        parent.appendChild(node);
        return node;
    }
}
