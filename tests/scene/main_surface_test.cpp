// Stiffness of segments by every way that a surface is built.
#include "model/models.h"
#include "scene/deck_contact.h"

#include <algorithm>
#include <limits>

using namespace drawbead;

namespace {

const std::string thick = "/PROP/SHELL/2\nthick\n\n\n         5                           2.0\n";
const std::string soft =
    "/MAT/ELAST/2\nsoft\n             7.85E-9\n                 100                  .3\n";

/// The smallest deck with the first shell in part 1 and the second in a part 2 of its own.
std::string two_parts(const std::string& second, const std::string& surface) {
    std::string text = begin_of(2022) + mesh() + thick + soft + "/PART/2\nsecond\n" + second + surface +
                       bead_group + drawbead_block;
    const std::string row = ids({2, 2, 3, 6, 5});
    text.replace(text.find(row), row.size(), "");
    return text + "/SHELL/2\n" + row;
}
const std::string both = "/SURF/PART/1\nboth\n         1         2\n";

} // namespace

TEST_CASE("thickness is the property's, the modulus the material's") {
    const Built built = build(begin_of(2022) + mesh() + part_surface + bead_group + drawbead_block);
    const SurfaceStiffness stiffness(built.model, built.surface(), 1);
    CHECK(stiffness(0).k == 0.2 * 210000 * 1.0);
    CHECK(stiffness(0).half_thickness == 0.5);
    CHECK(stiffness.smallest() == stiffness(1).k);
    CHECK(stiffness.in_storage_order(5) == std::vector<double>(2, 42000.0));
    CHECK(stiffness.doubts().empty());
}

TEST_CASE("the minimum is over all parts, in storage order each has its own") {
    const Built built = build(two_parts(ids({2, 2, 0}), both));
    const SurfaceStiffness stiffness(built.model, built.surface(), 2);
    CHECK(stiffness(1).k == 0.2 * 100 * 2.0);
    CHECK(stiffness.smallest() == 40.0);
    CHECK(stiffness.in_storage_order(1) == std::vector<double>{42000.0});
    CHECK(stiffness.in_storage_order(2) == std::vector<double>{42000.0, 40.0});
}

TEST_CASE("without a modulus the stiffness is 0 and counts in the minimum") {
    const std::string empty = "/MAT/VOID/3\nempty\n             7.85E-9\n";
    const Built built = build(two_parts(ids({1, 3, 0}), both + empty));
    const SurfaceStiffness stiffness(built.model, built.surface(), 1);
    CHECK(stiffness(1).k == 0);
    CHECK(stiffness.smallest() == 0);
    CHECK_FALSE(starter_of(built.model, 1)[0].warning_1040);
}

TEST_CASE("a part that lacks its material is a doubt and takes no part in the minimum") {
    const Built built = build(two_parts(ids({1, 9, 0}), both));
    const SurfaceStiffness stiffness(built.model, built.surface(), 1);
    CHECK(stiffness(1).k == 0);
    CHECK(stiffness.smallest() == 42000);
    CHECK(stiffness.doubts() == std::vector<std::string>{"part 2: material 9 does not exist"});
}

TEST_CASE("a listed segment without element has no stiffness and no place in the minimum") {
    const Built built = build(begin_of(2022) + mesh() + "/SURF/SEG/1\nlisted\n" + ids({1, 1, 2, 5, 4}) +
                              ids({2, 1, 3, 6, 4}) + bead_group + drawbead_block);
    const SurfaceStiffness stiffness(built.model, built.surface(), 1);
    REQUIRE(built.surface().segments.size() == 2);
    CHECK(stiffness(0).k == 42000);
    CHECK(stiffness(1).k == 0);
    CHECK(stiffness(1).smallest == std::numeric_limits<double>::infinity());
    CHECK(stiffness.smallest() == 42000);
}

TEST_CASE("the face of a tetrahedron stands on the volume of the solver's stored corners") {
    // Corners 11224334: at the centre the Jacobian gives one and a half times the volume.
    const std::string text =
        begin_of(2022) + steel + "/PROP/SOLID/1\nsolid\n" + ids({1}) + "/PART/1\nblank\n" + ids({1, 1, 0}) +
        "/NODE\n" + node(1, "0.", "0.", "0.") + node(2, "10.", "0.", "0.") + node(3, "0.", "10.", "0.") +
        node(4, "0.", "0.", "-10.") + node(101, "1.", "1.", "3.") + node(102, "2.", "2.", "3.") +
        node(103, "3.", "3.", "3.") + "/TETRA4/1\n" + ids({1, 1, 2, 3, 4}) + "/SURF/SEG/1\nlisted\n" +
        ids({1, 1, 2, 3, 3}) + bead_group + drawbead_block;
    const Built built = build(text);
    const SurfaceStiffness stiffness(built.model, built.surface(), 1);
    const double volume = 1000.0 / 6, bulk = 210000 / (3 * (1 - 2 * 0.3));
    CHECK(stiffness(0).k == Approx(0.2 * 50 * 50 * bulk / (1.5 * volume)));
    CHECK(stiffness(0).half_thickness == 0);
    CHECK(stiffness.smallest() == stiffness(0).k);
}

TEST_CASE("Ipri of /IOFLAG keeps the Starter quiet about nodes beside the blank") {
    // The bead runs past the blank's end; turned round, the blank is on its wrong side everywhere.
    std::string text = begin_of(2022) + mesh() + "/SURF/PART/1\nblank, from below\n        -1\n" +
                       bead_group + drawbead_block;
    const std::string last = node(103, "15.0", "5.0", "3.0");
    text.replace(text.find(last), last.size(), node(103, "25.0", "5.0", "3.0"));
    const Built quiet = build(text + "/IOFLAG\n" + ids({1})), talking = build(text);
    CHECK(talking.model.ipri() == 0);
    CHECK(quiet.model.ipri() == 1);
    CHECK(starter_of(talking.model, 1)[0].nodes_346 == std::vector<uint32_t>{0, 1, 2});
    CHECK(starter_of(quiet.model, 1)[0].nodes_346 == std::vector<uint32_t>{0, 1});
}
