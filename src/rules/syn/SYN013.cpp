#include "rules/rule.h"
#include "rules/text.h"

namespace drawbead {

namespace {

Span last_line(const Deck& deck, FileId id) {
    const SourceFile& file = deck.file(id);
    const uint64_t size = file.bytes().size();
    const uint64_t begin = size == 0 ? 0 : file.line_begin(size - 1);
    return {id, begin, size};
}

void check(const RuleContext& context, FindingSink& sink) {
    for (const Notice& notice : context.deck.notices()) {
        if (notice.kind != Notice::Kind::end_missing && notice.kind != Notice::Kind::submodel_not_closed)
            continue;
        Draft draft;
        draft.primary = notice.place;
        if (notice.kind == Notice::Kind::end_missing) {
            draft.primary = last_line(context.deck, notice.place.file);
            draft.message = "the deck has no /END: it may be cut off";
            draft.help = "compare the end of the file with its source, and close it with /END";
            draft.discriminator = "END";
        } else {
            draft.message = "the //SUBMODEL is not closed: it reaches to the end of the file";
            draft.help = "close it with //ENDSUB";
            draft.discriminator = "ENDSUB";
        }
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SYN013{{.code = "SYN013",
                          .name = "end-missing",
                          .summary = "the deck has no /END, or a submodel no //ENDSUB",
                          .severity = Severity::warning},
                         Needs::none,
                         check};

} // namespace drawbead
