#include "models.h"

#include <algorithm>

using namespace drawbead;

namespace {

using Segments = std::vector<std::vector<uint32_t>>;

/// The mesh of the smallest drawbead, with a triangle 1 (part 1) on nodes 3, 6, 103 besides.
Built with_surface(const std::string& surface, const std::string& more = "") {
    return build(begin_of(2022) + mesh() + "/SH3N/1\n" + ids({1, 3, 6, 103}) + bead_group + surface + more +
                 drawbead_block + "/END\n");
}

/// A unit cube of corners 1 to 8 (5 to 8 above 1 to 4), part 1, and a second one, part 2, on top of it.
std::string cubes() {
    std::string text = steel + "/PROP/SOLID/3\ncube\n\n" + sheet + "/PART/1\nlower\n" + ids({3, 1}) +
                       "/PART/2\nupper\n" + ids({3, 1}) + "/PART/3\ncoat\n" + ids({1, 1}) + "/NODE\n";
    const char* const corner[4][2] = {{"0.", "0."}, {"1.", "0."}, {"1.", "1."}, {"0.", "1."}};
    for (int level = 0; level < 3; ++level)
        for (int i = 0; i < 4; ++i)
            text += node(4 * level + i + 1, corner[i][0], corner[i][1], std::to_string(level) + ".");
    for (int i = 1; i <= 3; ++i)
        text += node(100 + i, "0." + std::to_string(3 * i), ".5", "4.");
    return text + "/BRICK/1\n" + ids({11, 1, 2, 3, 4, 5, 6, 7, 8}) + "/BRICK/2\n" +
           ids({12, 5, 6, 7, 8, 9, 10, 11, 12});
}

Built with_cubes(const std::string& surface, const std::string& more = "") {
    return build(begin_of(2022) + cubes() + bead_group + surface + more + drawbead_block + "/END\n");
}

/// Whether the normals of all solid-backed segments point away from the middle of the model.
bool all_outward(const Built& built, Vec3 middle) {
    return std::all_of(
        built.surface().segments.begin(), built.surface().segments.end(), [&](const Segment& segment) {
            const NodeTable& nodes = built.model.nodes();
            const Vec3 a = nodes[segment.n[0]], b = nodes[segment.n[1]], c = nodes[segment.n[2]];
            return dot(cross(b - a, c - a), a - middle) > 0;
        });
}

} // namespace

TEST_CASE("surfaces of parts: quadrilaterals, then triangles; a minus sign reverses") {
    const Built plus = with_surface("/SURF/PART/1\ns\n" + ids({1}));
    CHECK(plus.segments() == Segments{{1, 2, 5, 4}, {2, 3, 6, 5}, {3, 6, 103, 103}});
    CHECK(plus.surface().in_storage_order);
    CHECK(plus.surface().segments[0].sense == 1);
    CHECK(plus.surface().segments[2].kind == ElementKind::shell3);
    CHECK(plus.surface().type == "PART");
    const Built minus = with_surface("/SURF/PART/1\ns\n" + ids({-1}));
    CHECK(minus.segments() == Segments{{4, 5, 2, 1}, {5, 6, 3, 2}, {103, 6, 3, 3}});
    CHECK(minus.surface().segments[0].sense == -1);
    CHECK(minus.surface().sources[0].id == -1);
    // Listed with both signs an element stays positive.
    CHECK(with_surface("/SURF/PART/1\ns\n" + ids({-1, 1})).segments() == plus.segments());
    CHECK(with_surface("/SURF/MAT/1\ns\n" + ids({1})).segments() == plus.segments());
    CHECK(with_surface("/SURF/PROP/1\ns\n" + ids({-1})).segments() == minus.segments());
    const Built missing = with_surface("/SURF/PART/1\ns\n" + ids({1, 8}));
    CHECK(missing.segments() == plus.segments());
    CHECK(missing.issues(ReadIssue::Kind::member_missing) == 1);
}

