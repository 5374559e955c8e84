#include "rules/support.h"
#include "rules/text.h"

namespace drawbead {

namespace {

/// Whether the last block of an included file reaches its end without an #enddata.
bool ends_its_file(const Deck& deck, const Block& block) {
    const SourceFile& file = deck.file(block.text.file);
    return block.text.file != deck.root().file && block.text.end == file.bytes().size() &&
           deck.text(block.text).find("#enddata") == std::string_view::npos;
}

constexpr const char* title = "#enddata at the end of the file";

void check(const RuleContext& context, FindingSink& sink) {
    const Deck& deck = context.deck;
    for (const Notice& notice : deck.notices()) {
        Draft draft;
        draft.primary = notice.place;
        const std::string path = quoted(notice.subject, 200);
        if (notice.kind == Notice::Kind::include_text_dropped) {
            draft.message = "data before the first keyword of the include " + path +
                            " are dropped: they do not continue the block of the file that includes it";
            draft.help = "put a header before them";
        } else if (notice.kind == Notice::Kind::data_after_enddata) {
            draft.message = "data follow #enddata in " + path + ": readers differ in whether they are read";
            draft.help = "remove #enddata, or what follows it";
        } else {
            continue;
        }
        draft.discriminator =
            notice.subject + (notice.kind == Notice::Kind::data_after_enddata ? " after" : " before");
        sink.add(std::move(draft));
    }
    for (const NodeGroup& group : context.model.groups()) {
        const Block& block = deck.blocks()[group.block];
        if (!ends_its_file(deck, block)) continue;
        Draft draft;
        draft.primary = block.header;
        draft.discriminator = "group " + std::to_string(group.id);
        draft.message =
            "node group " + std::to_string(group.id) +
            " is the last block of an include without #enddata: some releases of the solver lose it";
        draft.help = "end the file with a line #enddata";
        draft.fixes.push_back({title, FixAvailability::safe});
        sink.add(std::move(draft));
    }
}

std::optional<Fix> fix(const RuleContext& context, const Draft& draft, FixPlanner& planner) {
    const Deck& deck = context.deck;
    for (const NodeGroup& group : context.model.groups()) {
        if (draft.discriminator != "group " + std::to_string(group.id)) continue;
        const Block& block = deck.blocks()[group.block];
        const std::string_view bytes = deck.file(block.text.file).bytes();
        const std::string line_end = block_end(deck, group.block).line_end;
        const bool ended = bytes.empty() || bytes.back() == '\n';
        planner.cells().replace({block.text.file, bytes.size(), bytes.size()},
                                ended ? "#enddata" + line_end : line_end + "#enddata");
        return Fix{title, FixAvailability::safe, {}};
    }
    return planner.decline("what was meant is not known");
}

} // namespace

extern const Rule SYN011{
    {.code = "SYN011",
     .name = "include-without-enddata",
     .summary = "data around the beginning or end of an include that readers drop or may drop",
     .severity = Severity::warning,
     .fix = FixAvailability::sometimes_safe},
    Needs::none,
    check,
    Needs::none,
    fix};

} // namespace drawbead
