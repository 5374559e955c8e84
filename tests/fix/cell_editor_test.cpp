// Cells are written in the columns, width and format of their line.
#include "deck/decks.h"
#include "fix/cell_editor.h"
#include "fix/number_text.h"
#include "model/cards/lists.h"
#include "model/cards/type8.h"

using namespace drawbead;

namespace {

/// The third data line of the last block and the deck around it.
struct Cards {
    explicit Cards(const std::string& block, const std::string& begin = begin_2022)
        : deck(read_deck(begin + block + "/END\n")) {
        DataLines lines(deck, deck.blocks().back());
        for (Span one; lines.next(one);)
            line.push_back(one);
    }
    Card card(std::size_t i, const CardSchema& schema) const {
        return read_card(deck, deck.blocks().back().scope, line.at(i), schema);
    }
    /// The last block after the changes.
    std::string after(CellEditor& editor) const {
        const EditList edits = editor.edits();
        const uint64_t begin = deck.blocks().back().header.begin;
        std::string text = edited(deck.files()[0]->bytes(), edits).substr(begin);
        return text.substr(0, text.find("/END"));
    }
    Deck deck;
    std::vector<Span> line;
};

const std::string bead = "/INTER/TYPE8/7\nbead\n         1         2                   2\n"
                         "                50.0                20.0\n";

} // namespace

TEST_CASE("a field is written in its columns, and the line grows when it must") {
    const Cards cards(bead);
    CellEditor editor(cards.deck);
    editor.set_cell(cards.card(1, type8_references), "surf_IDm", "12");
    editor.set_cell(cards.card(2, type8_forces), "Depth", "2.5");
    editor.set_cell(cards.card(2, type8_forces), "Fn", "");
    CHECK(cards.after(editor) == "/INTER/TYPE8/7\nbead\n         1        12                   2\n"
                                 "                                    20.0                 2.5\n");
}

TEST_CASE("a parameter is replaced in the cell") {
    const Cards cards("/PARAMETER/GLOBAL/INTEGER/1\np\nSURF              2\n/INTER/TYPE8/7\nbead\n"
                      "         1     &SURF                   2\n");
    CellEditor editor(cards.deck);
    editor.set_cell(cards.card(1, type8_references), "surf_IDm", "3");
    CHECK(cards.after(editor) == "/INTER/TYPE8/7\nbead\n         1         3                   2\n");
}

TEST_CASE("a line with commas is changed between its commas") {
    const Cards cards("/INTER/TYPE8/7\nbead\n1,2,,2\n");
    CellEditor editor(cards.deck);
    editor.set_cell(cards.card(1, type8_references), "surf_IDm", "13");
    CHECK(cards.after(editor) == "/INTER/TYPE8/7\nbead\n1,13,,2\n");
}

TEST_CASE("what the layout does not have, or what does not fit, fails as a whole") {
    const Cards cards(bead, begin_of(2021));
    CellEditor editor(cards.deck);
    editor.set_cell(cards.card(1, type8_references), "surf_IDm", "12");
    editor.set_cell(cards.card(2, type8_last), "Fn_last", "1.0");
    CHECK(editor.failed());
    CHECK(editor.edits().empty());

    CellEditor narrow(cards.deck);
    narrow.set_columns(cards.line[1], 1, 4, "12345");
    CHECK(narrow.failure() == "'12345' does not fit its columns");
}

TEST_CASE("an id of a list keeps its last digit in place where there is room") {
    const Cards cards("/SURF/PART/1\ns\n         1        22  3               4\n");
    CellEditor editor(cards.deck);
    const auto place = [&](const std::string& text) {
        const uint64_t at = cards.line[1].begin + cards.deck.text(cards.line[1]).find(text);
        return Span{cards.line[1].file, at, at + text.size()};
    };
    const ScopeId scope = cards.deck.blocks().back().scope;
    editor.set_listed_id(scope, place("1"), -1);
    editor.set_listed_id(scope, place("22"), 7);
    editor.set_listed_id(scope, place("3"), -333);
    editor.set_listed_id(scope, place("4"), -4);
    CHECK(cards.after(editor) == "/SURF/PART/1\ns\n        -1         7-333             -4\n");
}

TEST_CASE("the id of a header") {
    for (const auto& [before, after] : {std::pair<std::string, std::string>{"/SURF/PART/1", "/SURF/PART/25"},
                                        {"/INTER/TYPE8/      7/3", "/INTER/TYPE8/      25/3"},
                                        {"/BCS/&id", "/BCS/25"}}) {
        const Cards cards(before + "\nt\n");
        CellEditor editor(cards.deck);
        editor.set_header_id(static_cast<BlockIndex>(cards.deck.blocks().size() - 1), 25);
        CHECK(cards.after(editor) == after + "\nt\n");
    }
}

TEST_CASE("whole lines are deleted, and changes that meet fail") {
    const Cards cards(bead);
    CellEditor editor(cards.deck);
    editor.delete_lines(cards.line[2]);
    CHECK(cards.after(editor) == "/INTER/TYPE8/7\nbead\n         1         2                   2\n");

    CellEditor meeting(cards.deck);
    meeting.delete_lines(cards.line[1]);
    meeting.set_columns(cards.line[1], 1, 10, "3");
    meeting.edits();
    CHECK(meeting.failed());
}

TEST_CASE("numbers read back as the same value, in the unit of the cell") {
    CHECK(real_text(5) == "5.0");
    CHECK(real_text(0.1) == "0.1");
    CHECK(real_text(1e-6) == "1e-06");
    CHECK(real_text(-1.0 / 3) == "-0.3333333333333333");
    CHECK(real_text(1.0 / 3, 8) == ".3333333");
    CHECK(real_text(0.0012345678901234567) == ".0012345678901234567");
    CHECK(real_text(123456789.0, 5).empty());

    const Deck deck = read_deck(begin_2022 + "/UNIT/3\nu\n                  kg                   m"
                                             "                   s\n/INTER/TYPE8/7/3\nbead\n/END\n");
    const Block& block = deck.blocks().back();
    const double factor = *deck.factor(block.scope, block.unit, force_per_length_dimension);
    CHECK(parse_real(cell_text(deck, block, force_per_length_dimension, 50)).value * factor == 50);
    // Not every number is a product of the factor: then the nearest one.
    for (const double value : {0.1, 1e-6 / 3, 12345.678}) {
        const std::string text = cell_text(deck, block, force_per_length_dimension, value);
        CHECK(std::abs(parse_real(text).value * factor - value) <= 2.3e-16 * value);
    }
}
