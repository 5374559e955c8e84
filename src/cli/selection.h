#pragma once
// Which rules a command line means, and what counts as a failure.
#include "base/result.h"
#include "cli/options.h"
#include "findings/report.h"
#include "rules/check.h"

#include <string>
#include <vector>

namespace drawbead {

/// Codes and families may be typed in any letter case; an error when a word names nothing.
Result<Selection> selection_of(const std::vector<std::string>& select,
                               const std::vector<std::string>& ignore);

void add(Summary& total, const Summary& part);
/// Whether something is as severe as the user wants to hear of by the exit status.
bool fails(const Summary&, std::optional<Severity> least);
/// A word of `fail-on` in a configuration.
FailOn fail_on_from(const std::string& word);
/// … and back.
std::string word_of(FailOn);

} // namespace drawbead