TEST_CASE("signed groups of shells and triangles") {
    const std::string groups = "/GRSHEL/SHEL/5\ng\n" + ids({2}) + "/GRSHEL/SHEL/6\ng\n" + ids({1}) +
                               "/GRSH3N/SH3N/7\ng\n" + ids({1}) + "/GRSHEL/GRSHEL/8\ng\n" + ids({5, 6}) +
                               "/GRSHEL/GENE/9\ng\n" + ids({1, 2}) + "/GRSHEL/PART/10\ng\n" + ids({1});
    const Built mixed = with_surface("/SURF/GRSHEL/1\ns\n" + ids({5, -6}), groups);
    CHECK(mixed.segments() == Segments{{4, 5, 2, 1}, {2, 3, 6, 5}});
    CHECK(mixed.surface().in_storage_order);
    CHECK(mixed.surface().segments[0].sense == -1);
    CHECK(with_surface("/SURF/GRSH3N/1\ns\n" + ids({-7}), groups).segments() == Segments{{103, 6, 3, 3}});
    const Segments both{{1, 2, 5, 4}, {2, 3, 6, 5}};
    for (const int group : {8, 9, 10})
        CHECK(with_surface("/SURF/GRSHEL/1\ns\n" + ids({group}), groups).segments() == both);
    CHECK(with_surface("/SURF/GRSHEL/1\ns\n" + ids({8, -6}), groups).segments() == both);
    const Built missing =
        with_surface("/SURF/GRSHEL/1\ns\n" + ids({11}), "/GRSHEL/SHEL/11\ng\n" + ids({1, 77}));
    CHECK(missing.segments() == Segments{{1, 2, 5, 4}});
    CHECK(missing.issues(ReadIssue::Kind::member_missing) == 1);
}

TEST_CASE("surfaces of surfaces keep duplicates and store SEG lines first") {
    const std::string parts = "/SURF/PART/3\na\n" + ids({1}) + "/SURF/SEG/4\nb\n" + ids({0, 2, 3, 6, 5});
    const Built built = with_surface("/SURF/SURF/1\ns\n" + ids({3, 4, -3}), parts);
    CHECK(built.segments() == Segments{{2, 3, 6, 5},
                                       {1, 2, 5, 4},
                                       {2, 3, 6, 5},
                                       {4, 5, 2, 1},
                                       {5, 6, 3, 2},
                                       {3, 6, 103, 103},
                                       {103, 6, 3, 3}});
    CHECK_FALSE(built.surface().in_storage_order);
    CHECK(built.surface().lines.size() == 1);
    std::vector<uint32_t> order(built.surface().segments.size());
    for (uint32_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
        return built.model.storage_key(built.surface(), a) < built.model.storage_key(built.surface(), b);
    });
    CHECK(order == std::vector<uint32_t>{0, 1, 3, 2, 4, 5, 6});
    // A triangle of a reversed surface is written 3 3 2 1 and repaired.
    const Built reversed =
        with_surface("/SURF/SURF/1\ns\n" + ids({-3}), "/SURF/SEG/3\na\n" + ids({0, 3, 6, 103}));
    CHECK(reversed.segments() == Segments{{103, 6, 3, 3}});
    CHECK(reversed.surface().segments[0].repaired);
    const Built missing = with_surface("/SURF/SURF/1\ns\n" + ids({3, 9}), parts);
    CHECK(missing.issues(ReadIssue::Kind::member_missing) == 1);
    CHECK(with_surface("/SURF/SURF/1\ns\n" + ids({1, 3}), parts).segments().size() == 3);
}

TEST_CASE("difference of surfaces") {
    const std::string parts =
        "/SURF/PART/3\na\n" + ids({1}) + "/SURF/SEG/4\nb\n" + ids({0, 5, 4, 1, 2}) + ids({0, 103, 3, 6});
    const Built built = with_surface("/SURF/DSURF/1\ns\n" + ids({3, 3, -4}), parts);
    CHECK(built.segments() == Segments{{2, 3, 6, 5}});
    CHECK(built.surface().in_storage_order);
}

