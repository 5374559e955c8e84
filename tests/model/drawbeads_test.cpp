#include "models.h"

using namespace drawbead;

namespace {

const std::string tail = mesh() + part_surface + bead_group;

} // namespace

TEST_CASE("the smallest drawbead deck reads as intended") {
    const Built built = build(begin_of(2022) + tail + drawbead_block + "/END\n");
    REQUIRE(built.model.drawbeads().size() == 1);
    const Drawbead& bead = built.bead();
    CHECK(bead.id == 1);
    CHECK(bead.title == "bead");
    CHECK_FALSE(bead.title_missing);
    CHECK(bead.group_id == 2);
    CHECK(bead.surface_id == 1);
    CHECK(bead.iform == 2);
    CHECK(bead.fn_first == 80);
    CHECK(bead.ft_first == 100);
    CHECK(bead.depth == 2);
    CHECK(bead.fn_last == 60);
    CHECK(bead.ft_last == 90);
    CHECK(bead.t_start == 0);
    CHECK(bead.t_stop == 1e30);
    CHECK(bead.extra.empty());
    CHECK(built.nodes() == std::vector<uint32_t>{101, 102, 103});
    CHECK(built.segments() == std::vector<std::vector<uint32_t>>{{1, 2, 5, 4}, {2, 3, 6, 5}});
    CHECK(built.model.issues().empty());
    const Segment& segment = built.surface().segments[1];
    CHECK(value(built.model.element_id(segment)) == 2);
    CHECK(built.model.part_of(segment)->id == 1);
    CHECK(built.model.property_of(segment)->thickness == 1);
    CHECK(built.model.material_of(segment)->young == 210000);
    CHECK(built.model.material_of(segment)->bulk == Approx(175000));
    CHECK(built.deck->text(built.model.element_line(segment)) ==
          "         2         2         3         6         5");
    CHECK(built.model.counts().nodes == 9);
    CHECK(built.model.counts().shells4 == 2);
}

TEST_CASE("TYPE8 cards are cut by the version's layout") {
    struct Expected {
        int version;
        std::string card1;
        int iform;
        double fn, ft, depth, t_start, t_stop, fn_last, ft_last;
    };
    const std::string at_21 = "         2         1         1\n",
                      at_31 = "         2         1                   1\n";
    const Expected table[] = {
        {51, at_21, 2, 0, 100, 0, 4, 5, 0, 0},      {90, at_21, 2, 0, 100, 0, 4, 5, 0, 0},
        {100, at_21, 1, 0, 100, 0, 4, 5, 0, 0},     {100, at_31, 2, 0, 100, 0, 4, 5, 0, 0},
        {110, at_31, 1, 0, 100, 0, 4, 5, 0, 0},     {110, at_21, 2, 0, 100, 0, 4, 5, 0, 0},
        {120, at_31, 1, 0, 100, 0, 4, 5, 0, 0},     {130, at_31, 1, 80, 100, 2, 4, 5, 0, 0},
        {140, at_31, 1, 80, 100, 2, 4, 5, 0, 0},    {2017, at_31, 1, 80, 100, 2, 4, 5, 0, 0},
        {2021, at_31, 1, 80, 100, 2, 4, 5, 0, 0},   {2022, at_31, 1, 80, 100, 2, 4, 5, 60, 90},
        {2026, at_31, 1, 80, 100, 2, 4, 5, 60, 90}, {105, at_31, 1, 80, 100, 2, 4, 5, 60, 90},
    };
    for (const Expected& expected : table) {
        const Built built =
            build(begin_of(expected.version) + tail + "/INTER/TYPE8/1\nbead\n" + expected.card1 +
                  reals({"80.", "100.", "2.", "4.", "5."}) + reals({"60.", "90."}) + "/END\n");
        const Drawbead& bead = built.bead();
        INFO("version " << expected.version);
        CHECK(bead.group_id == 2);
        CHECK(bead.surface_id == 1);
        CHECK(bead.iform == expected.iform);
        CHECK(bead.fn_first == expected.fn);
        CHECK(bead.ft_first == expected.ft);
        CHECK(bead.depth == expected.depth);
        CHECK(bead.t_start == expected.t_start);
        CHECK(bead.t_stop == expected.t_stop);
        CHECK(bead.fn_last == expected.fn_last);
        CHECK(bead.ft_last == expected.ft_last);
        CHECK(built.model.issues().empty());
    }
}

