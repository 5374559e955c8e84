// Normals: a damaged deck is repaired into what its clean twin is for the contact, by an edit that is the
// same again on a second run, and that touches nothing else.
#include "rules/fix.h"
#include "sheet_deck.h"

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include <algorithm>
#include <numeric>

using namespace drawbead;

namespace {

using Files = std::map<std::string, std::string>;
using Codes = std::set<std::string>;

FixOutcome fix(const Files& files, FixChoices choices = {}) {
    MemoryReader reader = reader_of(files);
    FixOptions options;
    options.choices = choices;
    return run_fixes("deck.rad", reader, {}, options);
}

Files fixed_files(Files files, const FixOutcome& outcome) {
    for (const FixedFile& file : outcome.files) {
        REQUIRE(files.at(file.path) == file.original);
        REQUIRE(edited(file.original, file.edits) == file.text);
        files[file.path] = std::string(file.text);
    }
    return files;
}

Codes side_findings(const DeckResult& result) {
    Codes codes;
    for (const Finding& f : result.findings)
        if (f.code == "SRF001" || f.code == "SRF002" || f.code == "SRF003") codes.insert(f.code);
    return codes;
}

/// What the solver makes of each bead node in the first cycle, by user ids.
struct NodeSeen {
    int64_t node;
    std::array<int64_t, 4> segment;
    bool inside, warned;
    double xi, eta, d, penetration, k, slope;
    Vec3 normal;
    friend bool operator==(const NodeSeen&, const NodeSeen&) = default;
};
std::map<InterfaceId, std::vector<NodeSeen>> scene(const Files& files) {
    MemoryReader reader = reader_of(files);
    const auto deck = Deck::read("deck.rad", reader);
    REQUIRE(deck);
    const Model model = Model::build(*deck, needs_contact, 1);
    const DeckContact contact = contact_of(model, {});
    std::map<InterfaceId, std::vector<NodeSeen>> out;
    for (const InterfaceContact& one : contact.interfaces) {
        CAPTURE(one.unknown);
        REQUIRE(one.unknown.empty());
        for (std::size_t i = 0; i < one.contact.node.size(); ++i) {
            const BeadNodeContact& n = one.contact.node[i];
            NodeSeen seen{value(model.nodes().user_id(one.group->nodes[i])),
                          {},
                          n.inside,
                          n.warned_346,
                          n.xi,
                          n.eta,
                          n.distance,
                          n.penetration,
                          n.k,
                          n.slope,
                          n.normal};
            for (std::size_t c = 0; c < 4; ++c)
                seen.segment[c] = value(model.nodes().user_id(NodeRow{n.nodes[c]}));
            out[one.bead->id].push_back(seen);
        }
    }
    return out;
}

/// Repairs the damaged deck and looks at everything that is promised.
FixOutcome repaired(const SheetDeck& damaged, FixChoices choices = {}) {
    SheetDeck clean = damaged;
    clean.flipped.clear();
    clean.minus.clear();
    const Files files = damaged.files();
    FixOutcome outcome = fix(files, choices);
    REQUIRE_FALSE(outcome.before.failed());
    CHECK_FALSE(side_findings(outcome.before).empty());
    CHECK(side_findings(outcome.after).empty());
    CHECK(outcome.declined.empty());
    const Files after = fixed_files(files, outcome);
    CHECK(scene(after) == scene(clean.files()));
    const FixOutcome again = fix(after, choices);
    CHECK_FALSE(again.changed());
    return outcome;
}

std::set<int> range(int from, int to) {
    std::set<int> ids;
    for (int i = from; i <= to; ++i)
        ids.insert(i);
    return ids;
}
std::set<int> all_of(const SheetDeck& deck) {
    std::set<int> ids;
    for (const auto& e : deck.elements())
        ids.insert(e.id);
    return ids;
}
std::set<int> except(std::set<int> ids, const std::set<int>& some) {
    for (const int id : some)
        ids.erase(id);
    return ids;
}
/// Elements of a patch around the middle of an element.
std::set<int> patch(const SheetDeck& deck, int i0, int j0, int radius) {
    std::set<int> ids;
    const auto all = all_of(deck);
    for (int j = std::max(0, j0 - radius); j <= std::min(deck.ny - 1, j0 + radius); ++j)
        for (int i = std::max(0, i0 - radius); i <= std::min(deck.nx - 1, i0 + radius); ++i)
            for (const int id : {1 + j * deck.nx + i, 1001 + j * deck.nx + i})
                if (all.count(id)) ids.insert(id);
    return ids;
}

std::string title_of(const FixOutcome& outcome) {
    REQUIRE(outcome.applied.size() == 1);
    return outcome.applied[0].title;
}

std::size_t lines_changed(const FixOutcome& outcome) {
    std::size_t lines = 0;
    for (const FixedFile& file : outcome.files)
        lines += file.edits.size();
    return lines;
}

using Form = SheetDeck::Surface;
constexpr Form every_surface[] = {Form::part,         Form::seg,         Form::grshel,
                                  Form::surf_of_part, Form::surf_of_seg, Form::set};

} // namespace

