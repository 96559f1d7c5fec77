// Ctrl-C and SIGTERM: a long stage stops at its next step by an Error, so that what is half-written goes with its destructors.
#pragma once

namespace afterglow
{
// From here on both signals are heard. Outside a stage nothing is half-written: there they end the program at once, with Exit::interrupted.
void hearInterrupts();

// Inside a stage they only ask it to stop; the second one does not wait.
void beginInterruptible();
void endInterruptible();

// While something stands half-written under a name that must not remain (scaffold.hpp) they only ask, however often.
void beginWriting();
void endWriting();
void tellWritten();  // the outermost took its place, whole: the sentence says so from here on
void tellWatching(); // nobody asked for anything to be written: the sentence speaks of none

// Throws Error (Exit::interrupted) once the stage was asked to stop. Costs a load: called in the inner loops of whatever may take long.
void stopIfInterrupted();
}
