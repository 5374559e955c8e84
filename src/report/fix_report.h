#pragma once
#include "findings/fix_report.h"
#include "report/output.h"

#include <span>
#include <string_view>

namespace drawbead {

/// Text: what was repaired and what was not and why, then per interface what changed, then what remains.
void write_fix_text(OutputSink&, const FixReport&, bool colour);

/// JSON by schemas/fix.schema.json, for all decks of a run.
void write_fix_json(OutputSink&, std::span<const FixReport>, std::string_view tool_version);

} // namespace drawbead
