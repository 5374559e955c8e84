#pragma once
// Ctrl-C and SIGTERM as a wish to stop, which a run over many decks looks at between decks.

namespace drawbead {

/// From now on the first SIGINT or SIGTERM is only noted; a second one ends the process as usual. Reads and
/// waits that are going on come back with EINTR. A signal that the caller ignores stays ignored.
void note_interrupts();

/// The number of the signal that came, 0 when none did.
int interrupt_signal();

} // namespace drawbead
