#pragma once
// What the readers of the model met, kept short.
#include "deck/card.h"
#include "model/model.h"

#include <array>
#include <string>
#include <vector>

namespace drawbead {

/// Issues in the order in which they were met, each kind at most `limit` times; the last one listed of a kind
/// counts the rest.
class IssueLog {
public:
    static constexpr std::size_t limit = 100;

    void add(ReadIssue::Kind kind, Span place, std::string subject, std::string detail = {},
             Span related = {});
    /// What is wrong with the text of a cell; true when its value can be used.
    bool check(const Cell&, std::string_view field);
    void check(const Card&);

    std::vector<ReadIssue> take() { return std::move(issues_); }

private:
    struct Tally {
        std::size_t count = 0, last = 0;
    };
    std::vector<ReadIssue> issues_;
    std::array<Tally, 32> tally_{};
};

} // namespace drawbead
