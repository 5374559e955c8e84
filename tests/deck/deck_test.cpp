#include "decks.h"

using namespace drawbead;

namespace {

std::vector<std::string> keywords(const Deck& deck) {
    std::vector<std::string> words;
    for (const Block& block : deck.blocks())
        words.emplace_back(block.keyword);
    return words;
}

using Words = std::vector<std::string>;

} // namespace

TEST_CASE("keyword lines: ids, padding, units, text behind") {
    const Deck deck =
        read_deck(begin_2022 + "/GRNOD/NODE/      12\n/BCS/       1/    2\n/PROP/SH_SANDW/         2/\n"
                               "/MAT/LAW2/1/3\n/INTER/TYPE8/7 text\n/SHFRA/V4\n/TITLE\nx\n/ANALY\n"
                               "/GRNOD/NODE      14\n/SURF/PART/EXT/5\n/END\n");
    const auto blocks = deck.blocks();
    CHECK(keywords(deck) == Words{"BEGIN", "GRNOD/NODE", "BCS", "PROP/SH_SANDW", "MAT/LAW2", "INTER/TYPE8",
                                  "SHFRA/V4", "TITLE", "ANALY", "GRNOD/NODE", "SURF/PART/EXT"});
    CHECK(blocks[1].id == 12);
    CHECK(blocks[2].id == 1);
    CHECK(blocks[2].unit == 0);
    CHECK(blocks[3].id == 2);
    CHECK(blocks[4].id == 1);
    CHECK(blocks[4].unit == 3);
    CHECK(blocks[5].id == 7);
    CHECK_FALSE(blocks[6].id_given);
    CHECK(blocks[6].id == 1);
    CHECK(blocks[9].id == 14);
    CHECK(blocks[10].id == 5);
}

TEST_CASE("an include is transparent for the block around it, and its loose text is dropped") {
    MemoryReader files;
    files.add("mesh", "         9\n# licence\n/NODE\n         1\n");
    const Deck deck =
        read_deck(begin_2022 + "/GRNOD/NODENS/1\nline\n         1\n#include mesh\n         2\n/END\n", files);
    CHECK(keywords(deck) == Words{"BEGIN", "GRNOD/NODENS", "NODE"});
    DataLines lines(deck, deck.blocks()[1]);
    Span line;
    Words read;
    while (lines.next(line))
        read.emplace_back(lines.text(line));
    CHECK(read == Words{"line", "         1", "         2"});
    CHECK(count(deck, Notice::Kind::include_text_dropped) == 1);
    REQUIRE(deck.files().size() == 2);
    CHECK(deck.files()[1]->path() == "mesh");
}

TEST_CASE("licence texts dropped from an include are not reported") {
    MemoryReader files;
    files.add("qadiags.inc", "Copyright of somebody\nAll rights\n");
    const Deck deck = read_deck(begin_2022 + "#include qadiags.inc\n/END\n", files);
    CHECK(deck.notices().empty());
}

TEST_CASE("include paths: relative to the including file, then to the main one; quotes and continuations") {
    MemoryReader files;
    files.add("sub/a.inc", "#include b.inc\n#include main_side.inc\n");
    files.add("sub/b.inc", "/A/1\n");
    files.add("main_side.inc", "/B/1\n");
    const Deck deck =
        read_deck(begin_2022 + "#include 'sub/&\na.inc'\n#INCLUDE sub/\n+b.inc\n/C/1\n/END\n", files);
    CHECK(keywords(deck) == Words{"BEGIN", "A", "B", "A", "C"});
    CHECK(deck.notices().empty());
    CHECK(deck.files().size() == 4);
}

