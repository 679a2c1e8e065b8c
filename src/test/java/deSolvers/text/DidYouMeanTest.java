package deSolvers.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DidYouMeanTest {
    private static final List<String> KNOWN = List.of("gravity", "drag", "wind", "stiffness", "restLength", "deltaT",
            "duration");

    @ParameterizedTest
    @CsvSource({"gravty,gravity", "gravityy,gravity", "gravtiy,gravity", "GRAVITY,gravity", "deltat,deltaT",
            "dletaT,deltaT",
        "restlenght,restLength", "wnd,wind", "stiff,stiffness", "durtaion,duration"})
    void typingErrorsAreRecognised(String found, String meant) {
        assertEquals(Optional.of(meant), DidYouMean.nearest(found, KNOWN));
    }

    @ParameterizedTest
    @CsvSource({"magnetism", "grab", "x", "d", "''", "wand-er", "ratio"})
    void distantNamesAreNotSuggested(String found) {
        assertEquals(Optional.empty(), DidYouMean.nearest(found, KNOWN));
    }

    @Test
    void theHintEndsWithTheKnownNames() {
        assertEquals("; did you mean 'drag'?", DidYouMean.hint("darg", KNOWN, "'%s'"::formatted));
        assertEquals(";", DidYouMean.hint("magnetism", KNOWN, "'%s'"::formatted));
        assertEquals(";", DidYouMean.hint("magnetism", List.of(), "'%s'"::formatted));
    }
}