TEST_CASE("cells of 8 and 16 columns in layout 44") {
    const Built built = build(begin_of(44) + "/INTER/TYPE8/1\nbead\n" + cells({"2", "1"}, 8) +
                              cells({"", "100.", "", "4.", "5."}, 16) + "/END\n");
    CHECK(built.bead().group_id == 2);
    CHECK(built.bead().surface_id == 1);
    CHECK(built.bead().ft_first == 100);
    CHECK(built.bead().t_start == 4);
    CHECK(built.bead().t_stop == 5);
    CHECK(built.bead().iform == 2);
}

TEST_CASE("missing cards are zeros, free format counts blank cells, text behind the cards is kept") {
    const Built built =
        build(begin_of(2022) + tail +
              "/INTER/TYPE8/1\n\n         2         1\n"
              "/INTER/TYPE8/2\nfree\n2,1,,1\n80,100,2,,7\n"
              "/INTER/TYPE8/3\nbare\n"
              "/INTER/TYPE8/4\nlong\n         2         1\n" +
              reals({"1.", "2.", "3.", "0.", "0."}) + reals({"4.", "5."}) + "\n  stray\n/END\n");
    REQUIRE(built.model.drawbeads().size() == 4);
    CHECK(built.bead(0).title.empty());
    CHECK(built.bead(0).cards[0].present);
    CHECK_FALSE(built.bead(0).cards[1].present);
    CHECK(built.bead(0).ft_first == 0);
    CHECK(built.bead(0).iform == 2);
    CHECK(built.bead(1).iform == 1);
    CHECK(built.bead(1).fn_first == 80);
    CHECK(built.bead(1).ft_first == 100);
    CHECK(built.bead(1).depth == 2);
    CHECK(built.bead(1).t_start == 0);
    CHECK(built.bead(1).t_stop == 7);
    CHECK(built.bead(2).group_id == 0);
    CHECK_FALSE(built.bead(2).group);
    REQUIRE(built.bead(3).extra.size() == 1);
    CHECK(built.deck->text(built.bead(3).extra[0]) == "  stray");
    // The first, second and fourth share one group and one surface.
    CHECK(built.model.groups().size() == 1);
    CHECK(built.model.surfaces().size() == 1);
    CHECK(built.bead(3).group == built.bead(0).group);
}

TEST_CASE("a forgotten title is told from a title of numbers") {
    const std::string card = "         2         1                   2\n",
                      forces = reals({"80.", "100.", "2.", "0.", "0."});
    const Built forgotten = build(begin_of(2022) + tail + "/INTER/TYPE8/1\n" + card + forces + "/END\n");
    CHECK(forgotten.bead().title_missing);
    const Built numbers = build(begin_of(2022) + tail + "/INTER/TYPE8/1\n" + card + card + forces + "/END\n");
    CHECK_FALSE(numbers.bead().title_missing);
    const Built blank = build(begin_of(2022) + tail + "/INTER/TYPE8/1\n\n" + card + forces + "/END\n");
    CHECK_FALSE(blank.bead().title_missing);
    const Built nothing = build(begin_of(2022) + tail + "/INTER/TYPE8/1\n/END\n");
    CHECK(nothing.bead().title_missing);
}