TEST_CASE("SEG lines: order, triangles, repairs, unknown nodes") {
    const Built built =
        with_surface("/SURF/SEG/1\ns\n" + ids({1, 5, 6, 3, 2}) + ids({2, 1, 2, 5}) +
                     "                   1         2         5         5\n\n" + ids({0, 1, 1, 2, 5}) +
                     ids({0, 1, 2, 99, 4}) + "                   4         5\n");
    CHECK(built.segments() == Segments{{5, 6, 3, 2}, {1, 2, 5, 5}, {1, 2, 5, 5}, {1, 2, 5, 5}});
    CHECK_FALSE(built.surface().segments[1].repaired);
    CHECK_FALSE(built.surface().segments[2].repaired);
    CHECK(built.surface().segments[3].repaired);
    REQUIRE(built.surface().lines.size() == 4);
    CHECK(built.deck->text(built.surface().lines[1]) == "         2         1         2         5");
    CHECK(built.surface().unknown_nodes == std::vector<int64_t>{99});
    CHECK(built.surface().unknown_node_lines.size() == 1);
    CHECK(built.surface().in_storage_order);
    // The shell behind gives the stiffness: also to a triangle that is half of it.
    CHECK(built.surface().segments[0].kind == ElementKind::shell4);
    CHECK(value(built.model.element_id(built.surface().segments[0])) == 2);
    CHECK(built.surface().segments[1].kind == ElementKind::shell4);
    CHECK(value(built.model.element_id(built.surface().segments[1])) == 1);
    CHECK_FALSE(built.surface().segments[0].solid_backed);
}

TEST_CASE("several shells behind a SEG line: the thickest, then the stiffest") {
    const std::string more = "/PROP/SHELL/2\nthick\n\n\n" + std::string(20, ' ') + reals({"3."}) +
                             "/MAT/ELAST/2\nstiff\n" + reals({"1e-9"}) + reals({"300000.", ".3"}) +
                             "/PART/2\np\n" + ids({2, 1}) + "/PART/3\np\n" + ids({1, 2}) + "/SHELL/3\n" +
                             ids({21, 1, 2, 5, 4}) + ids({31, 2, 3, 6, 5}) + "/SHELL/2\n" +
                             ids({22, 1, 2, 5, 4});
    const Built built = with_surface("/SURF/SEG/1\ns\n" + ids({1, 1, 2, 5, 4}) + ids({2, 2, 3, 6, 5}), more);
    CHECK(value(built.model.element_id(built.surface().segments[0])) == 22);
    CHECK(value(built.model.element_id(built.surface().segments[1])) == 31);
}

TEST_CASE("SEG lines on solids are turned outward, a coating shell gives the stiffness") {
    const Built inward =
        with_cubes("/SURF/SEG/1\ns\n" + ids({0, 12, 11, 10, 9}) + ids({0, 9, 11, 10}) + ids({0, 1, 4, 3, 2}));
    CHECK(inward.segments() == Segments{{9, 10, 11, 12}, {11, 9, 10, 10}, {1, 4, 3, 2}});
    for (const Segment& segment : inward.surface().segments) {
        CHECK(segment.kind == ElementKind::solid);
        CHECK(segment.solid_backed);
    }
    CHECK(value(inward.model.element_id(inward.surface().segments[0])) == 12);
    CHECK(value(inward.model.element_id(inward.surface().segments[2])) == 11);
    CHECK(inward.surface().coated.empty());
    // Between two solids: the one of the highest id, and not turned.
    const Built between = with_cubes("/SURF/SEG/1\ns\n" + ids({0, 8, 7, 6, 5}));
    CHECK(between.segments() == Segments{{8, 7, 6, 5}});
    CHECK_FALSE(between.surface().segments[0].solid_backed);
    CHECK(value(between.model.element_id(between.surface().segments[0])) == 12);
    const Built coated = with_cubes("/SURF/SEG/1\ns\n" + ids({0, 1, 2, 3, 4}) + ids({0, 12, 11, 10, 9}),
                                    "/SHELL/3\n" + ids({7, 9, 10, 11, 12}));
    REQUIRE(coated.surface().coated.size() == 1);
    CHECK(coated.surface().coated[0].segment == 1);
    CHECK(coated.model.solids().id[coated.surface().coated[0].solid] == 12);
    CHECK(coated.surface().segments[1].kind == ElementKind::shell4);
    CHECK(coated.surface().segments[1].solid_backed);
    CHECK(coated.segments() == Segments{{4, 3, 2, 1}, {9, 10, 11, 12}});
}

