#pragma once
// One function per command: does the work, prints, returns the exit status.
#include "cli/options.h"
#include "cli/terminal.h"
#include "report/output.h"

#include <string>
#include <string_view>
#include <vector>

namespace drawbead {

int run(const CheckCommand&);
int run(const MergeCommand&);
int run(const FixCommand&);
int run(const TableCommand&);
int run(const InfoCommand&);
int run(const AuditCommand&);
int run(const EvaluateCommand&);
int run(const AccuracyCommand&);
int run(const RulesCommand&);
int run(const ExplainCommand&);
int run(const SchemaCommand&);
int run(const CompletionCommand&);
int run(const PrintCommand&);

/// Of this tool, e.g. "0.1.0".
std::string_view tool_version();

/// Finishes standard output or a file of results; says what went wrong unless the reader of a pipe just went
/// away.
int finish(FileSink&);
/// Writes a text to standard output.
int print(std::string_view text);

/// `accuracy --hard-cases`: to a file, or to standard output when its name is empty; status 1 when one fails.
int run_hard_cases(bool json, const std::string& file);

/// What --select takes: codes, families, "ALL", and with `names` the names of rules.
std::vector<std::string> rule_words(bool names);

} // namespace drawbead
