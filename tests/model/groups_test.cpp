#include "models.h"

#include <algorithm>

using namespace drawbead;

namespace {

using Ids = std::vector<uint32_t>;
using Order = NodeGroup::Order;

/// The deck of the smallest drawbead with another node group 2.
Built with_group(const std::string& group, const std::string& more = "", Needs needs = everything) {
    return build(begin_of(2022) + mesh() + part_surface + group + more + drawbead_block + "/END\n", needs);
}

} // namespace

TEST_CASE("NODENS keeps order and duplicates, skips zeros, drops negatives and unknown nodes") {
    const Built built = with_group("/GRNOD/NODENS/2\nline\n" + ids({103, 0, 101, -102, 999, 101}) +
                                   "       102\n\n                 6\n");
    CHECK(built.nodes() == Ids{103, 101, 101, 102, 6});
    CHECK(built.group().order == Order::unsorted);
    CHECK(built.group().type == "NODENS");
    CHECK(built.group().title == "line");
    const auto& listed = built.group().listed;
    REQUIRE(listed.size() == 8);
    CHECK(listed[1].written == 0);
    CHECK(listed[1].row == no_node);
    CHECK(listed[3].written == -102);
    CHECK(listed[3].row == no_node);
    CHECK(listed[4].written == 999);
    CHECK(listed[4].row == no_node);
    CHECK(built.deck->text(listed[7].place) == "6");
    CHECK(built.deck->at(listed[7].place).column == 18);
}

TEST_CASE("lists with parameters, commas and cells of several numbers") {
    const Built built = build(
        begin_of(2022) + "/PARAMETER/GLOBAL/INTEGER/1\np\nfirst            101\n" + mesh() + part_surface +
        "/GRNOD/NODENS/2\nline\n    &first   102\n103,,101\n  102 5  \n" + drawbead_block + "/END\n");
    CHECK(built.nodes() == Ids{101, 102, 103, 101, 102});
}

TEST_CASE("elementary groups in ascending order") {
    const Built node = with_group("/GRNOD/NODE/2\nsorted\n" + ids({103, 101, 101, 6}));
    CHECK(node.nodes() == Ids{6, 101, 103});
    CHECK(node.group().order == Order::sorted);
    CHECK(node.group().listed.size() == 4);
    const Built cnode = with_group("/GRNOD/CNODE/2\nsorted\n" + ids({103, 101}));
    CHECK(cnode.nodes() == Ids{101, 103});
    const Built gene = with_group("/GRNOD/GENE/2\nranges\n" + ids({2, 4, 100, 102}));
    CHECK(gene.nodes() == Ids{2, 3, 4, 101, 102});
    CHECK(gene.group().order == Order::sorted);
    const Built step = with_group("/GRNOD/GEN_INCR/2\nranges\n" + ids({1, 6, 2}) + ids({101, 1000000000, 1}));
    CHECK(step.nodes() == Ids{1, 3, 5, 101, 102, 103});
}

TEST_CASE("groups by part, subset, material, property and element") {
    const std::string second = "/PART/2\nother\n" + ids({3, 4, 7}) + "/SH3N/2\n" + ids({1, 4, 5, 101}) +
                               "/SUBSET/8\nouter\n" + ids({7}) + "/SUBSET/7\ninner\n" + "/PROP/SHELL/3\np\n" +
                               "/MAT/ELAST/4\nm\n";
    const Ids all{1, 2, 3, 4, 5, 6}, other{4, 5, 101};
    CHECK(with_group("/GRNOD/PART/2\ng\n" + ids({1}), second).nodes() == all);
    CHECK(with_group("/GRNOD/PART/2\ng\n" + ids({2}), second).nodes() == other);
    CHECK(with_group("/GRNOD/PART/2\ng\n" + ids({1, -2}), second).nodes() == Ids{1, 2, 3, 6});
    CHECK(with_group("/GRNOD/SUBSET/2\ng\n" + ids({8}), second).nodes() == other);
    CHECK(with_group("/GRNOD/MAT/2\ng\n" + ids({4}), second).nodes() == other);
    CHECK(with_group("/GRNOD/PROP/2\ng\n" + ids({1}), second).nodes() == all);
    CHECK(with_group("/GRNOD/GRSHEL/2\ng\n" + ids({5}), "/GRSHEL/SHEL/5\ns\n" + ids({2})).nodes() ==
          Ids{2, 3, 5, 6});
    CHECK(
        with_group("/GRNOD/GRSH3N/2\ng\n" + ids({5}), second + "/GRSH3N/PART/5\ns\n" + ids({1, 2})).nodes() ==
        other);
    CHECK(with_group("/GRNOD/SURF/2\ng\n" + ids({9}), "/SURF/SEG/9\ns\n" + ids({0, 1, 2, 5})).nodes() ==
          Ids{1, 2, 5});
    CHECK(with_group("/GRNOD/LINE/2\ng\n" + ids({9}), "/LINE/SEG/9\ns\n" + ids({0, 1, 2}) + ids({0, 2, 3}))
              .nodes() == Ids{1, 2, 3});
    const Built missing = with_group("/GRNOD/PART/2\ng\n" + ids({1, 77}), second);
    CHECK(missing.nodes() == all);
    CHECK(missing.issues(ReadIssue::Kind::member_missing) == 1);
}