TEST_CASE("outer faces of solids") {
    const Built one = with_cubes("/SURF/PART/EXT/1\ns\n" + ids({1}));
    CHECK(one.surface().segments.size() == 6);
    CHECK(all_outward(one, {.5, .5, .5}));
    CHECK(one.surface().segments[0].solid_backed);
    CHECK(one.surface().in_storage_order);
    const Built both = with_cubes("/SURF/PART/EXT/1\ns\n" + ids({1, 2}));
    CHECK(both.surface().segments.size() == 10);
    CHECK(all_outward(both, {.5, .5, 1}));
    const Built all = with_cubes("/SURF/PART/ALL/1\ns\n" + ids({1, 2}));
    CHECK(all.surface().segments.size() == 12);
    CHECK(std::count_if(all.surface().segments.begin(), all.surface().segments.end(),
                        [](const Segment& s) { return s.solid_backed; }) == 10);
    CHECK(with_cubes("/SURF/PART/1\nshells only\n" + ids({1, 2})).surface().segments.empty());
    const Built group = with_cubes("/SURF/GRBRIC/EXT/1\ns\n" + ids({5}), "/GRBRIC/BRIC/5\ng\n" + ids({12}));
    CHECK(group.surface().segments.size() == 6);
    const Built bare = with_cubes("/SURF/GRBRIC/1\ns\n" + ids({5}), "/GRBRIC/BRIC/5\ng\n" + ids({12}));
    CHECK_FALSE(bare.surface().evaluated);
    // A face under a selected shell is the shell's.
    const Built coated =
        with_cubes("/SURF/PART/EXT/1\ns\n" + ids({2, 3}), "/SHELL/3\n" + ids({7, 9, 10, 11, 12}));
    CHECK(coated.surface().segments.size() == 6);
    CHECK(coated.surface().segments[0].kind == ElementKind::shell4);
}

TEST_CASE("outer faces of tetrahedra, wedges and inverted bricks") {
    const std::string corners = "/NODE\n" + node(21, "0.", "0.", "0.") + node(22, "2.", "0.", "0.") +
                                node(23, "0.", "2.", "0.") + node(24, "0.", "0.", "2.") +
                                node(25, "1.", "0.", "0.") + node(26, "1.", "1.", "0.") +
                                node(27, "0.", "1.", "0.") + node(28, "0.", "0.", "1.") +
                                node(29, "1.", "0.", "1.") + node(30, "0.", "1.", "1.");
    const std::string surface = "/SURF/PART/EXT/1\ns\n" + ids({4});
    const std::string part = "/PART/4\np\n" + ids({3, 1});
    const Vec3 inside{.4, .4, .4};
    const Built tetra = with_cubes(surface, part + corners + "/TETRA4/4\n" + ids({41, 21, 22, 23, 24}));
    CHECK(tetra.surface().segments.size() == 4);
    CHECK(all_outward(tetra, inside));
    const Built curved = with_cubes(surface, part + corners + "/TETRA10/4\n" + ids({41}) +
                                                 ids({21, 22, 23, 24, 25, 26, 27, 28, 29, 30}));
    CHECK(curved.surface().segments.size() == 16);
    CHECK(all_outward(curved, inside));
    const Built wedge = with_cubes(surface, part + "/PENTA6/4\n" + ids({41, 1, 2, 3, 5, 6, 7}));
    CHECK(wedge.surface().segments.size() == 5);
    CHECK(all_outward(wedge, {.6, .3, .5}));
    const Built collapsed = with_cubes(surface, part + "/BRICK/4\n" + ids({41, 1, 2, 3, 3, 5, 6, 7, 7}));
    CHECK(collapsed.surface().segments.size() == 5);
    CHECK(all_outward(collapsed, {.6, .3, .5}));
    const Built inverted = with_cubes(surface, part + "/BRICK/4\n" + ids({41, 5, 6, 7, 8, 1, 2, 3, 4}));
    CHECK(inverted.surface().segments.size() == 6);
    CHECK(all_outward(inverted, {.5, .5, .5}));
}