TEST_CASE("the clean sheet is clean, in every form of its surface") {
    for (const Form surface : every_surface)
        for (const bool triangles : {false, true}) {
            SheetDeck deck;
            deck.surface = surface;
            deck.triangles = triangles;
            const FixOutcome outcome = fix(deck.files());
            CAPTURE(static_cast<int>(surface), triangles);
            for (const Finding& f : outcome.before.findings)
                CHECK((f.code + " " + f.message).substr(0, f.severity == Severity::error ? 200 : 0) == "");
            CHECK_FALSE(outcome.changed());
            CHECK(side_findings(outcome.before).empty());
        }
}

TEST_CASE("a whole surface the wrong way round, and patches of it") {
    for (const Form surface : every_surface)
        for (const bool triangles : {false, true}) {
            SheetDeck deck;
            deck.surface = surface;
            deck.triangles = triangles;
            CAPTURE(static_cast<int>(surface), triangles);
            for (const std::set<int>& ids :
                 {all_of(deck), patch(deck, 4, 3, 0), patch(deck, 5, 3, 1), patch(deck, 4, 4, 2),
                  patch(deck, 0, 0, 3), except(all_of(deck), patch(deck, 4, 3, 1)), range(1, 40)}) {
                SheetDeck damaged = deck;
                for (const int id : ids)
                    if (all_of(deck).count(id)) damaged.flipped.insert(id);
                repaired(damaged);
            }
        }
}

TEST_CASE("the smallest edit is made") {
    SheetDeck deck;
    deck.flipped = all_of(deck);
    FixOutcome outcome = repaired(deck);
    CHECK(title_of(outcome) == "reversed sign in the surface");
    CHECK(lines_changed(outcome) == 1);
    REQUIRE(outcome.interfaces.size() == 1);
    CHECK(outcome.interfaces[0].segments_turned == 80);
    CHECK(outcome.interfaces[0].before->messages == std::vector<int>{346, 499});
    CHECK(outcome.interfaces[0].after->messages.empty());
    CHECK(outcome.interfaces[0].before->fn == outcome.interfaces[0].after->fn);

    SheetDeck wrong_sign;
    wrong_sign.minus = {1};
    outcome = repaired(wrong_sign);
    CHECK(fixed_files(wrong_sign.files(), outcome) == SheetDeck().files());

    deck.flipped = patch(deck, 4, 3, 1);
    CHECK(title_of(repaired(deck)) == "signed groups in a surface of its own");

    SheetDeck lines;
    lines.surface = Form::seg;
    lines.flipped = patch(lines, 4, 3, 1);
    outcome = repaired(lines);
    CHECK(title_of(outcome) == "these segment lines turned (4321)");
    SheetDeck clean_lines;
    clean_lines.surface = Form::seg;
    CHECK(fixed_files(lines.files(), outcome) == clean_lines.files());

    SheetDeck set;
    set.surface = Form::set;
    set.minus = {1};
    CHECK(title_of(repaired(set)) == "clauses of the set reversed");
    CHECK(fixed_files(set.files(), repaired(set)).at("deck.rad").find("PART_O") == std::string::npos);
    set.minus.clear();
    set.flipped = all_of(set);
    CHECK(fixed_files(set.files(), repaired(set)).at("deck.rad").find("PART_O             1") !=
          std::string::npos);
    // Where commas cut the line, the ids have no columns to keep.
    Files free = set.files();
    std::string& text = free.at("deck.rad");
    const std::string clause = "PART               1";
    REQUIRE(text.find(clause) != std::string::npos);
    text.replace(text.find(clause), clause.size(), "PART,1");
    outcome = fix(free);
    CHECK(title_of(outcome) == "clauses of the set reversed");
    CHECK(side_findings(outcome.after).empty());
    CHECK(fixed_files(free, outcome).at("deck.rad").find("\nPART_O,1") != std::string::npos);

    SheetDeck groups;
    groups.surface = Form::grshel;
    groups.minus = {1};
    CHECK(title_of(repaired(groups)) == "reversed sign in the surface");

    SheetDeck parts;
    parts.surface = Form::parts_two;
    for (const auto& e : parts.elements())
        if (e.second_part) parts.flipped.insert(e.id);
    outcome = repaired(parts);
    CHECK(title_of(outcome) == "reversed sign in the surface");
    CHECK(lines_changed(outcome) == 1);
    parts.flipped.clear();
    parts.minus = {1};
    CHECK(lines_changed(repaired(parts)) == 1);
}

