#pragma once
// Parts of the JSON report that other documents hold too.
#include "findings/report.h"
#include "report/json.h"

namespace drawbead {

/// The object that `info --format json` prints and that stands under "info" in a report.
void write_info(JsonWriter&, const DeckInfo&);

} // namespace drawbead
