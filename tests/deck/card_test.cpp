#include "deck/card.h"

#include "decks.h"

#include <array>

using namespace drawbead;

namespace {

constexpr std::array<Field, 5> fields{{{"grnd", 1, 10, Kind::integer},
                                       {"surf", 11, 10, Kind::integer},
                                       {"iform", 21, 10, Kind::integer, dimensionless, 100, 100},
                                       {"iform", 31, 10, Kind::integer, dimensionless, 110, newest_layout},
                                       {"value", 41, 20, Kind::real, length_dimension, 2022, newest_layout}}};
constexpr CardSchema schema{"example", fields};

struct Read {
    Deck deck;
    Card card;
};

Read read(int version, const std::string& line) {
    Deck deck = read_deck(begin_of(version) + "/X/1\n" + line + "\n/END\n");
    const Block& block = deck.blocks().back();
    REQUIRE(block.keyword == "X");
    DataLines lines(deck, block);
    Span place;
    REQUIRE(lines.next(place));
    Card card = read_card(deck, block.scope, place, schema);
    return {std::move(deck), std::move(card)};
}

} // namespace

TEST_CASE("fields stand where the layout of the version says") {
    const Read old = read(100, "         5         7         1         2");
    CHECK(old.card["grnd"].integer == 5);
    CHECK(old.card["iform"].integer == 1);
    CHECK(old.card["value"].state == CellState::absent);
    const Read now = read(2022, "         5         7         1         2                 1.5");
    CHECK(now.card["iform"].integer == 2);
    CHECK(now.card["value"].real == 1.5);
    CHECK(now.deck.text(now.card["value"].place) == "1.5");
    CHECK(now.deck.at(now.card["value"].place).line == 8);
    CHECK(now.deck.at(now.card["value"].place).column == 58);
    const Read unknown = read(105, "         5         7         1         2");
    CHECK(unknown.card["iform"].integer == 2);
    CHECK(count(unknown.deck, Notice::Kind::version_unknown) == 1);
}

TEST_CASE("a comma makes a line free-format, and gaps of the layout count as fields") {
    const Read free = read(2022, "5,7,,2,3.5");
    CHECK(free.card.free_format);
    CHECK(free.card["grnd"].integer == 5);
    CHECK(free.card["surf"].integer == 7);
    CHECK(free.card["iform"].integer == 2);
    CHECK(free.card["value"].real == 3.5);
    const Read mixed = read(2022, " 5 7 ,, 2");
    CHECK(mixed.card["surf"].integer == 7);
    CHECK(mixed.card["iform"].integer == 2);
    CHECK(mixed.card["value"].state == CellState::blank);
}

TEST_CASE("words among numbers have a free format, cards of words alone have none") {
    static constexpr std::array<Field, 3> mixed{
        {{"funct", 1, 10, Kind::integer}, {"dir", 11, 10, Kind::text}, {"grnd", 31, 10, Kind::integer}}};
    static constexpr CardSchema mixed_card{"mixed", mixed},
        words_card{"words", std::span(mixed).subspan(1, 1)};
    const Deck deck = read_deck(begin_2022 + "/X/1\n 4,X,, 7\n/Y/1\n          a, b\n/END\n");
    const auto line_of = [&](std::size_t block) {
        DataLines lines(deck, deck.blocks()[block]);
        Span line;
        REQUIRE(lines.next(line));
        return line;
    };
    const Card free = read_card(deck, ScopeId{0}, line_of(1), mixed_card);
    CHECK(free.free_format);
    CHECK(free["funct"].integer == 4);
    CHECK(free["dir"].text == "X");
    CHECK(free["grnd"].integer == 7);
    const Card words = read_card(deck, ScopeId{0}, line_of(2), words_card);
    CHECK_FALSE(words.free_format);
    CHECK(words["dir"].text == "a, b");
}

TEST_CASE("cells keep what the solver would lose") {
    const Read cells = read(2022, "     1 2 3       abc          9999999999        1.0.2");
    CHECK(cells.card["grnd"].state == CellState::trailing);
    CHECK(cells.card["grnd"].integer == 1);
    CHECK(cells.card["surf"].state == CellState::garbage);
    CHECK(cells.card["iform"].state == CellState::not_finite);
    CHECK(cells.card["value"].state == CellState::garbage);
    CHECK(read(2022, "").card["grnd"].state == CellState::blank);
}

TEST_CASE("parameters are replaced in cells, local ones first") {
    const std::string text = begin_2022 +
                             "/PARAMETER/GLOBAL/INTEGER/1\ngroup\nGRP               12\n"
                             "/PARAMETER/GLOBAL/REAL/2\nreal\nR                          2.5\n"
                             "/PARAMETER/LOCAL/REAL/3\nreal\nR                          3.5\n"
                             "/PARAMETER/GLOBAL/REAL_EXPR/4\nexpr\nTWICE     2*(R+GRP)/5-1\n"
                             "/X/&GRP\n      &GRP     -&GRP                              &TWICE\n"
                             "/X/2\n     &NONE\n/END\n";
    const Deck deck = read_deck(text);
    const Block& block = deck.blocks()[5];
    CHECK(block.id == 12);
    DataLines lines(deck, block);
    Span line;
    REQUIRE(lines.next(line));
    const Card card = read_card(deck, block.scope, line, schema);
    CHECK(card["grnd"].integer == 12);
    CHECK(card["surf"].integer == -12);
    CHECK(card["value"].real == 2 * (3.5 + 12) / 5 - 1);
    DataLines more(deck, deck.blocks()[6]);
    REQUIRE(more.next(line));
    CHECK(read_card(deck, deck.root().parent, line, schema)["grnd"].state == CellState::unknown_parameter);
}
