#include "rules/support.h"
#include "rules/text.h"

#include <algorithm>
#include <array>
#include <map>

namespace drawbead {

namespace {

/// First fields of what a drawbead needs, or what the end of the deck hangs on.
constexpr std::array<std::string_view, 35> read_options{
    "ADMESH", "BCS",    "BOX",    "BRIC20", "BRICK",  "CNODE",   "END",    "FUNCT",    "GRBRIC",
    "GRNOD",  "GRSH3N", "GRSHEL", "GRTRIA", "IMPACC", "IMPDISP", "IMPVEL", "INIVEL",   "INTER",
    "LINE",   "MAT",    "NODE",   "PART",   "PENTA6", "PLY",     "PROP",   "RBODY",    "SET",
    "SH3N",   "SHEL16", "SHELL",  "SUBSET", "SURF",   "TETRA10", "TETRA4", "TRANSFORM"};
/// Those whose further fields are key words too.
constexpr std::array<std::string_view, 4> typed_options{"GRNOD", "INTER", "SET", "SURF"};

constexpr bool is_small(char c) {
    return c >= 'a' && c <= 'z';
}

std::string capitals(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if (is_small(c)) c = static_cast<char>(c - ('a' - 'A'));
    return result;
}

/// The keyword in capitals, where the solver would have read it; empty where it is none, or is in capitals.
std::string meant(std::string_view keyword) {
    const std::string_view first = keyword.substr(0, keyword.find('/'));
    const std::string option = capitals(first);
    const auto names = [&](const auto& list) {
        return std::find(list.begin(), list.end(), option) != list.end();
    };
    if (!names(read_options)) return {};
    const std::string_view words = names(typed_options) ? keyword : first;
    return std::any_of(words.begin(), words.end(), is_small) ? capitals(keyword) : std::string{};
}

void check(const RuleContext& context, FindingSink& sink) {
    std::map<std::string_view, std::vector<Span>> all;
    for (const Block& block : context.deck.blocks())
        if (!meant(block.keyword).empty()) all[block.keyword].push_back(block.header);
    for (const auto& [keyword, places] : all) {
        const std::string capital = meant(keyword);
        Draft draft;
        set_places(draft, places);
        draft.discriminator = std::string(keyword);
        if (capital.substr(0, 11) == "INTER/TYPE8") draft.severity = Severity::error;
        draft.message = "the keyword " + quoted('/' + std::string(keyword)) +
                        " is not in capitals: the solver skips the block";
        if (places.size() > 1) draft.message += " (first of " + std::to_string(places.size()) + ")";
        draft.help = "write /" + capital;
        sink.add(std::move(draft));
    }
}

} // namespace

extern const Rule SYN018{{.code = "SYN018",
                          .name = "keyword-lower-case",
                          .summary = "a keyword is written in small letters, and its block is skipped",
                          .severity = Severity::warning},
                         Needs::none,
                         check};

} // namespace drawbead
