#include "rules/support.h"
#include "rules/text.h"

#include <map>
#include <set>

namespace drawbead {

namespace {

bool is_missing(ReadIssue::Kind kind) {
    return kind == ReadIssue::Kind::property_missing || kind == ReadIssue::Kind::material_missing ||
           kind == ReadIssue::Kind::part_missing || kind == ReadIssue::Kind::member_missing;
}

/// "part 1 names property 7, which does not exist"
std::string explain(const ReadIssue& issue, const std::string& where) {
    const auto names = [&](const char* what) {
        return printable(issue.subject) + " names " +
               (issue.detail == "0"
                    ? std::string("no ") + what
                    : std::string(what) + " " + printable(issue.detail) + ", which does not exist");
    };
    switch (issue.kind) {
    case ReadIssue::Kind::property_missing:
        return names("property");
    case ReadIssue::Kind::material_missing:
        return names("material");
    case ReadIssue::Kind::part_missing:
        return "the part of " + where + " does not exist";
    default:
        return where + " names " + printable(issue.subject) + ", which does not exist";
    }
}

void check(const RuleContext& context, FindingSink& sink) {
    BlockFinder blocks(context.deck);
    struct Found {
        std::vector<Span> places;
        uint64_t count = 0;
        std::string message;
        std::set<std::string> subjects; ///< all, whatever the order in which they were met
    };
    std::map<std::pair<ReadIssue::Kind, std::string>, Found> all; // one finding per block and kind
    for (const ReadIssue& issue : context.model.issues()) {
        if (!is_missing(issue.kind)) continue;
        const Block* block = blocks.at(issue.place);
        const std::string where = block ? header_name(*block) : "the deck";
        Found& found = all[{issue.kind, where}];
        if (found.places.empty()) found.message = explain(issue, where);
        found.subjects.insert(issue.subject + " " + issue.detail);
        found.places.push_back(issue.place);
        found.count += issue.count;
    }
    for (auto& [key, found] : all) {
        Draft draft;
        set_places(draft, found.places);
        draft.place_count = found.count;
        draft.discriminator = key.second;
        for (const std::string& subject : found.subjects)
            draft.discriminator += ' ' + subject;
        draft.message = std::move(found.message);
        if (found.count > 1) draft.message += " (first of " + std::to_string(found.count) + ")";
        note_lost_include(context, "it", draft);
        draft.help = "define it, or correct the id";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule REF009{{.code = "REF009",
                          .name = "member-undefined",
                          .summary = "a part, group or surface names something that does not exist",
                          .severity = Severity::warning},
                         Needs::blank_elements,
                         check};

} // namespace drawbead