TEST_CASE("signs, lines and clauses turned twice are what they were") {
    for (const Form surface : {Form::part, Form::seg, Form::grshel, Form::surf_of_part, Form::surf_of_seg,
                               Form::set, Form::parts_two})
        for (const bool triangles : {false, true}) {
            CAPTURE(static_cast<int>(surface), triangles);
            SheetDeck above;
            above.surface = surface;
            above.triangles = triangles;
            if (triangles && surface == Form::surf_of_part) continue; // takes a surface of its own
            if (triangles && surface == Form::grshel) continue;
            SheetDeck below = above;
            below.beads[0].height = -3;
            // The bead goes to the other side and back again.
            const auto with_bead_of = [](const Files& files, const Files& other) {
                const auto bead_nodes = [](const std::string& text) {
                    const std::size_t begin = text.rfind("/NODE\n", text.find("/GRNOD/NODE/900"));
                    return std::pair(begin, text.find("/GRNOD/NODE/900") - begin);
                };
                Files out = files;
                std::string& text = out.at("deck.rad");
                const std::string& from = other.at("deck.rad");
                const auto [a, n] = bead_nodes(text);
                const auto [b, m] = bead_nodes(from);
                text.replace(a, n, from.substr(b, m));
                return out;
            };
            const Files turned = fixed_files(below.files(), fix(below.files()));
            CHECK(turned != below.files());
            const Files back = with_bead_of(turned, above.files());
            CHECK(fixed_files(back, fix(back)) == above.files());
        }
}

TEST_CASE("seventy percent reversed: the bead decides, not the majority") {
    SheetDeck deck;
    for (const auto& e : deck.elements())
        if (e.id % 10 < 7) deck.flipped.insert(e.id);
    repaired(deck);
}

TEST_CASE("two islands with one of them reversed") {
    SheetDeck deck;
    deck.island_from = 5;
    deck.beads = {{1, 12, 3}, {2, 38, 3}};
    for (const auto& e : deck.elements())
        if ((e.id - 1) % 10 >= 5) deck.flipped.insert(e.id);
    repaired(deck);
    // Each bead knows its own island alone; the other one stays as it is.
    deck.beads = {{1, 12, 3}};
    CHECK(side_findings(fix(deck.files()).before).empty());
}

TEST_CASE("two beads on one reversed surface are one edit") {
    SheetDeck deck;
    deck.beads = {{1, 12, 3}, {2, 32, 3}};
    deck.flipped = all_of(deck);
    const FixOutcome outcome = repaired(deck);
    CHECK(lines_changed(outcome) == 1);
    REQUIRE(outcome.applied.size() == 1);
    REQUIRE(outcome.interfaces.size() == 2);
    CHECK(outcome.interfaces[1].segments_turned == 80);
    deck.flipped = patch(deck, 2, 3, 2);
    CHECK(repaired(deck).applied.size() == 1);
}

TEST_CASE("beads on both sides: a second, reversed surface") {
    for (const Form surface : every_surface)
        for (const bool triangles : {false, true}) {
            SheetDeck deck;
            deck.surface = surface;
            deck.triangles = triangles;
            deck.beads = {{1, 12, 3}, {2, 32, -3}};
            CAPTURE(static_cast<int>(surface), triangles);
            const Files files = deck.files();
            const FixOutcome outcome = fix(files);
            CHECK(side_findings(outcome.before).count("SRF003") == 1);
            CHECK(side_findings(outcome.after).empty());
            CHECK(title_of(outcome) == "a second, reversed surface");
            const Files after = fixed_files(files, outcome);
            CHECK_FALSE(fix(after).changed());
            // The first bead sees what it saw; the second one the same from below.
            const auto before_scene = scene(files), after_scene = scene(after);
            CHECK(before_scene.at(1) == after_scene.at(1));
            for (std::size_t i = 0; i < 7; ++i)
                CHECK(after_scene.at(2)[i].d == Approx(-before_scene.at(2)[i].d).epsilon(1e-12));
        }
}

