#pragma once
// What `info` prints: what was read of a deck.
#include "findings/report.h"
#include "report/output.h"

namespace drawbead {

void write_info_text(OutputSink&, const DeckResult&);
void write_info_json(OutputSink&, const DeckResult&);

} // namespace drawbead
