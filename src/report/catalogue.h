#pragma once
// The list of rules, as `rules` prints it.
#include "findings/finding.h"
#include "report/output.h"

#include <string_view>
#include <vector>

namespace drawbead {

void write_catalogue_text(OutputSink&, const std::vector<RuleInfo>&);
void write_catalogue_json(OutputSink&, const std::vector<RuleInfo>&, std::string_view tool_version);

} // namespace drawbead
