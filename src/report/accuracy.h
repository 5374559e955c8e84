#pragma once
// What `accuracy` prints.
#include "findings/accuracy.h"
#include "report/output.h"

#include <string_view>

namespace drawbead {

/// Tables for people: settings on the front, picks, orders, model difference. `all`: every setting.
void write_accuracy_text(OutputSink&, const AccuracyReport&, bool all);
/// schemas/accuracy.schema.json
void write_accuracy_json(OutputSink&, const AccuracyReport&, std::string_view tool_version);
/// One line per setting: its knobs, the worst error of each quantity, counters, times.
void write_accuracy_csv(OutputSink&, const AccuracyReport&);
/// Error over evaluations, both logarithmic, one colour per line rule; the Pareto front and the picks marked.
void write_accuracy_svg(OutputSink&, const AccuracyReport&);

} // namespace drawbead