TEST_CASE("groups of groups: union, difference, concatenation, recursion") {
    const std::string parts =
        "/GRNOD/NODE/3\na\n" + ids({103, 101}) + "/GRNOD/NODENS/4\nb\n" + ids({6, 102, 6});
    CHECK(with_group("/GRNOD/GRNOD/2\ng\n" + ids({4, 3}), parts).nodes() == Ids{6, 101, 102, 103});
    CHECK(with_group("/GRNOD/GRNOD/2\ng\n" + ids({3, 4, -3}), parts).nodes() == Ids{6, 102});
    const Built ordered = with_group("/GRNOD/GRNODNS/2\ng\n" + ids({4, -3, 4}), parts);
    CHECK(ordered.nodes() == Ids{6, 102, 6, 101, 103, 6, 102, 6});
    CHECK(ordered.group().order == Order::unsorted);
    const Built missing = with_group("/GRNOD/GRNODNS/2\ng\n" + ids({9, 3}), parts);
    CHECK(missing.nodes() == Ids{101, 103});
    CHECK(missing.issues(ReadIssue::Kind::member_missing) == 1);
    CHECK(with_group("/GRNOD/GRNODNS/2\ng\n" + ids({2, 3}), parts).nodes() == Ids{101, 103});
    CHECK(with_group("/GRNOD/GRNOD/2\ng\n" + ids({5}), "/GRNOD/GRNOD/5\nh\n" + ids({2, 3}) + parts).nodes() ==
          Ids{101, 103});
}

TEST_CASE("groups of groups that double at every level do not explode") {
    std::string chain = "/GRNOD/NODE/100\nend\n" + ids({101, 102});
    for (int i = 40; i < 100; ++i)
        chain += "/GRNOD/GRNOD/" + std::to_string(i) + "\nlink\n" + ids({i + 1, i + 1});
    CHECK(with_group("/GRNOD/GRNOD/2\ng\n" + ids({40}), chain).nodes() == Ids{101, 102});
    // Each level names both groups, or sets, of the level below.
    std::string elements = "/GRSHEL/SHEL/100\nend\n" + ids({2}) + "/GRSHEL/SHEL/200\nend\n" + ids({1});
    std::string sets = "/SET/GENERAL/100\nend\nSHELL              2\n/SET/GENERAL/200\nend\nNODE       " +
                       std::string("      102\n");
    const auto padded = [](int id) {
        return std::string(10 - std::to_string(id).size(), ' ') + std::to_string(id);
    };
    for (int i = 60; i < 100; ++i)
        for (const int side : {0, 100}) {
            const std::string own = std::to_string(i + side);
            elements += "/GRSHEL/GRSHEL/" + own + "\nlink\n" + ids({i + 1, i + 101});
            sets += "/SET/GENERAL/" + own + "\nlink\nSET       " + padded(i + 1) + padded(i + 101) + "\n";
        }
    CHECK(with_group("/GRNOD/GRSHEL/2\ng\n" + ids({60}), elements).nodes() == Ids{1, 2, 3, 4, 5, 6});
    CHECK(with_group("/SET/GENERAL/2\ng\nSET       " + padded(60) + "\n", sets).nodes() ==
          Ids{2, 3, 5, 6, 102});
    // One that cannot be expanded is unknown each time.
    const Built odd =
        with_group("/GRNOD/GRSHEL/2\ng\n" + ids({60, 60}),
                   "/GRSHEL/GRSHEL/60\nlink\n" + ids({61, 61}) + "/GRSHEL/NONE/61\nx\n" + ids({1}));
    CHECK_FALSE(odd.group().evaluated);
    CHECK(odd.issues(ReadIssue::Kind::not_supported) >= 1);
}

