#include "rules/rule.h"
#include "rules/text.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace drawbead {

namespace {

/// First layouts in which some column of a card that the tool reads has moved: of all cards, and of the
/// drawbead alone.
constexpr int first_layout_of_tens = 51;
constexpr std::array drawbead_layouts{100, 110, 130, 2022};

std::ptrdiff_t drawbead_columns(int layout) {
    return std::upper_bound(drawbead_layouts.begin(), drawbead_layouts.end(), layout) -
           drawbead_layouts.begin();
}

bool is_within(const Deck& deck, ScopeId scope, FileId file) {
    for (;; scope = deck.scope(scope).parent) {
        if (deck.scope(scope).file == file) return true;
        if (index(scope) == 0) return false;
    }
}

/// Whether it makes a difference which version the file of a /BEGIN is read in.
bool matters(const Deck& deck, const Span& begin) {
    const int main_layout = deck.root().layout;
    return std::any_of(deck.blocks().begin(), deck.blocks().end(), [&](const Block& block) {
        const int layout = deck.scope(block.scope).layout;
        if (layout == main_layout || !is_within(deck, block.scope, begin.file)) return false;
        if ((layout < first_layout_of_tens) != (main_layout < first_layout_of_tens)) return true;
        return block.keyword.substr(0, 11) == "INTER/TYPE8" &&
               drawbead_columns(layout) != drawbead_columns(main_layout);
    });
}

void check(const RuleContext& context, FindingSink& sink) {
    for (const Notice& notice : context.deck.notices()) {
        Draft draft;
        draft.primary = notice.place;
        draft.discriminator = notice.subject;
        if (notice.kind == Notice::Kind::version_in_include) {
            if (!matters(context.deck, notice.place)) continue;
            draft.message = "/BEGIN in an include says version " + notice.subject + ", the deck says " +
                            notice.detail + ": the manual ignores it, readers take it for this file";
            draft.help = "use one version in all files";
        } else if (notice.kind == Notice::Kind::submodel_version) {
            draft.message = quoted(notice.subject) +
                            " on //SUBMODEL is not applied by readers: its cards are read in the "
                            "layout of the main file";
            draft.help = "convert the submodel to the version of the main file";
        } else {
            continue;
        }
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SYN016{{.code = "SYN016",
                          .name = "version-disputed",
                          .summary = "an include or submodel names another version than the deck",
                          .severity = Severity::warning},
                         Needs::none,
                         check};

} // namespace drawbead
