#include "rules/support.h"
#include "rules/text.h"

#include <map>
#include <set>

namespace drawbead {

namespace {

/// "shell 5512" -> "shell"
std::string family_of(const std::string& subject) {
    const std::size_t blank = subject.rfind(' ');
    return blank == std::string::npos ? subject : subject.substr(0, blank);
}

/// What a drawbead refers to: two of these leave it open which one the bead means.
bool used_by_beads(const std::string& family) {
    return family == "interface" || family == "node group" || family == "surface" || family == "node";
}

/// Whether all nodes that share an id stand at one place: a copy, which changes nothing.
bool copies_only(const Model& model) {
    const NodeTable& nodes = model.nodes();
    if (nodes.x.size() < nodes.size()) return false;
    for (const uint32_t row : nodes.map.duplicates()) {
        const uint32_t first = nodes.map.row(nodes.id[row]);
        const Vec3 a = nodes.x[first], b = nodes.x[row];
        if (a.x != b.x || a.y != b.y || a.z != b.z) return false;
    }
    return true;
}

struct Twins {
    std::vector<const ReadIssue*> issues;
    uint64_t count = 0;
};

void check(const RuleContext& context, FindingSink& sink) {
    BlockFinder blocks(context.deck);
    std::map<std::string, Twins> rows; // of nodes and elements, told once per family
    for (const ReadIssue& issue : context.model.issues()) {
        if (issue.kind != ReadIssue::Kind::duplicate_id) continue;
        const std::string family = family_of(issue.subject);
        const Block* second = blocks.at(issue.place);
        const bool option = second && second->header.begin == issue.place.begin;
        if (!option) {
            rows[family].issues.push_back(&issue);
            rows[family].count += issue.count;
            continue;
        }
        const Block* first = blocks.at(issue.related);
        // Headers without an id all count as number 1; many of them are options that need none.
        if (!second->id_given || (first && !first->id_given)) continue;
        Draft draft;
        draft.primary = issue.place;
        draft.related.push_back(issue.related);
        draft.discriminator = issue.subject;
        if (!used_by_beads(family)) draft.severity = Severity::warning;
        draft.message = issue.subject + " is defined twice: " + (first ? header_name(*first) + " and " : "") +
                        header_name(*second);
        draft.help = "give one of them another id";
        sink.add(std::move(draft));
    }
    for (const auto& [family, twins] : rows) {
        Draft draft;
        std::vector<Span> places;
        for (const ReadIssue* issue : twins.issues)
            places.push_back(issue->place);
        set_places(draft, places);
        draft.place_count = twins.count;
        draft.discriminator = family;
        std::set<std::string> subjects; // whatever the order in which they were met
        for (const ReadIssue* issue : twins.issues)
            subjects.insert(issue->subject);
        for (const std::string& subject : subjects)
            draft.discriminator += " " + subject;
        if (!used_by_beads(family)) draft.severity = Severity::warning;
        draft.message = twins.issues.front()->subject + " is defined twice";
        if (twins.count > 1) draft.message += " (first of " + std::to_string(twins.count) + ")";
        if (twins.issues.front()->related.end != 0)
            draft.related.insert(draft.related.begin(), twins.issues.front()->related);
        if (family == "node" && copies_only(context.model)) {
            draft.severity = Severity::warning;
            draft.message += ", at one place";
        }
        draft.notes.push_back("a file that is included twice defines everything twice");
        draft.help = "remove one of them, or give it another id";
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SYN007{{.code = "SYN007",
                          .name = "duplicate-id",
                          .summary = "two nodes, interfaces, groups or surfaces have one id",
                          .severity = Severity::error},
                         Needs::coordinates,
                         check};

} // namespace drawbead