TEST_CASE("nodes inside boxes") {
    const std::string block =
        "/BOX/RECTA/5\nb\n\n" + reals({"-1.", "-1.", "-1."}) + reals({"11.", "1.", "4."});
    const std::string ball =
        "/BOX/SPHER/6\nb\n" + std::string(30, ' ') + reals({"6."}) + reals({"10.", "5.", "3."});
    const std::string rod = "/BOX/CYLIN/7\nb\n" + std::string(30, ' ') + reals({"2."}) +
                            reals({"0.", "10.", "0."}) + reals({"15.", "10.", "0."});
    CHECK(with_group("/GRNOD/BOX/2\ng\n" + ids({5}), block).nodes() == Ids{1, 2});
    CHECK(with_group("/GRNOD/BOX/2\ng\n" + ids({6}), ball).nodes() == Ids{102});
    CHECK(with_group("/GRNOD/BOX/2\ng\n" + ids({7}), rod).nodes() == Ids{4, 5});
    CHECK(with_group("/GRNOD/BOX/2\ng\n" + ids({8}), block + rod + "/BOX/BOX/8\nboth\n" + ids({5, 7}))
              .nodes() == Ids{1, 2, 4, 5});
    // Corners may be nodes.
    CHECK(with_group("/GRNOD/BOX/2\ng\n" + ids({5}), "/BOX/RECTA/5\nb\n" + ids({1, 5}) + "\n\n").nodes() ==
          Ids{1, 2, 4, 5});
    const Built skewed =
        with_group("/GRNOD/BOX/2\ng\n" + ids({5}), "/BOX/RECTA/5\nb\n" + ids({0, 0, 3}) + "\n\n");
    CHECK_FALSE(skewed.group().evaluated);
    CHECK(skewed.issues(ReadIssue::Kind::not_supported) == 1);
}

TEST_CASE("what cannot be expanded is said, never guessed") {
    const Built built = with_group("/GRNOD/GRBEAM/2\ng\n" + ids({5}));
    CHECK_FALSE(built.group().evaluated);
    CHECK(built.group().nodes.empty());
    REQUIRE(built.issues(ReadIssue::Kind::not_supported) == 1);
    CHECK(built.model.issues()[0].subject == "GRNOD/GRBEAM");
}

TEST_CASE("sets as node groups") {
    const auto clause = [](const std::string& key, std::initializer_list<int> numbers) {
        return key + std::string(10 - key.size(), ' ') + ids(numbers);
    };
    const std::string set = "/SET/GENERAL/2\nset\n";
    const Built ordered = with_group(set + clause("NODENS", {103, 101, 0, 999, 103}) + clause("", {102}));
    CHECK(ordered.nodes() == Ids{103, 101, 103, 102});
    CHECK(ordered.group().order == Order::unsorted);
    CHECK(ordered.group().type == "SET");
    CHECK(ordered.group().listed.size() == 6);
    CHECK(ordered.group().nodens_clauses.size() == 1);
    const Built mixed = with_group(set + clause("PART", {1}) + clause("NODENS", {103, 101}));
    CHECK(mixed.nodes() == Ids{103, 101});
    CHECK(mixed.group().order == Order::unsorted);
    const Built two = with_group(set + clause("NODENS", {103}) + clause("NODENS", {101}));
    CHECK(two.group().order == Order::lost_in_set);
    CHECK(two.group().nodens_clauses.size() == 2);
    const Built deleted = with_group(set + clause("NODENS", {103, 101}) + clause("NODENS_D", {103}));
    CHECK(deleted.group().order == Order::lost_in_set);
    CHECK(deleted.nodes() == Ids{101});
    const Built sorted = with_group(set + clause("NODE", {103, 101}) + clause("SHELL", {2}));
    CHECK(sorted.nodes() == Ids{2, 3, 5, 6, 101, 103});
    CHECK(sorted.group().order == Order::sorted);
    const Built range = with_group(set + clause("NODE_G", {101, 103, 2}) + clause("NODE_D", {101}));
    CHECK(range.nodes() == Ids{103});
    // Triples keep their columns: a blank increment is 1, a blank end holds nothing.
    const Built blank_step = with_group(set + clause("NODE_G", {1, 2}) + clause("", {101, 102}));
    CHECK(blank_step.nodes() == Ids{1, 2, 101, 102});
    const Built one_line =
        with_group(set + "NODE_G             1         2                 101       103" + "         2\n");
    CHECK(one_line.nodes() == Ids{1, 2, 101, 103});
    CHECK(with_group(set + clause("NODE_G", {5}) + clause("", {3, 4, 1})).nodes() == Ids{3, 4});
    CHECK(with_group(set + "NODE_G                       3         2\n").nodes() == Ids{2});
    for (const Needs needs : {everything, Needs::none}) {
        const Built generated = with_group(set + clause("NODENS_G", {101, 103, 1}), "", needs);
        CHECK_FALSE(generated.group().evaluated);
        CHECK(generated.group().nodes.empty());
        CHECK(generated.group().listed.empty());
        CHECK(generated.issues(ReadIssue::Kind::not_supported) == (needs == Needs::none ? 0 : 1));
    }
    const Built nested =
        with_group(set + clause("SET", {7}), "/SET/GENERAL/7\ninner\n" + clause("NODE", {6, 5}));
    CHECK(nested.nodes() == Ids{5, 6});
    const Built odd = with_group(set + clause("RBODY", {7}));
    CHECK_FALSE(odd.group().evaluated);
    CHECK(odd.issues(ReadIssue::Kind::not_supported) == 1);
    const Built bare = with_group(set + clause("NODENS", {103, 101}), "", Needs::none);
    CHECK(bare.group().order == Order::unsorted);
    CHECK(bare.group().listed.size() == 2);
}

