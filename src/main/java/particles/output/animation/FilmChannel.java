package particles.output.animation;

import java.io.IOException;
import java.nio.ByteBuffer;
import org.jcodec.common.io.SeekableByteChannel;
import particles.output.files.OutputFile;

/**
 * An output file as the channel of the film library: it is extended at its end, and its header is completed at last.
 */
final class FilmChannel implements SeekableByteChannel {
    private final OutputFile file;
    private long size;
    private long position;

    FilmChannel(OutputFile file) {
        this.file = file;
    }

    @Override
    public int write(ByteBuffer source) {
        byte[] bytes = new byte[source.remaining()];
        source.get(bytes);
        if (position == size) {
            file.write(bytes, 0, bytes.length);
        } else if (position + bytes.length <= size) {
            file.overwrite(position, bytes);
        } else {
            throw new IllegalStateException("bytes at " + position + " reach over the end at " + size);
        }
        position += bytes.length;
        size = Math.max(size, position);
        return bytes.length;
    }

    @Override
    public long position() {
        return position;
    }

    @Override
    public SeekableByteChannel setPosition(long to) {
        position = to;
        return this;
    }

    @Override
    public long size() {
        return size;
    }

    @Override
    public int read(ByteBuffer target) throws IOException {
        throw new IOException("a film that is being written is not read");
    }

    @Override
    public SeekableByteChannel truncate(long length) throws IOException {
        throw new IOException("a film that is being written is not shortened");
    }

    @Override
    public boolean isOpen() {
        return true;
    }

    /** Does nothing: the file is closed by its owner. */
    @Override
    public void close() {
        // nothing of its own
    }
}
