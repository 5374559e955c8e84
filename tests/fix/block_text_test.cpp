// New blocks take over layout, width and line ends; free ids are free in every instance.
#include "deck/decks.h"
#include "fix/planner.h"
#include "model/cards/type8.h"

using namespace drawbead;

namespace {

struct Planning {
    explicit Planning(const Deck& d)
        : deck(d), index(deck, log), model(Model::build(deck, Needs::coordinates, 1)),
          ids(deck, index, model), planner(deck, index, ids, choices) {}
    BlockIndex block(std::string_view keyword) const {
        for (BlockIndex i = 0; i < deck.blocks().size(); ++i)
            if (deck.blocks()[i].keyword == keyword) return i;
        FAIL("no block " << keyword);
        return 0;
    }
    const Deck& deck;
    IssueLog log;
    OptionIndex index;
    Model model;
    FreeIds ids;
    FixChoices choices;
    FixPlanner planner;
};

const std::string surface = "/SURF/PART/4\nblank\n         1\n";

} // namespace

TEST_CASE("a block after the last data line of another, before comments that follow it") {
    const std::string text = begin_2022 + surface + "# the bead\n/GRNOD/NODENS/1\nb\n         1\n/END\n";
    const Deck deck = read_deck(text);
    Planning p(deck);
    const BlockIndex served = p.block("SURF/PART");
    BlockWriter writer(deck, served);
    const std::vector<int64_t> ids{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, -11};
    writer.header("GRSHEL/SHEL", p.planner.free_id(Family::shell_group, served), "turned");
    writer.ids(ids);
    p.planner.add_after(served, writer.text());
    CHECK(edited(text, p.planner.edits()) ==
          begin_2022 + surface +
              "/GRSHEL/SHEL/1\nturned\n         1         2         3         4         5         6         7"
              "         8         9        10\n       -11\n"
              "# the bead\n/GRNOD/NODENS/1\nb\n         1\n/END\n");
}

TEST_CASE("line ends of Windows, and a file without a last line end") {
    const std::string text = "/BEGIN\r\nrun\r\n      2022\r\n/SURF/PART/4\r\nblank\r\n         1";
    const Deck deck = read_deck(text);
    Planning p(deck);
    BlockWriter writer(deck, p.block("SURF/PART"));
    writer.header("SURF/PART", 5, "other");
    p.planner.add_after(p.block("SURF/PART"), writer.text());
    CHECK(edited(text, p.planner.edits()) == text + "\r\n/SURF/PART/5\r\nother");
}

TEST_CASE("narrow layouts: eight columns, and titles where the neighbour has them") {
    const Deck deck = read_deck("/BEGIN\nrun\n      44\n/SURF/PART/4/blank\n       1\n/END\n");
    BlockWriter writer(deck, 1);
    writer.header("SURF/PART", 5, "other");
    writer.ids(std::vector<int64_t>{1, -2});
    CHECK(writer.text() == "/SURF/PART/5/other\n       1      -2\n");
}

TEST_CASE("a card has the fields of its version") {
    const Deck deck = read_deck(begin_of(100) + "/INTER/TYPE8/1\nx\n/END\n");
    BlockWriter writer(deck, 1);
    writer.card(type8_references, {{"grnd_IDs", "1"}, {"surf_IDm", "2"}, {"Iform", "1"}});
    writer.card(type8_forces, {{"Fn", "1.0"}, {"Ft", "2.0"}});
    CHECK(writer.text() == "         1         2         1\n                                     2.0\n");
}

TEST_CASE("a copy of an interface with other ids keeps its comments, and leaves includes out") {
    MemoryReader files;
    files.add("note.inc", "just a note\n");
    const Deck deck =
        read_deck(begin_2022 + "/INTER/TYPE8/7/2\nbead\n# grnd_IDs  surf_IDm               Iform\n"
                               "         1         2                   2\n#include note.inc\n"
                               "                50.0\n/END\n",
                  files);
    BlockCopy copy(deck, 1);
    copy.cells().set_header_id(1, 8);
    DataLines lines(deck, deck.blocks()[1]);
    Span line;
    REQUIRE(lines.next(line));
    REQUIRE(lines.next(line));
    copy.cells().set_cell(read_card(deck, deck.blocks()[1].scope, line, type8_references), "grnd_IDs", "3");
    CHECK(copy.text() == "/INTER/TYPE8/8/2\nbead\n# grnd_IDs  surf_IDm               Iform\n"
                         "         3         2                   2\n                50.0\n");
}

TEST_CASE("free ids are above all of their family and of the sets, in every instance of a file") {
    MemoryReader files;
    files.add("part.inc", "/GRNOD/NODENS/3\ng\n         1\n/NODE\n         1\n");
    const Deck deck = read_deck(
        begin_2022 +
            "//SUBMODEL/1\na\n      1000       100\n#include part.inc\n//ENDSUB\n"
            "//SUBMODEL/2\nb\n      2000       200\n#include part.inc\n//ENDSUB\n/SET/GENERAL/2500\ns\n"
            "SHELL              1\n/GRNOD/NODE/7\nt\n         1\n/INTER/TYPE8/4\nbead\n         7\n"
            "/END\n",
        files);
    Planning p(deck);
    const BlockIndex served = p.block("GRNOD/NODENS");
    CHECK(instances_of(deck, served).size() == 2);
    CHECK(p.planner.free_id(Family::node_group, served) == 1501); // 2501 and 3501 for the solver
    CHECK(p.planner.free_id(Family::node_group, p.block("GRNOD/NODE")) == 3502);
    CHECK(p.planner.free_id(Family::interface, served) == 1);
    CHECK(p.planner.free_node_id(served) == 102); // nodes 101 and 201 are there
    CHECK(p.planner.free_node_id(p.block("GRNOD/NODE")) == 303);
}
