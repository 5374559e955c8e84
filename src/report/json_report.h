#pragma once
// Parts of the JSON report that other documents hold too.
#include "findings/report.h"
#include "report/json.h"

namespace drawbead {

/// The object that `info --format json` prints and that stands under "info" in a report.
void write_info(JsonWriter&, const DeckInfo&);

/// The members of a finding, of the failure of a deck and of the summary.
void write_finding_members(JsonWriter&, const Finding&);
void write_failure(JsonWriter&, const DeckResult&);
void write_summary_members(JsonWriter&, const Summary&);

} // namespace drawbead
