#include "rules/kin/path_report.h"

#include "rules/analysis.h"
#include "rules/limits.h"
#include "rules/lin/bead_report.h"
#include "rules/text.h"

#include <algorithm>

namespace drawbead {

const BeadPath* path_of(const RuleContext& context, const BeadAnalysis& a) {
    const std::vector<BeadPath>& all = context.analysis.path;
    const auto at = static_cast<std::size_t>(&a - context.analysis.beads.data());
    return at < all.size() && all[at].known() ? &all[at] : nullptr;
}

Affected affected(const BeadAnalysis& a, const BeadPath& path,
                  const std::function<double(const NodePath&)>& share) {
    Affected out;
    for (const NodePath& node : path.node) {
        const double part = share(node);
        if (part == 0) continue;
        for (std::size_t i = node.begin; i < node.end && i < a.x.size(); ++i) {
            out.place.push_back(i);
            out.fn += part * a.fn_force(i);
            out.ft += part * a.ft_force(i);
            out.length += a.line.tributary[i];
        }
    }
    return out;
}

Draft draft_at_affected(const RuleContext& context, const BeadAnalysis& a, const Affected& nodes) {
    const std::vector<Span> places = list_places(context, a);
    Draft draft = draft_at_position(context, a, places, nodes.place.front());
    for (const std::size_t i : nodes.place) {
        draft.entities.nodes.add(node_id(context, a, i));
        if (i != nodes.place.front() && draft.related.size() < 99) draft.related.push_back(places[i]);
    }
    draft.place_count = nodes.place.size();
    return draft;
}

bool moves_sideways(const RuleContext& context, const BeadAnalysis& a, const NodePath& node) {
    const Limits& limits = context.limits;
    return node.tool_way > limits.KIN003_way_depths * std::max(a.bead->depth, 0.0) &&
           node.tool_way > limits.KIN003_way_elements * node.element;
}

void note_blank(const BeadPath& path, Draft& draft) {
    if (path.blank_known()) return;
    draft.notes.push_back("nothing prescribes the blank under the bead (" + path.blank_unknown +
                          "); it is taken as at rest, and as pushed along where the bead goes through it");
}

std::string end_text(const RuleContext& context) {
    const RunFacts& run = context.analysis.run;
    if (run.scene_end) return "the scene ends at " + time_text(context, *run.scene_end);
    if (run.engine && run.engine->end)
        return run.engine->path + " ends the run at " + time_text(context, *run.engine->end);
    return "";
}

std::string time_text(const RuleContext& context, double time) {
    return quantity(time, context.deck.work_units(), time_dimension, 3);
}

std::string length_text(const RuleContext& context, double length) {
    return quantity(length, context.deck.work_units(), length_dimension, 3);
}

std::string speed_text(const RuleContext& context, double speed) {
    const UnitSystem& units = context.deck.work_units();
    const std::string length = unit_name(units, length_dimension), time = unit_name(units, time_dimension);
    return number(speed, 3) + (length.empty() || time.empty() ? "" : " " + length + "/" + time);
}

} // namespace drawbead
