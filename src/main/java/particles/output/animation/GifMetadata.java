package particles.output.animation;

import java.awt.Rectangle;
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
     * Describes a frame that stays under the next one.
     *
     * @param place where it is (pixels)
     * @param delay the delay in hundredths of a second
     */
    static void describeFrame(IIOMetadata metadata, Rectangle place, int delay, boolean first)
            throws IIOInvalidTreeException {
        IIOMetadataNode root = new IIOMetadataNode(IMAGE);
        add(root, "ImageDescriptor", "imageLeftPosition", place.x, "imageTopPosition", place.y, "imageWidth",
                place.width, "imageHeight", place.height, "interlaceFlag", "FALSE");
        // the transparent colour is one of the palette that the writer chooses: it then sets flag and index itself
        add(root, "GraphicControlExtension", "disposalMethod", "doNotDispose", "userInputFlag", "FALSE",
                "transparentColorFlag", "FALSE", "transparentColorIndex", 0, "delayTime", delay);
        if (first) {
            IIOMetadataNode extensions = add(root, "ApplicationExtensions");
            add(extensions, "ApplicationExtension", "applicationID", "NETSCAPE", "authenticationCode", "2.0")
                    .setUserObject(FOR_EVER.clone());
        }
        metadata.mergeTree(IMAGE, root);
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
