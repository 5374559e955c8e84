// What a deck prescribes of the motion of the nodes that matter.
#include "models.h"

using namespace drawbead;

namespace {

constexpr Needs moving = Needs::coordinates | Needs::blank_elements | Needs::motion;
using Kind_ = MotionCondition::Kind;

std::string deck(const std::string& blocks, const std::string& units = "") {
    return begin_of(2022, units) + mesh() + part_surface + bead_group + drawbead_block + blocks + "/END\n";
}

/// Conditions of a node, in deck order.
std::vector<const MotionCondition*> of(const Built& b, int id) {
    const DeckMotion& motion = b.model.motion();
    const auto row = b.model.nodes().row(NodeId{static_cast<uint32_t>(id)});
    std::vector<const MotionCondition*> out;
    for (const uint32_t c : motion.classes[motion.of_node[index(*row)]])
        out.push_back(&motion.conditions[c]);
    return out;
}

const std::string group_of_all = "/GRNOD/PART/7\nall\n         1\n";
const std::string ramp = "/FUNCT/3\nramp\n" + reals({"0.", "0."}) + reals({"1.", "5."});

} // namespace

TEST_CASE("motion: conditions, their scales and the nodes that they act on") {
    const Built b =
        build(deck(group_of_all + ramp + "/IMPVEL/1\nx\n" + cells({"3", "X", "0", "4", "7", "0", "0"}, 10) +
                   reals({"2.", "10.", "0.", "0."}) + "/BCS/2\nheld\n   011 111" + cells({"0", "7"}, 10) +
                   "/INIVEL/TRA/5\nkick\n" + reals({"1.", "2.", "3."}).substr(0, 60) + cells({"2", "0"}, 10)),
              moving);
    const auto blank = of(b, 5);
    REQUIRE(blank.size() == 2);
    CHECK(blank[0]->kind == Kind_::velocity);
    CHECK(blank[0]->translation == std::array<bool, 3>{true, false, false});
    CHECK(blank[0]->time_scale == 2);
    CHECK(blank[0]->scale == 10);
    CHECK(blank[0]->t_stop == 1e30);
    CHECK(blank[0]->sensor == 4);
    CHECK(b.model.motion().functions.at(blank[0]->function).y == std::vector<double>{0, 5});
    CHECK(blank[1]->kind == Kind_::fixed);
    CHECK(blank[1]->translation == std::array<bool, 3>{false, true, true});
    CHECK(blank[1]->rotation == std::array<bool, 3>{true, true, true});
    const auto bead = of(b, 102);
    REQUIRE(bead.size() == 1);
    CHECK(bead[0]->kind == Kind_::initial_velocity);
    CHECK(bead[0]->velocity == Vec3{1, 2, 3});
    CHECK(b.model.motion().classes.size() == 4); // none, x alone on the way, both, the bead
}

TEST_CASE("motion: a blank scale is 1 in the option's own units") {
    const Built b = build(deck(ramp + "/IMPVEL/1\nx\n" + cells({"3", "Z", "0", "0", "2"}, 10),
                               "                  kg                   m                   s\n"),
                          moving);
    REQUIRE(of(b, 101).size() == 1);
    CHECK(of(b, 101)[0]->scale == Approx(1000)); // m/s in mm/s
    CHECK(of(b, 101)[0]->time_scale == 1);
}

TEST_CASE("motion: what is not read is known to act") {
    const Built b =
        build(deck(ramp + "/IMPVEL/1\nx\n" + cells({"3", "X", "9", "0", "2"}, 10) + "/RLINK/2\nlink\n" +
                   cells({"111", "111", "2"}, 10) + "/IMPDISP/3\nx\n" + cells({"4", "X", "0", "0", "2"}, 10)),
              moving);
    const auto bead = of(b, 101);
    REQUIRE(bead.size() == 3);
    CHECK(bead[0]->kind == Kind_::unknown);
    CHECK(bead[0]->why == "directions of a skew or frame are not read");
    CHECK(bead[1]->kind == Kind_::unknown);
    CHECK(bead[2]->kind == Kind_::displacement);
    CHECK(b.model.motion().functions.at(bead[2]->function).unusable == "/FUNCT/4 is not defined");
}

TEST_CASE("motion: loads push and initial rotations are named, but neither says where a node goes") {
    const Built b =
        build(deck(ramp + "/CLOAD/1\npress\n" + cells({"3", "Z", "0", "0", "2", "0"}, 10) +
                   "/CLOAD/2\nturn\n" + cells({"3", "ZZ", "9", "0", "2", "0"}, 10) + "/INIVEL/ROT/3\nspin\n" +
                   reals({"0.", "0.", "1."}).substr(0, 60) + cells({"2"}, 10)),
              moving);
    const auto bead = of(b, 101);
    REQUIRE(bead.size() == 3);
    CHECK(bead[0]->kind == Kind_::load);
    CHECK(bead[0]->translation == std::array{false, false, true});
    CHECK(bead[0]->scale == 1);
    CHECK(bead[0]->why.empty());
    CHECK(bead[1]->kind == Kind_::load);
    CHECK(bead[1]->rotation == std::array{false, false, true});
    CHECK(bead[1]->why == "directions of a skew are not read");
    CHECK(bead[2]->kind == Kind_::initial_unread);
}

TEST_CASE("motion: nothing is read without the need, and targets stand for the deck's own") {
    const std::string text =
        deck(group_of_all + ramp + "/IMPVEL/1\nx\n" + cells({"3", "X", "0", "0", "7"}, 10));
    CHECK(build(text, everything).model.motion().of_node.empty());
    const Built b = build(text, moving);
    using Target = MotionTarget::Kind;
    const std::vector<MotionTarget> targets{{Target::bead, 1},       {Target::main_surface, 1},
                                            {Target::part, 1},       {Target::surface, 1},
                                            {Target::node_group, 7}, {Target::node_group, 8}};
    const Model model = Model::build(*b.deck, moving, 1, targets);
    const auto& held = model.motion().target_nodes;
    REQUIRE(held.size() == 6);
    CHECK(held[0] == 3);
    CHECK(held[1] == 6);
    CHECK(held[2] == 6);
    CHECK(held[3] == 6);
    CHECK(held[4] == 6);
    CHECK_FALSE(held[5]);
    const auto row = model.nodes().row(NodeId{2});
    const auto& acting = model.motion().classes[model.motion().of_node[index(*row)]];
    REQUIRE(acting.size() == 4);
    CHECK(model.motion().conditions[acting[0]].function == 1);
}