TEST_CASE("beads on both sides of a surface that is wrong in part") {
    SheetDeck deck;
    deck.beads = {{1, 12, 3}, {2, 32, -3}};
    deck.flipped = patch(deck, 3, 3, 2);
    const Files files = deck.files();
    const FixOutcome outcome = fix(files);
    CHECK(side_findings(outcome.after).empty());
    const Files after = fixed_files(files, outcome);
    CHECK_FALSE(fix(after).changed());
    deck.flipped.clear();
    CHECK(scene(after).at(1) == scene(deck.files()).at(1));
}

TEST_CASE("other users of the surface keep it as it is") {
    for (const Form surface : {Form::part, Form::seg, Form::grshel, Form::surf_of_seg}) {
        SheetDeck deck;
        deck.surface = surface;
        deck.more = "/INTER/TYPE7/77\nother contact\n       900         1\n";
        for (const bool whole : {true, false}) {
            deck.flipped = whole ? all_of(deck) : patch(deck, 4, 3, 1);
            CAPTURE(static_cast<int>(surface), whole);
            const FixOutcome outcome = repaired(deck);
            const std::string text = fixed_files(deck.files(), outcome).at("deck.rad");
            const std::string blocks = deck.surface_blocks(1);
            for (std::size_t at = 0; at < blocks.size();) {
                const std::size_t end = std::min(blocks.find("\n/", at), blocks.size() - 1) + 1;
                CHECK(text.find(blocks.substr(at, end - at)) != std::string::npos);
                at = end;
            }
            CHECK(text.find(deck.more) != std::string::npos);
        }
    }
}

TEST_CASE("in an include, in a submodel with offsets, with the line ends of Windows, in older versions") {
    for (const Form surface : every_surface)
        for (const bool triangles : {false, true})
            for (const bool whole : {true, false}) {
                SheetDeck deck;
                deck.surface = surface;
                deck.triangles = triangles;
                deck.flipped = whole ? all_of(deck) : patch(deck, 4, 3, 1);
                CAPTURE(static_cast<int>(surface), triangles, whole);
                SheetDeck other = deck;
                other.in_include = true;
                repaired(other);
                other = deck;
                other.in_submodel = true;
                repaired(other);
                other = deck;
                other.windows_lines = true;
                const FixOutcome outcome = repaired(other);
                for (const auto& [name, text] : fixed_files(other.files(), outcome))
                    for (std::size_t at = text.find('\n'); at != std::string::npos;
                         at = text.find('\n', at + 1))
                        REQUIRE(text[at - 1] == '\r');
                for (const int version : {110, 130, 2021}) {
                    other = deck;
                    other.version = version;
                    repaired(other);
                }
            }
}

TEST_CASE("a file that is included twice, with other offsets, is repaired for both") {
    for (const bool whole : {true, false})
        for (const Form surface : {Form::part, Form::seg, Form::grshel}) {
            CAPTURE(whole, static_cast<int>(surface));
            SheetDeck deck;
            deck.surface = surface;
            deck.in_submodel = true;
            deck.beads = {{1, 12, 3}, {2, 32, 3}};
            const auto twice = [](Files files) {
                std::string& text = files.at("deck.rad");
                const std::string end = "//ENDSUB\n";
                text.insert(text.find(end) + end.size(),
                            "/PART/1001\nagain\n         1         1         0\n"
                            "//SUBMODEL/10\nagain\n      1000    300000    400000\n#include sheet.inc\n"
                            "//ENDSUB\n");
                const std::string second = "       102         1  ";
                text.replace(text.find(second), second.size(), "       102      1001  ");
                return files;
            };
            const Files clean = twice(deck.files());
            deck.flipped = whole ? all_of(deck) : patch(deck, 4, 3, 3);
            const Files files = twice(deck.files());
            const FixOutcome outcome = fix(files);
            CHECK(side_findings(outcome.before).count("SRF001") == 1);
            CHECK(side_findings(outcome.after).empty());
            CHECK(outcome.declined.empty());
            const Files after = fixed_files(files, outcome);
            CHECK(scene(after) == scene(clean));
            CHECK_FALSE(fix(after).changed());
            if (surface == Form::seg) CHECK(after == clean);
        }
}

