#include "cli/selection.h"

#include "base/nearest.h"
#include "cli/commands.h"
#include "config/options.h"

#include <algorithm>

namespace drawbead {

void add(Summary& total, const Summary& part) {
    total.decks += part.decks;
    total.failed += part.failed;
    total.interfaces += part.interfaces;
    total.errors += part.errors;
    total.warnings += part.warnings;
    total.infos += part.infos;
    total.suppressed += part.suppressed;
    total.known += part.known;
    total.gone += part.gone;
}

bool fails(const Summary& summary, std::optional<Severity> least) {
    if (!least) return false;
    switch (*least) {
    case Severity::error:
        return summary.errors > 0;
    case Severity::warning:
        return summary.errors + summary.warnings > 0;
    case Severity::info:
        break;
    }
    return summary.errors + summary.warnings + summary.infos > 0;
}

std::string word_of(FailOn fail_on) {
    return std::string(fail_on_words()[static_cast<std::size_t>(fail_on)]);
}

FailOn fail_on_from(const std::string& word) {
    const auto words = fail_on_words();
    const auto at = std::find(words.begin(), words.end(), word);
    return static_cast<FailOn>(at - words.begin());
}

namespace {

/// Codes and families may be typed in any letter case.
std::vector<std::string> canonical(std::vector<std::string> words) {
    const std::vector<std::string> known = rule_words(false);
    for (std::string& word : words)
        if (const std::string upper = upper_case(word);
            std::find(known.begin(), known.end(), upper) != known.end())
            word = upper;
    return words;
}

} // namespace

Result<Selection> selection_of(const std::vector<std::string>& select,
                               const std::vector<std::string>& ignore) {
    Selection selection{canonical(select), canonical(ignore)};
    const std::optional<std::string> word = selection.unknown();
    if (!word) return selection;
    std::string help = did_you_mean(*word, rule_words(true));
    if (help.empty()) help = "'drawbead rules' lists all";
    return Error{"no rule or family '" + *word + "'", "", 0, 0, help};
}

} // namespace drawbead
