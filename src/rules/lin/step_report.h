#pragma once
// What the rules about the spacing of bead nodes have in common: one finding per bead about some of its
// steps.
#include "rules/lin/bead_report.h"

#include <string>

namespace drawbead {

struct StepWords {
    std::string what;        ///< "steps longer than the element under them"
    std::string usual;       ///< what LineHop::usual is: "element"
    std::string consequence; ///< after the semicolon, before the force on one node
    std::string help;
};

/// Says it of the step that differs most from what is usual; `longest`: the long ones count, else the short
/// ones.
void report_steps(const RuleContext&, const BeadAnalysis&, const std::vector<LineHop>&, bool longest,
                  const StepWords&, FindingSink&);

} // namespace drawbead