TEST_CASE("parameters are replaced in the cell") {
    SheetDeck deck;
    deck.flipped = all_of(deck);
    Files files = deck.files();
    std::string& text = files.at("deck.rad");
    const std::string list = "/SURF/PART/1\nmain\n";
    text.replace(text.find(list) + list.size(), 10, "    &BLANK");
    text.insert(text.find("/MAT"), "/PARAMETER/GLOBAL/INTEGER/1\nthe blank\nBLANK              1\n");
    const FixOutcome outcome = fix(files);
    const std::string after = fixed_files(files, outcome).at("deck.rad");
    CHECK(after.find(list + "        -1\n") != std::string::npos);
    CHECK(after.find("BLANK              1\n") != std::string::npos);
    CHECK(side_findings(outcome.after).empty());
}

TEST_CASE("no new ids are taken while an include is missing") {
    SheetDeck deck;
    deck.flipped = patch(deck, 4, 3, 1);
    deck.more = "#include lost.inc\n";
    const FixOutcome outcome = fix(deck.files());
    CHECK_FALSE(outcome.changed());
    REQUIRE(outcome.declined.size() == 2);
    CHECK(outcome.declined[0].why == "an include could not be read: no id is known to be free");
    deck.flipped = all_of(deck); // a sign needs none
    CHECK(side_findings(fix(deck.files()).after).empty());
}

TEST_CASE("elements are turned where that is asked for, and the text is the clean one again") {
    for (const bool triangles : {false, true}) {
        SheetDeck deck;
        deck.triangles = triangles;
        deck.keep_first = true;
        for (const bool whole : {true, false}) {
            deck.flipped = whole ? all_of(deck) : patch(deck, 4, 3, 2);
            const FixOutcome outcome = repaired(deck, {.unsafe = false, .normals = NormalsMode::elements});
            CHECK(title_of(outcome) == "nodes of elements in reverse order");
            SheetDeck clean = deck;
            clean.flipped.clear();
            CHECK(fixed_files(deck.files(), outcome) == clean.files());
        }
    }
}

TEST_CASE("a side that cannot be told is reported and left alone") {
    SheetDeck deck;
    deck.beads[0].height = 0;
    deck.wave = 0;
    deck.flipped = patch(deck, 1, 1, 0);
    const FixOutcome outcome = fix(deck.files());
    CHECK_FALSE(outcome.changed());
    REQUIRE(outcome.declined.size() == 1);
    CHECK(outcome.declined[0].code == "SRF002");
    CHECK(outcome.declined[0].why == "the side of its beads cannot be told");
}

TEST_CASE("an island that no bead is over is never guessed") {
    SheetDeck deck;
    deck.island_from = 5;
    deck.beads = {{1, 6, 3}};
    deck.flipped = patch(deck, 8, 3, 0); // alone on the other island
    const FixOutcome outcome = fix(deck.files());
    CHECK_FALSE(outcome.changed());
    REQUIRE(outcome.declined.size() == 1);
    CHECK(outcome.declined[0].why == "no bead tells the side of the segments that disagree");
}

TEST_CASE("any damage is repaired into the clean twin, once") {
    CHECK(rc::check([] {
        SheetDeck deck;
        deck.surface =
            *rc::gen::elementOf(std::vector<Form>(std::begin(every_surface), std::end(every_surface)));
        deck.triangles = *rc::gen::arbitrary<bool>();
        deck.in_include = *rc::gen::arbitrary<bool>();
        deck.windows_lines = *rc::gen::arbitrary<bool>();
        const bool two = *rc::gen::arbitrary<bool>();
        if (two) deck.beads = {{1, 12, 3}, {4, 33, 3}};
        const int share = *rc::gen::inRange(1, 100).as("percent flipped");
        for (const auto& e : deck.elements())
            if (*rc::gen::inRange(0, 100) < share) deck.flipped.insert(e.id);
        RC_PRE(!deck.flipped.empty());
        const Files files = deck.files();
        const FixOutcome outcome = fix(files);
        RC_ASSERT(side_findings(outcome.after).empty());
        Files after = files;
        for (const FixedFile& file : outcome.files)
            after[file.path] = std::string(file.text);
        SheetDeck clean = deck;
        clean.flipped.clear();
        RC_ASSERT(scene(after) == scene(clean.files()));
        RC_ASSERT(!fix(after).changed());
    }));
}