TEST_CASE("offsets of submodels") {
    // Offsets: definitions 100, nodes 200, parts 400, materials 500, properties 600, submodels 700.
    const std::string inside =
        "/NODE\n" + node(1, "0.", "0.", "0.") + node(2, "1.", "0.", "0.") + node(3, "1.", "1.", "0.") +
        "/MAT/ELAST/1\nm\n" + reals({"1e-9"}) + reals({"1.", "0."}) + "/PROP/SHELL/1\np\n\n\n" +
        std::string(20, ' ') + reals({"2."}) + "/PART/1\np\n" + ids({1, 1, 3}) + "/SH3N/1\n" +
        ids({1, 1, 2, 3}) + "/GRNOD/NODENS/5\ng\n" + ids({2, 1}) + "/SURF/PART/7\ns\n" + ids({1}) +
        "/INTER/TYPE8/2\nbead\n" + ids({5, 7}) + reals({"", "1."});
    const std::string offsets = ids({100, 200, 0, 400, 500, 600, 700});
    const Built built = build(begin_of(2022) + "//SUBMODEL/9\n\n" + offsets + inside + "//ENDSUB\n/END\n");
    CHECK(built.bead().id == 102);
    CHECK(built.bead().group_id == 105);
    CHECK(built.bead().surface_id == 107);
    CHECK(built.nodes() == Ids{202, 201});
    CHECK(built.group().listed[0].written == 2);
    CHECK(built.segments() == std::vector<std::vector<uint32_t>>{{201, 202, 203, 203}});
    const Part& part = built.model.parts().at(0);
    CHECK(part.id == 401);
    CHECK(part.material == 501);
    CHECK(part.property == 601);
    CHECK(part.subset == 103);
    CHECK(built.model.property_of(built.surface().segments[0])->thickness == 2);
    CHECK(value(built.model.element_id(built.surface().segments[0])) == 101);
    CHECK(built.model.issues().empty());
}

TEST_CASE("results do not depend on the number of threads") {
    std::string text = begin_of(2022) + steel + sheet + "/PART/1\nblank\n" + ids({1, 1}) + "/NODE\n";
    for (int i = 0; i < 400; ++i)
        text += node(i + 1, std::to_string(i % 20) + ".", std::to_string(i / 20) + ".", "0.");
    text += "/SHELL/1\n";
    for (int j = 0; j < 19; ++j)
        for (int i = 0; i < 19; ++i) {
            const int a = 20 * j + i + 1;
            text += ids({1000 - a, a, a + 1, a + 21, a + 20});
        }
    text += part_surface + "/GRNOD/PART/2\ng\n" + ids({1}) + drawbead_block + "/END\n";
    MemoryReader reader;
    reader.add("main_0000.rad", text);
    const auto deck = Deck::read("main_0000.rad", reader);
    REQUIRE(deck);
    const Model one = Model::build(*deck, everything, 1), four = Model::build(*deck, everything, 4);
    CHECK(one.groups()[0].nodes == four.groups()[0].nodes);
    CHECK(one.groups()[0].nodes.size() == 400);
    REQUIRE(one.surfaces()[0].segments.size() == 361);
    REQUIRE(four.surfaces()[0].segments.size() == 361);
    for (std::size_t i = 0; i < 361; ++i)
        CHECK(one.surfaces()[0].segments[i].n == four.surfaces()[0].segments[i].n);
    CHECK_FALSE(one.surfaces()[0].in_storage_order);
    CHECK(one.storage_key(one.surfaces()[0], 360) < one.storage_key(one.surfaces()[0], 0));
}