TEST_CASE("includes that cannot be followed are noticed and the rest is read") {
    MemoryReader files;
    files.add("loop.inc", "/A/1\n#include loop.inc\n#include main_0000.rad\n/B/1\n");
    files.add("twice.inc", "#include four.inc\n#include four.inc\n");
    files.add("four.inc", "/F/1\n");
    const Deck deck = read_deck(
        begin_2022 + "#include none.inc\n#include loop.inc\n#include twice.inc\n/C/1\n/END\n", files);
    CHECK(keywords(deck) == Words{"BEGIN", "A", "B", "F", "F", "C"});
    CHECK(count(deck, Notice::Kind::include_missing) == 1);
    CHECK(count(deck, Notice::Kind::include_cycle) == 2);
}

TEST_CASE("doubling includes stop at the limit instead of exploding") {
    MemoryReader files;
    for (int i = 0; i < 40; ++i)
        files.add("d" + std::to_string(i),
                  "#include d" + std::to_string(i + 1) + "\n#include d" + std::to_string(i + 1) + "\n");
    files.add("d40", "/A/1\n");
    ReadOptions options;
    options.max_files = 500;
    const Deck deck = read_deck(begin_2022 + "#include d0\n/END\n", files, options);
    CHECK(count(deck, Notice::Kind::include_too_deep) >= 1);
}

TEST_CASE("/END ends its own file; /END/ENGINE and text after /END do not count") {
    MemoryReader files;
    files.add("a.inc", "/A/1\n/END\n/GONE/1\n");
    const Deck deck = read_deck(
        "# RADIOSS\n/RUN/x/1\n0.1\n/END/ENGINE\n" + begin_2022 + "#include a.inc\n/B/1\n/END\n/C/1\n", files);
    CHECK(keywords(deck) == Words{"BEGIN", "A", "B"});
    CHECK(count(deck, Notice::Kind::end_missing) == 0);
    CHECK(count(read_deck(begin_2022 + "/A/1\n"), Notice::Kind::end_missing) == 1);
}

TEST_CASE("submodel offsets as measured in the solver, nested ones add up") {
    const Deck deck =
        read_deck(begin_2022 + "//SUBMODEL/1\nsub\n       100       200         0       400       500"
                               "       600       700\n/A/1\n//SUBMODEL/2\n\n      1000\n/B/1\n//ENDSUB\n"
                               "/C/1\n//ENDSUB\n/D/1\n/END\n");
    const auto blocks = deck.blocks();
    REQUIRE(keywords(deck) == Words{"BEGIN", "/SUBMODEL", "A", "/SUBMODEL", "B", "C", "D"});
    const Offsets a = deck.scope(blocks[2].scope).offsets;
    CHECK(a == Offsets{100, 200, 100, 400, 500, 600, 700});
    const Offsets b = deck.scope(blocks[4].scope).offsets;
    CHECK(b == Offsets{1100, 1200, 1100, 1400, 1500, 1600, 1700});
    CHECK(deck.scope(blocks[4].scope).submodel == 702);
    CHECK(deck.scope(blocks[5].scope).offsets == a);
    CHECK(deck.scope(blocks[6].scope).offsets == Offsets{});
    CHECK(Deck::global_id(-5, 100) == -105);
    CHECK(Deck::global_id(0, 100) == 0);
}

