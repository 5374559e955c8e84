#pragma once
// What the repair that a finding offers would change, for reports. Planned on the deck as it is, one finding
// at a time: `fix` besides proves a repair by reading the result, and finds a way for several at once.
#include "fix/free_ids.h"
#include "model/option_index.h"
#include "rules/check.h"

namespace drawbead {

/// A file's edits, which are of the text as it is and in order, with their places.
FileChange change_of(const SourceFile&, const EditList&);

class ChangePlanner {
public:
    /// A report is no place for changes beyond these: `fix --diff` shows them.
    static constexpr std::size_t most_edits = 1000, most_bytes = std::size_t{256} << 10;

    /// The model must hold what the repairs look at; `checked` outlives this.
    explicit ChangePlanner(const CheckedDeck& checked);

    /// Adds to the offer of `draft` what it would change, and nothing where there is nothing to show.
    void add_changes(const RuleDraft& draft, std::vector<FixOffer>& offers) const;

private:
    const CheckedDeck& checked_;
    IssueLog unreported_;
    OptionIndex options_;
    FreeIds ids_;
};

} // namespace drawbead
