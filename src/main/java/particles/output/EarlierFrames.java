package particles.output;

/** The frames of a run that was interrupted, as they were drawn. */
@FunctionalInterface
interface EarlierFrames {

    /**
     * @param index the number of a frame
     * @return its pixels, 0xRRGGBB row by row from the top
     * @throws OutputException if it is not there any more
     */
    int[] read(int index);
}