TEST_CASE("offsets of a submodel in free format, by parameters, and what is no number") {
    const auto offsets = [](const std::string& card) {
        const Deck deck = read_deck(begin_2022 + "/PARAMETER/GLOBAL/INTEGER/1\noff\noff             1000\n" +
                                    "//SUBMODEL/1\nsub\n" + card + "\n/A/1\n//ENDSUB\n/END\n");
        for (const Block& block : deck.blocks())
            if (block.keyword == "A")
                return std::pair(deck.scope(block.scope).offsets, deck.notices().size());
        throw std::out_of_range("/A");
    };
    const Offsets thousand{1000, 1000, 1000, 1000, 1000, 1000, 1000};
    CHECK(offsets("      1000") == std::pair(thousand, std::size_t{0}));
    CHECK(offsets("1000,0,0,0,0,0,0") == std::pair(thousand, std::size_t{0}));
    CHECK(offsets("1000,") == std::pair(thousand, std::size_t{0}));
    CHECK(offsets("100,200,,400") == std::pair(Offsets{100, 200, 100, 400, 100, 100, 100}, std::size_t{0}));
    CHECK(offsets("&off,,20") == std::pair(Offsets{1000, 1000, 20, 1000, 1000, 1000, 1000}, std::size_t{0}));
    CHECK(offsets("") == std::pair(Offsets{}, std::size_t{0}));
    struct Wrong {
        const char *card, *subject, *detail;
    };
    for (const Wrong& wrong :
         {Wrong{"      O100", "O100", "off_def of submodel 7 is not a number: the solver reads 0"},
          Wrong{"              1 00", "1 00", "off_nod of submodel 7 is read as 1: the rest is dropped"},
          Wrong{"9999999999", "9999999999", "off_def of submodel 7 is larger than any id can be"},
          Wrong{"1,2,x", "x", "off_ele of submodel 7 is not a number: the solver reads 0"}}) {
        const Deck deck =
            read_deck(begin_2022 + "//SUBMODEL/7\nsub\n" + wrong.card + "\n/A/1\n//ENDSUB\n/END\n");
        REQUIRE(deck.notices().size() == 1);
        const Notice& notice = deck.notices()[0];
        CHECK(notice.kind == Notice::Kind::offset_not_understood);
        CHECK(notice.subject == wrong.subject);
        CHECK(notice.detail == wrong.detail);
        CHECK(deck.text(notice.place) == wrong.subject);
    }
    const Deck unknown = read_deck(begin_2022 + "//SUBMODEL/7\nsub\n     &gone\n/A/1\n//ENDSUB\n/END\n");
    REQUIRE(unknown.notices().size() == 1);
    CHECK(unknown.notices()[0].kind == Notice::Kind::unknown_parameter);
    CHECK(unknown.notices()[0].subject == "gone");
    CHECK(unknown.notices()[0].detail == "off_def of submodel 7");
}

TEST_CASE("units: input against work, /UNIT, blank cards, old keywords") {
    const std::string head =
        "/BEGIN\nrun\n      2022         0\n                  kg                   m                   s\n";
    const Deck both =
        read_deck(head + "                  Mg                  mm                   s\n/UNIT/7\nu\n"
                         "                   g                  cm                  ms\n/A/1\n/END\n");
    const ScopeId root{0};
    CHECK(*both.factor(root, 0, length_dimension) == Approx(1000));
    CHECK(*both.factor(root, 0, pressure_dimension) == Approx(1e-6));
    CHECK(*both.factor(root, 7, length_dimension) == Approx(10));
    CHECK_FALSE(both.factor(root, 8, length_dimension));
    const Deck blank = read_deck(head + "\t\n/A/1\n/END\n");
    CHECK(*blank.factor(root, 0, length_dimension) == 1);
    CHECK(blank.work_units().length_name == "m");
    const Deck old =
        read_deck("/BEGIN\nrun\n        90         0\n/UNIT/LENGTH/mm\n/UNIT/MASS/Mg\n/UNIT/TIME/s\n/END\n");
    CHECK(old.root().layout == 90);
    CHECK(unit_name(old.work_units(), force_per_length_dimension) == "N/mm");
    const Deck wrong = read_deck("/BEGIN\nrun\n      2022         0\n                 ton                  "
                                 "mm                   s\n/END\n");
    CHECK(count(wrong, Notice::Kind::unit_not_understood) >= 1);
}

TEST_CASE("files that are no decks are told apart") {
    MemoryReader files;
    files.add("empty", "");
    files.add("binary", std::string("\x7f\0\0ELF", 6));
    files.add("text", "hello\n");
    CHECK(Deck::read("empty", files).error().message == "the file is empty");
    CHECK(Deck::read("binary", files).error().message == "the file is binary, not a starter deck");
    CHECK(Deck::read("text", files).error().message ==
          "no /BEGIN keyword: the solver reads nothing of this file");
    CHECK(Deck::read("gone", files).error().message == "cannot read 'gone': No such file or directory");
}

