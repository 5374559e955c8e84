// Decks that were run through the real solver, from their text alone: what the Starter said, and the first
// traced cycle.
#include "contact/scene.h"
#include "scene/deck_contact.h"
#include "scene/starter.h"
#include "scene/table.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <map>
#include <memory>
#include <regex>
#include <sstream>

using namespace drawbead;

namespace {

std::vector<std::string> scene_names() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(DRAWBEAD_TESTS_DIR "/truth"))
        if (entry.is_directory()) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::string folder_of(const std::string& name) {
    return DRAWBEAD_TESTS_DIR "/truth/" + name + "/";
}

struct Read {
    std::unique_ptr<Deck> deck;
    Model model;
};

Read read_deck(const std::string& name) {
    DiskReader reader;
    auto deck = Deck::read(folder_of(name) + name + "_0000.rad", reader);
    REQUIRE(deck);
    Read read;
    read.deck = std::make_unique<Deck>(std::move(*deck));
    read.model = Model::build(*read.deck, needs_contact, 2);
    return read;
}

/// What outcome.json records of the Starter.
struct Outcome {
    std::set<int> messages;
    std::map<int64_t, std::vector<int64_t>> nodes_346;
};

Outcome read_outcome(const std::string& name) {
    std::ifstream file(folder_of(name) + "outcome.json");
    std::stringstream stream;
    stream << file.rdbuf();
    const std::string text = stream.str();
    const auto part = [&](const std::string& key) {
        const std::size_t begin = text.find('{', text.find('"' + key + '"'));
        return text.substr(begin, text.find('}', begin) - begin);
    };
    Outcome outcome;
    const std::string messages = part("starter_messages"), nodes = part("nodes_346");
    const std::regex message("(?:error|warning) (\\d+)"), list("\"(\\d+)\":\\s*\\[([^\\]]*)\\]"),
        number("\\d+");
    using Each = std::sregex_iterator;
    for (Each m(messages.begin(), messages.end(), message), end; m != end; ++m)
        outcome.messages.insert(std::stoi((*m)[1]));
    outcome.messages.erase(312); // of /BCS, not of the interface
    for (Each m(nodes.begin(), nodes.end(), list), end; m != end; ++m) {
        const std::string ids = (*m)[2];
        for (Each id(ids.begin(), ids.end(), number); id != end; ++id)
            outcome.nodes_346[std::stoll((*m)[1])].push_back(std::stoll(id->str()));
    }
    return outcome;
}

void require_near(double ours, double theirs, double scale) {
    REQUIRE(std::abs(ours - theirs) <= 1e-12 * std::max(scale, std::abs(theirs)));
}