TEST_CASE("surfaces by box, submodel and set; analytical and unknown ones") {
    const std::string box =
        "/BOX/RECTA/5\nb\n\n" + reals({"-1.", "-1.", "-1."}) + reals({"11.", "11.", "1."});
    CHECK(with_surface("/SURF/BOX/1\ns\n" + ids({5}), box).segments() == Segments{{1, 2, 5, 4}});
    CHECK(with_surface("/SURF/BOX2/1\ns\n" + ids({5}), box).segments() ==
          Segments{{1, 2, 5, 4}, {2, 3, 6, 5}});
    const Built plane = with_surface("/SURF/PLANE/1\ns\n\n");
    CHECK(plane.surface().segments.empty());
    CHECK(plane.surface().evaluated);
    const Built odd = with_surface("/SURF/NURBS/1\ns\n\n");
    CHECK_FALSE(odd.surface().evaluated);
    CHECK(odd.issues(ReadIssue::Kind::not_supported) == 1);

    const Built set = with_surface("/SET/GENERAL/1\ns\nSHELL_O            2\nSH3N               1\nSEG\n" +
                                   ids({9, 4, 5, 2, 1}) + "PART_D             7\n");
    CHECK(set.segments() == Segments{{4, 5, 2, 1}, {5, 6, 3, 2}, {3, 6, 103, 103}});
    CHECK(set.surface().lines.size() == 1);
    CHECK(set.surface().type == "SET");
    const Built parts = with_surface("/SET/GENERAL/1\ns\nPART               1\nSHELL_D            1\n");
    CHECK(parts.segments() == Segments{{2, 3, 6, 5}, {3, 6, 103, 103}});
    const Built both =
        with_surface("/SET/COLLECT/1\na\nSHELL              1\n/SET/COLLECT/1\nb\nSHELL              2\n");
    CHECK(both.segments() == Segments{{1, 2, 5, 4}, {2, 3, 6, 5}});
    CHECK(both.issues(ReadIssue::Kind::duplicate_id) == 0);
    const Built solids = with_cubes("/SET/GENERAL/1\ns\nPART               1         2\n");
    CHECK(solids.surface().segments.size() == 10);
    CHECK(with_cubes("/SET/GENERAL/1\ns\nPART_A             1         2\n").surface().segments.size() == 12);
}

TEST_CASE("a collected set goes on inside a submodel") {
    // Shell 1 of the submodel becomes 1001, its part 1 becomes 1001; the set's id stays.
    const std::string inside = steel + sheet + "/PART/1\np\n" + ids({1, 1}) + "/NODE\n" +
                               node(1, "10.", "0.", "0.") + node(2, "20.", "0.", "0.") +
                               node(3, "20.", "10.", "0.") + node(4, "10.", "10.", "0.") + "/SHELL/1\n" +
                               ids({1, 1, 2, 3, 4});
    const std::string submodel = "//SUBMODEL/1\nsub\n" + ids({1000});
    const Segments both{{1, 2, 5, 4}, {1001, 1002, 1003, 1004}};
    const Built collected =
        with_surface("/SET/COLLECT/1\na\nSHELL              1\n",
                     submodel + "/SET/COLLECT/1\nb\nPART               1\n" + inside + "//ENDSUB\n");
    CHECK(collected.segments() == both);
    CHECK(collected.model.issues().empty());
    const Built referred = with_surface(
        "/SET/GENERAL/1\na\nSET             1008\n/SET/COLLECT/7\nc\nSHELL              1\n",
        submodel + "/SET/GENERAL/8\nb\nSETCOL             7\nPART               1\n" + inside + "//ENDSUB\n");
    CHECK(referred.segments() == both);
    CHECK(referred.model.issues().empty());
}