TEST_CASE("indented keywords, CRLF, lower case") {
    const Deck deck =
        read_deck("/BEGIN\r\nrun\r\n      2022         0\r\n  /A/1\r\n1\r\n/node/3\r\n/END\r\n");
    CHECK(keywords(deck) == Words{"BEGIN", "A", "node"});
    CHECK(count(deck, Notice::Kind::keyword_indented) == 1);
    DataLines lines(deck, deck.blocks()[1]);
    Span line;
    REQUIRE(lines.next(line));
    CHECK(lines.text(line) == "1");
    CHECK_FALSE(lines.next(line));
}

TEST_CASE("a byte order mark does not hide the first line of a file") {
    const std::string mark = "\xef\xbb\xbf";
    MemoryReader files;
    files.add("a.inc", mark + "/NODE\n         1\n");
    files.add("b.inc", mark + "#include a.inc\n");
    const Deck deck = read_deck(mark + "/BEGIN\nrun\n      2022         0\n#include b.inc\n/END\n", files);
    CHECK(keywords(deck) == Words{"BEGIN", "NODE"});
    CHECK(deck.notices().empty());
    CHECK(deck.text(deck.blocks()[0].header) == "/BEGIN");
    CHECK(deck.text(deck.blocks()[1].header) == "/NODE");
}

TEST_CASE("an include of numbers alone is noticed") {
    MemoryReader files;
    files.add("rows", "# nodes\n         1                 0.0\n");
    const Deck deck = read_deck(begin_2022 + "/NODE\n#include rows\n/END\n", files);
    CHECK(count(deck, Notice::Kind::include_text_dropped) == 1);
}

TEST_CASE("a /BEGIN in a nested include holds for every file around it") {
    const std::string head = "#RADIOSS STARTER\n/BEGIN\nrun\n      2022         0\n"
                             "                  kg                   m                   s\n"
                             "                  Mg                  mm                   s\n";
    MemoryReader files;
    files.add("outer.inc", "#include middle.inc\n/A/1\n");
    files.add("middle.inc", "#include head.inc\n/B/1\n");
    files.add("head.inc", head);
    files.add("bare.inc", "/BEGIN\n");
    files.add("around.inc", "#include bare.inc\n/A/1\n");
    const Deck deck = read_deck("#include outer.inc\n/C/1\n/END\n", files);
    REQUIRE(keywords(deck) == Words{"BEGIN", "B", "A", "C"});
    for (const Block& block : deck.blocks()) {
        CHECK(deck.scope(block.scope).version == 2022);
        CHECK(deck.scope(block.scope).layout == 2022);
        CHECK(*deck.factor(block.scope, 0, length_dimension) == Approx(1000));
    }
    CHECK(deck.notices().empty());
    // Without a version card the newest layouts hold, everywhere and said once.
    const Deck bare = read_deck("#include around.inc\n/B/1\n/END\n", files);
    for (const Block& block : bare.blocks())
        CHECK(bare.scope(block.scope).layout == 2612);
    CHECK(count(bare, Notice::Kind::version_unknown) == 1);
}

TEST_CASE("#enddata before /END is no contradiction") {
    MemoryReader files;
    files.add("a.inc", "/A/1\n#enddata\n\n# the end\n/END\n");
    files.add("b.inc", "/B/1\n#enddata\n/C/1\n");
    const Deck deck = read_deck(begin_2022 + "#include a.inc\n#enddata\n/END\ntext\n", files);
    CHECK(deck.notices().empty());
    CHECK(count(read_deck(begin_2022 + "#include b.inc\n/END\n", files), Notice::Kind::data_after_enddata) ==
          1);
}

