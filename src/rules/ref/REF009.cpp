#include "rules/support.h"
#include "rules/text.h"

#include <map>

namespace drawbead {

namespace {

const char* defect(ReadIssue::Kind kind) {
    switch (kind) {
    case ReadIssue::Kind::property_missing:
        return "names a property that does not exist";
    case ReadIssue::Kind::material_missing:
        return "names a material that does not exist";
    case ReadIssue::Kind::part_missing:
        return "names a part that does not exist";
    case ReadIssue::Kind::member_missing:
        return "names a member that does not exist";
    default:
        return nullptr;
    }
}

void check(const RuleContext& context, FindingSink& sink) {
    const BlockFinder blocks(context.deck);
    struct Found {
        std::vector<Span> places;
        uint64_t count = 0;
        std::string where, subject;
    };
    std::map<std::pair<ReadIssue::Kind, std::string>, Found> all; // one finding per kind of option
    for (const ReadIssue& issue : context.model.issues()) {
        if (!defect(issue.kind)) continue;
        const Block* block = blocks.at(issue.place);
        const std::string where = block ? std::string(block->keyword) : "";
        Found& found = all[{issue.kind, where}];
        if (found.places.empty()) {
            found.where = block ? header_name(*block) : "the deck";
            found.subject = issue.subject;
        }
        found.places.push_back(issue.place);
        found.count += issue.count;
    }
    for (const auto& [key, found] : all) {
        Draft draft;
        set_places(draft, found.places);
        draft.place_count = found.count;
        draft.discriminator = found.where + " " + found.subject;
        draft.message = found.where + " " + defect(key.first) +
                        (found.subject.empty() ? "" : " (" + printable(found.subject) + ")");
        if (found.count > 1) draft.message += ", first of " + std::to_string(found.count);
        if (std::string note = lost_include_note(context.deck); !note.empty())
            draft.notes.push_back(std::move(note));
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