TEST_CASE("values are in work units; an unknown unit leaves them as written") {
    const std::string si = reals({"kg", "m", "s"});
    const std::string unit = "/UNIT/9\nmetres\n" + reals({"kg", "m", "s"});
    const std::string cards = "bead\n         2         1                   2\n" +
                              reals({"80.", "100.", "2.", "3.", "0."}) + reals({"60.", "90."});
    const Built built = build(begin_of(2022) + tail + unit + "/INTER/TYPE8/1/9\n" + cards +
                              "/INTER/TYPE8/2/8\n" + cards + "/INTER/TYPE8/3\n" + cards + "/END\n");
    // 80 N/m = 0.08 N/mm
    CHECK(built.bead(0).fn_first == Approx(0.08));
    CHECK(built.bead(0).ft_last == Approx(0.09));
    CHECK(built.bead(0).depth == Approx(2000));
    CHECK(built.bead(0).t_start == 3);
    CHECK(built.bead(0).unit_known);
    CHECK_FALSE(built.bead(1).unit_known);
    CHECK(built.bead(1).fn_first == 80);
    CHECK(built.issues(ReadIssue::Kind::unknown_unit) == 1);
    CHECK(built.bead(2).fn_first == 80);
    const Built converted = build(begin_of(2022, si) + tail + drawbead_block + "/END\n");
    CHECK(converted.bead().fn_first == Approx(0.08));
    CHECK(converted.bead().depth == Approx(2000));
    CHECK(converted.model.nodes()[converted.group().nodes[0]] == Vec3{5000, 5000, 3000});
    CHECK(converted.model.properties().at(0).thickness == Approx(1000));
    CHECK(converted.model.materials().at(0).young == Approx(0.21));
}

TEST_CASE("cells that are no numbers are reported and count as zero") {
    const Built built =
        build(begin_of(2022) + tail + "/INTER/TYPE8/1\nbead\n         2         1                   x\n" +
              reals({"1e309", "&depth", "1.0.2", "0.", "0."}) + "/END\n");
    CHECK(built.bead().iform == 2);
    CHECK(built.bead().fn_first == 0);
    CHECK(built.bead().ft_first == 0);
    CHECK(built.bead().depth == 0);
    CHECK(built.issues(ReadIssue::Kind::not_a_number) == 2);
    CHECK(built.issues(ReadIssue::Kind::not_finite) == 1);
    CHECK(built.issues(ReadIssue::Kind::unknown_parameter) == 1);
    REQUIRE(built.model.issues().size() >= 1);
    CHECK(built.model.issues()[0].subject == "x");
    CHECK(built.model.issues()[0].detail == "Iform");
    CHECK(built.deck->text(built.model.issues()[0].place) == "x");
}

TEST_CASE("ids defined twice, by family") {
    const Built built =
        build(begin_of(2022) + tail + drawbead_block + drawbead_block + "/INTER/TYPE7/1\nother\n" +
              part_surface + "/GRNOD/NODE/2\nagain\n" + ids({1}) + "/SURF/SEG/2\nsame number as the group\n" +
              "/SET/GENERAL/1\nsets have a name space of their own\n" + "/PART/1\ntwice\n" + ids({1, 1}) +
              "/END\n");
    std::vector<std::string> subjects;
    for (const ReadIssue& issue : built.model.issues())
        if (issue.kind == ReadIssue::Kind::duplicate_id) subjects.push_back(issue.subject);
    CHECK(subjects ==
          std::vector<std::string>{"interface 1", "interface 1", "surface 1", "node group 2", "part 1"});
    CHECK(built.deck->text(built.model.issues()[0].related) == "/INTER/TYPE8/1");
}

TEST_CASE("without drawbeads no table is read") {
    const Built built = build(begin_of(2022) + tail + "/END\n");
    CHECK(built.model.nodes().size() == 0);
    CHECK(built.model.shells4().size() == 0);
    CHECK(built.model.counts().nodes == 9);
    const Built listed = build(begin_of(2022) + tail + drawbead_block + "/END\n", Needs::none);
    CHECK(listed.model.nodes().size() == 0);
    CHECK(listed.group().listed.size() == 3);
    CHECK(listed.group().order == NodeGroup::Order::unsorted);
    CHECK(listed.surface().segments.empty());
    REQUIRE(listed.surface().sources.size() == 1);
    CHECK(listed.surface().sources[0].kind == SurfaceSource::Kind::part);
}

TEST_CASE("adaptive meshing") {
    const Built built = build(begin_of(2022) + tail + drawbead_block + "/ADMESH/GLOBAL\n" +
                              "         1         0                 0.0         1\n/END\n");
    REQUIRE(built.model.admesh());
    CHECK(built.model.admesh()->level == 1);
    CHECK(built.model.admesh()->idt == 1);
}
