#include "rules/support.h"

namespace drawbead {

namespace {

void check(const RuleContext& context, FindingSink& sink) {
    for (const Drawbead& bead : context.model.drawbeads()) {
        if (!cards_usable(context, bead)) continue;
        const Cell& cell = cells_of(bead).surface;
        if (!readable(cell)) continue;
        Draft draft = draft_at(context, bead, cell);
        draft.help = "name a /SURF that holds the blank under the bead";
        const std::string id = std::to_string(bead.surface_id);
        std::string lost = bead.surface_id != 0 ? lost_include_note(context.deck) : std::string();
        if (bead.surface) {
            const Surface& surface = context.model.surfaces()[*bead.surface];
            if (!surface.evaluated || !surface.segments.empty()) continue;
            draft.related.push_back(context.deck.blocks()[surface.block].header);
            draft.message =
                "surface " + id + " of " + bead_name(bead) + " holds no segment: the Starter stops";
            if (lost.empty() && (surface.type == "PART" || surface.type == "SUBSET" ||
                                 surface.type == "MAT" || surface.type == "PROP"))
                draft.notes.push_back("/SURF/" + surface.type + " takes shells only; solids need /SURF/" +
                                      surface.type + "/EXT");
        } else if (bead.surface_id == 0) {
            draft.message = bead_name(bead) +
                            " names no main surface: the solver goes on with a surface of its own choice";
        } else {
            draft.message = "surface " + id + " of " + bead_name(bead) + " is not defined: the Starter stops";
        }
        if (!lost.empty()) draft.notes.push_back(std::move(lost));
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule REF002{
    {.code = "REF002",
     .name = "surface-undefined",
     .summary = "a drawbead names no main surface, or one that does not exist or is empty",
     .severity = Severity::error},
    Needs::blank_elements,
    check};

} // namespace drawbead