/// A traced row against the solver's first step over the blank where it stood then.
void compare(const Read& read, const DeckContact& contact, const InterfaceContact& one,
             const std::vector<Vec3>& blank, const Scene::Row& row, bool moved) {
    const Drawbead& bead = *one.bead;
    const SurfaceScene& surface = contact.surfaces[*bead.surface];
    const auto i = static_cast<std::size_t>(row.place) - 1;
    REQUIRE(row.node == value(read.model.nodes().user_id(one.group->nodes[i])));
    REQUIRE(row.x == one.x[i]);
    Track track = one.track[i];
    const SolverHit hit = solver_step(track, surface.mesh, blank, one.x[i]);
    std::array<uint32_t, 4> segment;
    for (std::size_t k = 0; k < 4; ++k)
        segment[k] = surface.mesh.node_id[surface.mesh.segment[hit.segment][k]];
    REQUIRE(segment == row.segment);
    REQUIRE(hit.inside == row.inside);
    require_near(hit.xi, row.xi, 1);
    require_near(hit.eta, row.eta, 1);
    require_near(hit.d, row.d, 50);
    const SegmentStiffness s = (*surface.stiffness)(surface.mesh.segment_index[hit.segment]);
    require_near(s.k, row.k, 0);
    require_near(s.half_thickness, row.g, 0);
    const double penetration = solver_penetration(hit, bead.depth, s.half_thickness);
    require_near(penetration, row.pen, 50);
    const BeadNodeContact& node = one.contact.node[i];
    require_near(one.contact.slope.of(s.k), row.slope, 0);
    if (node.slope_read)
        require_near(*node.slope_read, row.slope_read, 0);
    else
        REQUIRE(i >= one.surface->segments.size());
    if (penetration > 0) require_near(solver_tributary(hit.normal, one.line.half_chord[i]).l, row.l, 0);
    if (bead.fn_varies() || bead.ft_varies()) {
        require_near(one.line.s[i], row.s, 0);
        require_near(one.line.length, row.s_total, 0);
    }
    if (bead.fn_first != 0) require_near(one.fn[i], row.fn, 0);
    require_near(one.ft[i], row.ft, 0);

    if (moved) return; // the table shows the deck's positions
    const DeckTable table = table_of(read.model, contact, bead.id);
    REQUIRE(table.beads.size() == 1);
    const BeadTableRow& shown = table.beads[0].rows.at(i);
    REQUIRE(shown.met);
    REQUIRE(shown.node == row.node);
    for (std::size_t k = 0; k < 4; ++k)
        REQUIRE(shown.n[k] == row.segment[k]);
    REQUIRE(shown.inside == row.inside);
    require_near(shown.xi, row.xi, 1);
    require_near(shown.eta, row.eta, 1);
    require_near(shown.distance, row.d, 50);
    require_near(shown.half_thickness, row.g, 0);
    require_near(shown.penetration, row.pen, 50);
    require_near(shown.stiffness, row.k, 0);
    require_near(shown.slope, row.slope, 0);
    if (shown.slope_read) require_near(*shown.slope_read, row.slope_read, 0);
    if (row.pen > 0) require_near(shown.tributary, row.l, 0);
}

} // namespace

TEST_CASE("the Starter's messages and the nodes of 346 are foreseen from the deck") {
    const std::vector<std::string> names = scene_names();
    REQUIRE(names.size() == 60);
    for (const std::string& name : names) {
        CAPTURE(name);
        const Read read = read_deck(name);
        const Outcome theirs = read_outcome(name);
        const StarterMessages ours = starter_messages(read.model, starter_of(read.model, 2));
        CHECK(std::set<int>(ours.messages.begin(), ours.messages.end()) == theirs.messages);
        std::map<int64_t, std::vector<int64_t>> nodes;
        for (const StarterMessages::Interface& one : ours.interfaces)
            if (!one.nodes_346.empty()) nodes[one.id] = one.nodes_346;
        CHECK(nodes == theirs.nodes_346);

        // The whole computation says the same.
        std::vector<StarterVerdict> verdicts;
        for (const InterfaceContact& one : contact_of(read.model, {}).interfaces)
            verdicts.push_back(one.starter);
        const StarterMessages again = starter_messages(read.model, verdicts);
        CHECK(again.messages == ours.messages);
        for (std::size_t i = 0; i < ours.interfaces.size(); ++i)
            CHECK(again.interfaces[i].nodes_346 == ours.interfaces[i].nodes_346);
    }
}

TEST_CASE("the first traced cycle follows from the deck alone") {
    std::size_t rows = 0, in_table = 0;
    for (const std::string& name : scene_names()) {
        const Scene scene = read_scene(DRAWBEAD_TESTS_DIR "/contact/data/" + name + ".txt");
        if (scene.row.empty()) continue;
        const Read read = read_deck(name);
        const DeckContact contact = contact_of(read.model, {});
        const bool moved = !(scene.moved == Vec3{});
        for (const Scene::Row& row : scene.row) {
            CAPTURE(name, row.node);
            const InterfaceContact& one = contact.interfaces.at(static_cast<std::size_t>(row.bead) - 1);
            REQUIRE(one.unknown.empty());
            std::vector<Vec3> blank = contact.surfaces[*one.bead->surface].mesh.x;
            for (Vec3& p : blank)
                p += scene.moved;
            compare(read, contact, one, blank, row, moved);
            ++rows;
            in_table += !moved;
        }
    }
    CHECK(rows > 500);
    CHECK(in_table > 400);
}