TEST_CASE("a comment that begins like an include, and paths with backslashes") {
    MemoryReader files;
    files.add("sub/a.inc", "/A/1\n");
    files.add("fine", "/B/1\n");
    const Deck deck = read_deck(
        begin_2022 + "#includes of the tool\n#INCLUDED: nothing\n#includefine\n#include sub\\a.inc\n/END\n",
        files);
    CHECK(keywords(deck) == Words{"BEGIN", "B", "A"});
    CHECK(deck.notices().empty());
    CHECK(count(read_deck(begin_2022 + "#include gone\n/END\n"), Notice::Kind::include_missing) == 1);
}

TEST_CASE("padded unit keywords, and the byte that old editors end a file with") {
    const Deck deck =
        read_deck("/BEGIN\nrun\n        90         0\n/UNIT/LENGTH/        mm\n/UNIT/MASS/Mg  \n"
                  "/UNIT/TIME/s/\n/END\x1a");
    CHECK(deck.notices().empty());
    CHECK(unit_name(deck.work_units(), force_per_length_dimension) == "N/mm");
    MemoryReader files;
    files.add("lines", "/BEGIN\rrun\r      2022\r/END\r");
    CHECK(Deck::read("lines", files).error().message ==
          "the lines of the file end with a carriage return alone: all of it is one line");
}

TEST_CASE("the cards of /BEGIN and /PARAMETER in free format") {
    const std::string units = "                  kg                   m                   s\n"
                              "                  Mg                  mm                   s\n";
    for (const char* card : {"120,0", "120,", " 120 , 1"}) {
        const Deck deck = read_deck("/BEGIN\nrun\n" + std::string(card) + "\n" + units + "/A/1\n/END\n");
        CHECK(deck.root().version == 120);
        CHECK(deck.root().layout == 120);
        CHECK(*deck.factor(ScopeId{0}, 0, length_dimension) == Approx(1000));
        CHECK(deck.notices().empty());
    }
    const Deck deck =
        read_deck(begin_2022 + "/PARAMETER/GLOBAL/REAL/1\nt\nft,80.\n"
                               "/PARAMETER/GLOBAL/INTEGER/2\nt, u\nn ,  7 , 3\n"
                               "/PARAMETER/GLOBAL/REAL_EXPR/3\nt\nhi        max(ft,n)\n"
                               "/PARAMETER/GLOBAL/TEXT/4\nt\nword              10\na, b\n/END\n");
    CHECK(deck.notices().empty());
    CHECK(deck.parameter(ScopeId{0}, "ft")->value == 80);
    CHECK(deck.parameter(ScopeId{0}, "n")->value == 7);
    CHECK(deck.parameter(ScopeId{0}, "hi")->value == 80);
    CHECK(deck.parameter(ScopeId{0}, "word")->text == "a, b");
}

TEST_CASE("a /PARAMETER without its card, or without a name, is noticed") {
    for (const char* kind : {"REAL", "INTEGER", "REAL_EXPR", "TEXT"}) {
        const std::string header = "/PARAMETER/GLOBAL/" + std::string(kind) + "/1\n";
        for (const char* rest : {"title\n", "", "title\n                 80.\n"}) {
            const Deck deck = read_deck(begin_2022 + header + rest + "/END\n");
            REQUIRE(deck.notices().size() == 1);
            CHECK(deck.notices()[0].kind == Notice::Kind::bad_parameter);
            CHECK(deck.notices()[0].subject.empty());
        }
    }
}

TEST_CASE("the newest version has no warning") {
    CHECK(read_deck(begin_of(2612) + "/END\n").notices().empty());
}

TEST_CASE("an expression goes on in the columns of its own or of the name") {
    const Deck deck = read_deck(begin_2022 + "/PARAMETER/GLOBAL/REAL_EXPR/1\nt\nA         2*3\n          +4\n"
                                             "/PARAMETER/GLOBAL/REAL_EXPR/2\nt\nB         A\n+A/2\n/END\n");
    CHECK(deck.notices().empty());
    CHECK(deck.parameter(ScopeId{0}, "A")->value == 10);
    CHECK(deck.parameter(ScopeId{0}, "B")->value == 15);
}
