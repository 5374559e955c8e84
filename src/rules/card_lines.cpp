#include "rules/card_lines.h"

#include <algorithm>
#include <string_view>

namespace drawbead {

namespace {

constexpr int first_layout_with_last = 2022;
constexpr int first_layout_with_titles = 51;

std::vector<std::string_view> tokens_of(std::string_view line) {
    std::vector<std::string_view> tokens;
    constexpr std::string_view separators = " \t,\r";
    for (std::size_t at = 0; (at = line.find_first_not_of(separators, at)) != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(separators, at), line.size());
        tokens.push_back(line.substr(at, end - at));
        at = end;
    }
    return tokens;
}

bool is_reference(std::string_view token) {
    return token[0] == '&' || token.substr(0, 2) == "-&";
}

bool is_integer(std::string_view token) {
    if (is_reference(token)) return true;
    if (token[0] == '-' || token[0] == '+') token.remove_prefix(1);
    return !token.empty() &&
           std::all_of(token.begin(), token.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool is_number(std::string_view token) {
    return is_reference(token) || parse_real(token).state == NumberState::ok;
}

/// Two to four whole numbers: group, surface, Iform.
bool looks_like_card_1(std::string_view line) {
    const auto tokens = tokens_of(line);
    return tokens.size() >= 2 && tokens.size() <= 4 && std::all_of(tokens.begin(), tokens.end(), is_integer);
}

/// Numbers, of which one has a point or an exponent, or more of them than the first card holds.
bool looks_like_forces(std::string_view line) {
    const auto tokens = tokens_of(line);
    if (tokens.empty() || !std::all_of(tokens.begin(), tokens.end(), is_number)) return false;
    return tokens.size() > 4 || std::any_of(tokens.begin(), tokens.end(),
                                            [](std::string_view token) { return !is_integer(token); });
}

/// Whether anything stands behind the second real of a card.
bool has_third_field(std::string_view line) {
    if (line.find(',') != std::string_view::npos) return std::count(line.begin(), line.end(), ',') >= 2;
    return line.size() > 40 && !trim(line.substr(40)).empty();
}

CardLines::Missing missing_of(const std::vector<std::string_view>& line, int layout) {
    using Missing = CardLines::Missing;
    const auto blank = [&](std::size_t i) { return i >= line.size() || trim(line[i]).empty(); };
    const auto filled = [&](std::size_t i) { return !blank(i); };
    const bool any =
        std::any_of(line.begin(), line.end(), [](std::string_view l) { return !trim(l).empty(); });
    if (!any) return Missing::all;
    const bool card_1_in_second = filled(1) && looks_like_card_1(line[1]);
    const bool forces_in_second = filled(1) && looks_like_forces(line[1]);
    if (looks_like_card_1(line[0]) && !card_1_in_second && (forces_in_second || blank(1)))
        return Missing::title;
    if (forces_in_second && blank(3)) return Missing::card_1;
    if (line.size() < 2) return Missing::card_1;
    if (layout < first_layout_with_last) {
        if (blank(2)) return Missing::card_2;
        return line.size() < 4 ? Missing::blank_card : Missing::nothing;
    }
    if (line.size() < 3 || (line.size() == 3 && blank(2))) return Missing::card_2;
    if (line.size() == 3) return has_third_field(line[2]) ? Missing::card_3 : Missing::card_2_or_3;
    return Missing::nothing;
}

} // namespace

CardLines card_lines(const Deck& deck, const Drawbead& bead) {
    CardLines cards;
    const Block& block = deck.blocks()[bead.block];
    const int layout = deck.scope(block.scope).layout;
    if (layout < first_layout_with_titles) return cards;
    DataLines lines(deck, block);
    for (Span line; lines.next(line);)
        cards.lines.push_back(line);
    while (cards.lines.size() > 4 && trim(deck.text(cards.lines.back())).empty())
        cards.lines.pop_back();

    std::vector<std::string_view> texts;
    for (const Span& line : cards.lines)
        texts.push_back(deck.text(line));
    cards.missing = missing_of(texts, layout);
    cards.shifted = texts.size() > 4 && !looks_like_card_1(texts[1]) && looks_like_card_1(texts[2]);
    if (cards.shifted) cards.missing = CardLines::Missing::nothing;
    for (std::size_t i = 1; i < texts.size() && i <= 3; ++i)
        cards.fault[i - 1] = i == 1 ? column_fault(texts[i], columns_of_ten, card_width)
                                    : column_fault(texts[i], columns_of_twenty, card_width);
    return cards;
}

} // namespace drawbead
