// Transformations, attachments, other users of groups and surfaces.
#include "models.h"

#include <cmath>
#include <filesystem>

using namespace drawbead;

namespace {

Built with(const std::string& options, int version = 2022) {
    return build(begin_of(version) + mesh() + part_surface + bead_group + options + drawbead_block +
                 "/END\n");
}

/// Where bead node 101, at (5, 5, 3) without transformation, is.
Vec3 first_bead_node(const Built& built) {
    return built.model.nodes()[built.group().nodes.at(0)];
}

std::string first_card(int group, const std::string& x, const std::string& y, const std::string& z,
                       int node1 = 0, int node2 = 0, int submodel = 0) {
    const std::string head = ids({group}), numbers = reals({x, y, z}), nodes = ids({node1, node2, submodel});
    return head.substr(0, 10) + numbers.substr(0, 60) + nodes;
}
std::string second_card(const std::string& x, const std::string& y, const std::string& z,
                        const std::string& angle) {
    return std::string(10, ' ') + reals({x, y, z, angle});
}

void check_near(Vec3 a, Vec3 b) {
    CHECK(a.x == Approx(b.x).margin(1e-12));
    CHECK(a.y == Approx(b.y).margin(1e-12));
    CHECK(a.z == Approx(b.z).margin(1e-12));
}

} // namespace

TEST_CASE("transformations move node groups, in deck order") {
    const std::string tra = "/TRANSFORM/TRA/1\nt\n" + first_card(2, "1.", "2.", "3.");
    CHECK(first_bead_node(with(tra)) == Vec3{6, 7, 6});
    CHECK(with(tra).model.nodes()[NodeRow{0}] == Vec3{0, 0, 0});
    CHECK(first_bead_node(with("/TRANSFORM/TRA/1\nt\n" + first_card(2, "0.", "0.", "0.", 1, 3))) ==
          Vec3{25, 5, 3});
    const std::string rot =
        "/TRANSFORM/ROT/2\nt\n" + first_card(2, "0.", "0.", "0.") + second_card("0.", "0.", "1.", "90.");
    check_near(first_bead_node(with(rot)), {-5, 5, 3});
    check_near(first_bead_node(with(tra + rot)), {-7, 6, 6});
    check_near(first_bead_node(with(rot + tra)), {-4, 7, 6});
    const std::string about =
        "/TRANSFORM/ROT/2\nt\n" + first_card(2, "5.", "0.", "0.") + second_card("5.", "0.", "1.", "180.");
    check_near(first_bead_node(with(about)), {5, -5, 3});
    const std::string sym =
        "/TRANSFORM/SYM/3\nt\n" + first_card(2, "0.", "0.", "1.") + second_card("0.", "0.", "2.", "");
    check_near(first_bead_node(with(sym)), {5, 5, -1});
    const std::string sca = "/TRANSFORM/SCA/4\nt\n" + first_card(2, "2.", "3.", "1.", 2);
    check_near(first_bead_node(with(sca)), {0, 15, 3});
    const std::string matrix = "/TRANSFORM/MATRIX/5\nt\n" + ids({2}).substr(0, 10) +
                               reals({"0.", "1.", "0.", "7."}) + std::string(10, ' ') +
                               reals({"-1.", "0.", "0.", "0."}) + std::string(10, ' ') +
                               reals({"0.", "0.", "1.", "0."});
    check_near(first_bead_node(with(matrix)), {12, -5, 3});
}

TEST_CASE("transformations of submodels, nested ones included") {
    const std::string deck = "//SUBMODEL/4\n\n\n/NODE\n" + node(201, "1.", "1.", "1.") +
                             "//SUBMODEL/5\n\n\n/NODE\n" + node(202, "2.", "2.", "2.") +
                             "//ENDSUB\n//ENDSUB\n";
    const Built built = with(deck + "/TRANSFORM/TRA/1\nt\n" + first_card(0, "10.", "0.", "0.", 0, 0, 4));
    const NodeTable& nodes = built.model.nodes();
    CHECK(nodes[*nodes.row(NodeId{201})] == Vec3{11, 1, 1});
    CHECK(nodes[*nodes.row(NodeId{202})] == Vec3{12, 2, 2});
    CHECK(nodes[*nodes.row(NodeId{101})] == Vec3{5, 5, 3});
}

TEST_CASE("transformations that cannot be worked out are reported") {
    const Built position = with("/TRANSFORM/POSITION/1\nt\n" + ids({2}));
    CHECK(position.issues(ReadIssue::Kind::not_supported) == 1);
    CHECK(position.model.issues()[0].subject == "TRANSFORM/POSITION");
    CHECK(with("/TRANSFORM/TRA/1\nt\n" + first_card(0, "1.", "0.", "0."))
              .issues(ReadIssue::Kind::not_supported) == 1);
    CHECK(with("/TRANSFORM/TRA/1\nt\n" + first_card(9, "1.", "0.", "0."))
              .issues(ReadIssue::Kind::member_missing) == 1);
}