TEST_CASE("segments of a set stand behind the columns of its key, or from the first column on") {
    const std::string indent(10, ' '), set = "/SET/GENERAL/1\ns\n";
    const Segments two{{1, 2, 5, 4}, {2, 3, 6, 5}};
    const std::string first = ids({4, 1, 2, 5, 4}), second = ids({1, 2, 3, 6, 5});
    const Built on_key = with_surface(set + "SEG       " + first + indent + second);
    CHECK(on_key.segments() == two);
    CHECK(on_key.surface().lines.size() == 2);
    CHECK(on_key.model.issues().empty());
    CHECK(with_surface(set + "SEG\n" + indent + first + indent + second).segments() == two);
    CHECK(with_surface(set + "SEG\n" + first + second).segments() == two);
    CHECK(with_surface(set + "SEG\n\n" + indent + first + "\n" + indent + second).segments() == two);
    // Two clauses, reversed, a triangle, a blank segment id.
    CHECK(with_surface(set + "SEG       " + first + "SEG_O     " + second).segments() ==
          Segments{{1, 2, 5, 4}, {5, 6, 3, 2}});
    CHECK(with_surface(set + "SEG       " + indent + ids({3, 6, 103})).segments() ==
          Segments{{3, 6, 103, 103}});
    CHECK(with_surface(set + "SEG\n,4,1,2,5,4\n" + indent + second).segments() == two);
    CHECK(with_surface(set + "SEG,4,1,2,5,4\nSHELL,2\n").segments() == two);
    const std::string named = "/PARAMETER/GLOBAL/INTEGER/1\np\nfive               5\n";
    const std::string cells = "         4         1         2     &five         4\n";
    CHECK(with_surface(set + "SEG       " + cells + "SHELL              2\n", named).segments() == two);
    // What is no number is told at its cell.
    const Built wrong = with_surface(set + "SEG                4         1        2x         5         4\n");
    REQUIRE(wrong.model.issues().size() >= 1);
    CHECK(wrong.deck->text(wrong.model.issues()[0].place) == "2x");
}

TEST_CASE("elements on nodes that do not exist are left out of surfaces") {
    const Built built = with_surface(part_surface, "/SHELL/1\n" + ids({3, 1, 2, 77, 4}));
    CHECK(built.segments() == Segments{{1, 2, 5, 4}, {2, 3, 6, 5}, {3, 6, 103, 103}});
    CHECK(built.issues(ReadIssue::Kind::unknown_node) == 1);
}

TEST_CASE("only elements that main surfaces can contain are read") {
    const std::string tool =
        "/PART/2\ntool\n" + ids({1, 1}) + "/SHELL/2\n" + ids({50, 1, 2, 5, 4}) + ids({51, 1, 2, 5, 4});
    const Built part = with_surface(part_surface, tool);
    CHECK(part.model.shells4().size() == 2);
    const Built seg = with_surface("/SURF/SEG/1\ns\n" + ids({0, 1, 2, 5, 4}), tool);
    CHECK(seg.model.shells4().size() == 4);
}

TEST_CASE("thickness on element cards") {
    const Built built = with_surface(part_surface, "/SHELL/1\n" + ids({3, 1, 2, 5, 4}).substr(0, 50) +
                                                       std::string(30, ' ') + reals({"2.5"}));
    CHECK(built.model.own_thickness(built.surface().segments[0]) == 0);
    CHECK(built.model.own_thickness(built.surface().segments[2]) == 2.5);
}
