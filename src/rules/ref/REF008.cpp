#include "rules/support.h"
#include "rules/text.h"

#include <set>

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    const std::string lost = lost_include_note(context.deck);
    const auto report = [&](std::string message, const std::vector<Span>& places, uint64_t count,
                            Draft draft) {
        set_places(draft, places);
        draft.place_count = count;
        draft.message = std::move(message);
        if (!lost.empty()) draft.notes.push_back(lost);
        draft.help = "define the nodes, or correct the ids";
        sink.add(std::move(draft));
    };
    for (const Surface& surface : context.model.surfaces()) {
        if (surface.unknown_nodes.empty()) continue;
        Draft draft;
        for (const int64_t id : surface.unknown_nodes)
            draft.entities.nodes.add(id);
        draft.discriminator = "surface " + std::to_string(surface.id);
        report("surface " + std::to_string(surface.id) + " names " +
                   counted(surface.unknown_nodes.size(), "node") + " that " +
                   (surface.unknown_nodes.size() == 1 ? "does" : "do") + " not exist (" +
                   listed(surface.unknown_nodes) + "): the Starter stops",
               surface.unknown_node_lines, surface.unknown_nodes.size(), std::move(draft));
    }
    std::vector<Span> places;
    uint64_t count = 0;
    std::string first;
    std::set<std::string> subjects; // whatever the order in which they were met
    for (const ReadIssue& issue : context.model.issues()) {
        if (issue.kind != ReadIssue::Kind::unknown_node) continue;
        if (places.empty()) first = issue.subject + ": " + issue.detail;
        subjects.insert(issue.subject + " " + issue.detail);
        places.push_back(issue.place);
        count += issue.count;
    }
    if (count == 0) return;
    Draft draft;
    draft.discriminator = "elements";
    for (const std::string& subject : subjects)
        draft.discriminator += ' ' + subject;
    report(counted(count, "element") + " of the main surfaces " + (count == 1 ? "has" : "have") +
               " nodes that do not exist (" + first + (count == 1 ? "" : ", …") + "): the Starter stops",
           places, count, std::move(draft));
}

} // namespace

extern const Rule REF008{{.code = "REF008",
                          .name = "segment-node-undefined",
                          .summary = "segments or elements of a main surface have nodes that do not exist",
                          .severity = Severity::error},
                         Needs::coordinates | Needs::blank_elements,
                         check};

} // namespace drawbead