TEST_CASE("what holds the bead nodes") {
    const std::string holders =
        "/RBODY/7\nbody\n" + ids({102, 0, 0, 0}).substr(0, 40) + std::string(20, ' ') + ids({11}) +
        "/BCS/3\nfixed\n   111 111         0        12\n" + "/IMPVEL/4\nvelocity\n" + ids({1, 0, 0, 0, 11}) +
        "/IMPDISP/5\nmotion\n" + ids({1, 0, 0, 0, 13}) + "/RBE2/6\nlink\n" + ids({0, 0, 0, 11}) +
        "/BCS/8\nunknown group\n   111 111         0        99\n" + "/GRNOD/NODE/11\ng\n" + ids({1, 101}) +
        "/GRNOD/GENE/12\ng\n" + ids({1, 102}) + "/GRNOD/PART/13\nblank\n" + ids({1});
    const Built built = with(holders);
    const auto kinds = [&](std::size_t node) {
        std::vector<std::pair<Attachment::Kind, int64_t>> found;
        for (const Attachment& a : built.model.attachments(built.group().nodes.at(node)))
            found.emplace_back(a.kind, a.id);
        return found;
    };
    using K = Attachment::Kind;
    using Found = std::vector<std::pair<Attachment::Kind, int64_t>>;
    CHECK(kinds(0) ==
          Found{{K::rigid_body, 7}, {K::boundary_condition, 3}, {K::imposed_velocity, 4}, {K::other, 6}});
    CHECK(kinds(1) == Found{{K::rigid_body, 7}, {K::boundary_condition, 3}});
    CHECK(kinds(2).empty());
    CHECK(built.model.attachments(NodeRow{0}).empty()); // no bead node
}

TEST_CASE("other users of a group and a surface") {
    const Built built =
        with("/BCS/3\nfixed\n   111 111         0         2\n/INTER/TYPE7/9\nother\n" + ids({5, 1}) +
             "/GRNOD/GRNOD/12\ng\n" + ids({2}) + "/SURF/SURF/13\ns\n" + ids({-1}) + "/NEW/1\nunknown\n" +
             ids({0, 2}) + "/FUNCT/2\nf\n" + reals({"1.", "2."}) + "/TH/INTER/1\nth\nDEF\n" + ids({1}));
    const auto headers = [&](const std::vector<BlockIndex>& blocks) {
        std::vector<std::string> found;
        for (const BlockIndex block : blocks)
            found.emplace_back(built.deck->text(built.deck->blocks()[block].header));
        return found;
    };
    CHECK(headers(built.group().users) == std::vector<std::string>{"/BCS/3", "/GRNOD/GRNOD/12", "/NEW/1"});
    CHECK(headers(built.surface().users) == std::vector<std::string>{"/INTER/TYPE7/9", "/SURF/SURF/13"});
}

TEST_CASE("every solver scene builds without an issue") {
    std::size_t scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(DRAWBEAD_TESTS_DIR "/truth")) {
        if (!entry.is_directory()) continue;
        const std::string name = entry.path().filename().string();
        INFO(name);
        DiskReader reader;
        const auto deck = Deck::read((entry.path() / (name + "_0000.rad")).string(), reader);
        REQUIRE(deck);
        const Model model = Model::build(*deck, everything, 2);
        ++scenes;
        CHECK(model.issues().empty());
        REQUIRE_FALSE(model.drawbeads().empty());
        for (const Drawbead& bead : model.drawbeads()) {
            REQUIRE(bead.group);
            REQUIRE(bead.surface);
            CHECK_FALSE(bead.title_missing);
            const NodeGroup& group = model.groups()[*bead.group];
            const Surface& surface = model.surfaces()[*bead.surface];
            CHECK((group.order == NodeGroup::Order::sorted) == (name == "h_sorted"));
            CHECK(!group.nodes.empty());
            for (const NodeRow node : group.nodes)
                CHECK(model.attachments(node).size() == 1);
            CHECK(!surface.segments.empty());
            for (const Segment& segment : surface.segments) {
                const Material* material = model.material_of(segment);
                REQUIRE(material);
                CHECK(material->stiffness == Material::Stiffness::known);
            }
            // Parts whose element ids interleave stand in two blocks.
            CHECK(surface.in_storage_order == (name != "n_two_thick" && name != "n2_two_thick_reset"));
        }
    }
    CHECK(scenes >= 60);
}
