// Totals and the manual's comparison.
#include "model/models.h"
#include "scene/table.h"

#include <algorithm>

using namespace drawbead;

namespace {

DeckTable table_of_text(const std::string& text, std::optional<InterfaceId> only = {}) {
    const Built built = build(text);
    return table_of(built.model, contact_of(built.model, {}), only);
}

std::string deck(const std::string& rest = {}) {
    return begin_of(2022) + mesh() + part_surface + bead_group + drawbead_block + rest;
}

const std::string second_bead = "/GRNOD/NODENS/3\nhalf\n" + ids({102, 103}) +
                                "/INTER/TYPE8/2\nsecond\n         3         1                   2\n" +
                                reals({"10.", "0.", "2.", "0.", "0."}) + reals({"0.", "0."});

} // namespace

TEST_CASE("limits run along the bead and sum up to forces") {
    const DeckTable table = table_of_text(deck());
    REQUIRE(table.beads.size() == 1);
    const BeadTable& bead = table.beads[0];
    REQUIRE(bead.rows.size() == 3);
    CHECK(bead.totals.length == 10);
    CHECK(bead.rows[0].tributary == 2.5);
    CHECK(bead.rows[1].tributary == 5);
    CHECK(bead.rows[1].fn_limit == 70);
    CHECK(bead.rows[2].ft_limit == 90);
    CHECK(bead.totals.force.fn == 80 * 2.5 + 70 * 5 + 60 * 2.5);
    CHECK(bead.totals.force.ft == 100 * 2.5 + 95 * 5 + 90 * 2.5);
    CHECK(bead.totals.inside == 3);
    CHECK(bead.totals.different_segments == 0);
    CHECK(bead.totals.largest_difference == 0);
    CHECK(table.force.fn == bead.totals.force.fn);
    CHECK(table.force_unit == "N");
}

TEST_CASE("the manual compares Fn / DEPTH with the stiffness of the segment, number against number") {
    const BeadTable ramp = table_of_text(deck()).beads[0];
    CHECK(ramp.rows[0].manual_slope == 40);
    CHECK_FALSE(ramp.rows[0].manual_reset);
    CHECK_FALSE(ramp.rows[0].reset);
    CHECK(ramp.rows[0].slope == 40);

    const auto with_depth = [](const std::string& depth) {
        std::string text = deck();
        const std::string old = reals({"80.", "100.", "2.", "0.", "0."});
        return table_of_text(
                   text.replace(text.find(old), old.size(), reals({"80.", "100.", depth, "0.", "0."})))
            .beads[0];
    };
    const BeadTable steep = with_depth("1e-3"); // 80000 against 42000
    CHECK(steep.rows[0].manual_slope == 80000);
    CHECK(steep.rows[0].manual_reset);
    CHECK(steep.rows[0].reset);
    CHECK(steep.rows[0].slope == 42000);
    CHECK(steep.rows[2].slope_read == std::nullopt); // three nodes, two segments

    const BeadTable flat = with_depth("0."); // the manual takes the stiffness, the solver warns with 1043
    CHECK(flat.rows[0].manual_slope == 42000);
    CHECK(flat.rows[0].manual_reset);
    CHECK_FALSE(flat.rows[0].reset);
    CHECK(flat.rows[0].slope == 42000);
    CHECK(flat.rows[0].penetration == 1);
}

TEST_CASE("tools are the rigid bodies that carry the nodes") {
    const std::string rigid =
        "/RBODY/5\npunch\n" + ids({6, 0, 0, 0}).substr(0, 40) + std::string(20, ' ') + ids({7});
    const DeckTable table =
        table_of_text(deck(second_bead + "/GRNOD/NODE/7\nslaves\n" + ids({101, 102}) + rigid));
    REQUIRE(table.beads.size() == 2);
    REQUIRE(table.tools.size() == 2);
    CHECK(table.tools[0].rigid_body == 5);
    CHECK(table.tools[0].interfaces == std::vector<int64_t>{1, 2});
    CHECK_FALSE(table.tools[1].rigid_body);
    CHECK(table.tools[0].force.nodes + table.tools[1].force.nodes == 5);
    CHECK(table.tools[0].force.fn + table.tools[1].force.fn == Approx(table.force.fn));
    CHECK(table.force.fn == table.beads[0].totals.force.fn + table.beads[1].totals.force.fn);
}

TEST_CASE("one interface alone") {
    const DeckTable table = table_of_text(deck(second_bead), 2);
    REQUIRE(table.beads.size() == 1);
    CHECK(table.beads[0].interface_id == 2);
    CHECK(table.force.nodes == 2);
    CHECK(table_of_text(deck(), 9).beads.empty());
}

TEST_CASE("a bead whose surface is missing keeps what its list says") {
    std::string text = deck();
    text.replace(text.find("/SURF/PART/1"), 12, "/SURF/PART/8");
    const DeckTable table = table_of_text(text);
    REQUIRE(table.beads.size() == 1);
    CHECK(table.beads[0].unknown == "surface 1 is not defined");
    CHECK(table.warnings ==
          std::vector<std::string>{"interface 1 is not computed: surface 1 is not defined"});
    REQUIRE(table.beads[0].rows.size() == 3);
    CHECK_FALSE(table.beads[0].rows[0].met);
    CHECK(table.beads[0].rows[1].tributary == 5);
    CHECK(table.beads[0].totals.force.fn == 80 * 2.5 + 70 * 5 + 60 * 2.5);
}

TEST_CASE("a sorted group is taken in the order of its ids") {
    std::string text = deck();
    const std::string old = "/GRNOD/NODENS/2\nbead line\n" + ids({101, 102, 103});
    text.replace(text.find(old), old.size(), "/GRNOD/NODE/2\nbead line\n" + ids({103, 101, 102}));
    const Built built = build(text);
    const DeckContact contact = contact_of(built.model, {});
    CHECK(contact.interfaces[0].starter.error_112);
    const DeckTable table = table_of(built.model, contact);
    CHECK(table.beads[0].rows[0].node == 101);
    CHECK(table.beads[0].rows[2].node == 103);
}
