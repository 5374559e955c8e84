#include "model/issue_log.h"

namespace drawbead {

void IssueLog::add(ReadIssue::Kind kind, Span place, std::string subject, std::string detail, Span related) {
    Tally& tally = tally_[static_cast<std::size_t>(kind) % tally_.size()];
    if (++tally.count > limit) {
        ++issues_[tally.last].count;
        return;
    }
    tally.last = issues_.size();
    ReadIssue issue{kind, place, std::move(subject), std::move(detail), related};
    issues_.push_back(std::move(issue));
}

bool IssueLog::check(const Cell& cell, std::string_view field) {
    ReadIssue::Kind kind;
    switch (cell.state) {
    case CellState::garbage:
        kind = ReadIssue::Kind::not_a_number;
        break;
    case CellState::not_finite:
        kind = ReadIssue::Kind::not_finite;
        break;
    case CellState::unknown_parameter:
        kind = ReadIssue::Kind::unknown_parameter;
        break;
    default:
        return true;
    }
    add(kind, cell.place, std::string(cell.text), std::string(field));
    return false;
}

void IssueLog::check(const Card& card) {
    for (std::size_t i = 0; i < card.cells.size(); ++i)
        check(card.cells[i], card.schema->fields[i].name);
}

} // namespace drawbead
