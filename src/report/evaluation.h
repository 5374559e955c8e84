#pragma once
// What `evaluate` and `plan` print.
#include "findings/evaluation.h"
#include "report/output.h"

#include <span>
#include <string_view>

namespace drawbead {

/// Totals per bead and tool, and the effects; for people.
void write_evaluation_text(OutputSink&, const EvaluationReport&);
/// schemas/evaluation.schema.json
void write_evaluation_json(OutputSink&, const EvaluationReport&, std::string_view tool_version);

/// The effects alone.
void write_plan_text(OutputSink&, const EvaluationReport&);
/// schemas/plan.schema.json
void write_plan_json(OutputSink&, const EvaluationReport&, std::string_view tool_version);

/// One line per step and node. Columns that a solver's record has too bear its names.
void write_samples_header(OutputSink&);
void write_samples(OutputSink&, const SampledBead&);

/// Bead nodes, lines between them, and what acts on the blank at them: one .vtu file, binary, little-endian.
/// `beads` are of one law and one step.
void write_vtu(OutputSink&, std::span<const SampledBead> beads);
/// The series: a time and a file name for each step.
struct VtuStep {
    double time = 0;
    std::string file;
};
void write_pvd(OutputSink&, std::span<const VtuStep>);

} // namespace drawbead
