// Rules about motion and the run: where they begin to speak, and that they keep quiet where motion is not
// known.
#include "literate.h"
#include "rules/check.h"
#include "sheet_deck.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <map>
#include <utility>

using namespace drawbead;

namespace {

using Points = std::vector<std::pair<double, double>>;

std::string cell(const std::string& text, std::size_t width) {
    return std::string(width - std::min(width, text.size()), ' ') + text;
}
std::string cells(const std::vector<std::string>& values) {
    std::string line;
    for (const std::string& one : values)
        line += cell(one, 10);
    return line + "\n";
}
std::string reals(const std::vector<double>& values) {
    std::string line;
    for (const double v : values) {
        char text[40];
        std::snprintf(text, sizeof text, "%.12g", v);
        line += cell(text, 20);
    }
    return line + "\n";
}

/// The frame of the pages with a tool that moves, and a blank that may be prescribed too.
struct MotionDeck {
    Points down;  ///< speed of the tool along z; empty: it is held
    Points side;  ///< along y, across the bead
    Points along; ///< along x, along the bead
    Points blank; ///< of the blank along y; empty: it is held when `held`
    bool held = false;
    int iform = 2;
    double fn = 80, ft = 100, depth = 2, t_start = 0, t_stop = 0;
    std::string more;

    static std::string function(int id, const Points& points) {
        std::string text = "/FUNCT/" + std::to_string(id) + "\nspeed\n";
        for (const auto& [t, v] : points)
            text += reals({t, v});
        return text;
    }
    static std::string moved(int id, char direction, int group, const Points& points) {
        return function(id, points) + "/IMPVEL/" + std::to_string(id) + "\nmotion\n" +
               cells({std::to_string(id), std::string(1, direction), "", "", std::to_string(group)}) +
               reals({1, 1, 0, 0});
    }
    static std::string fixed(int id, int group, const std::string& translations) {
        return "/BCS/" + std::to_string(id) + "\nheld\n   " + translations + " 111" +
               cells({"0", std::to_string(group)});
    }

    std::string text() const {
        std::string deck = literate::text_of_file(DRAWBEAD_TESTS_DIR "/rules/frames/bead.rad");
        deck.erase(deck.find("/BCS/1"));
        const auto open = [](const Points& points) { return points.empty() ? "1" : "0"; };
        deck += fixed(1, 3, std::string(open(along)) + open(side) + open(down));
        if (!down.empty()) deck += moved(1, 'Z', 3, down);
        if (!side.empty()) deck += moved(2, 'Y', 3, side);
        if (!along.empty()) deck += moved(3, 'X', 3, along);
        if (held || !blank.empty()) {
            deck += "/GRNOD/NODE/4\nblank\n" + cells({"1", "2", "3", "4", "5", "6", "7", "8"}) +
                    cells({"9", "10", "11", "12", "13", "14", "15"});
            deck += fixed(2, 4, blank.empty() ? "111" : "101");
            if (!blank.empty()) deck += moved(4, 'Y', 4, blank);
        }
        return deck + more + "/INTER/TYPE8/1\nbead\n" + cells({"2", "1", "", std::to_string(iform)}) +
               reals({fn, ft, depth, t_start, t_stop}) + reals({0, 0}) + "/END\n";
    }
};

/// A triangle of speed from `begin` on that goes `way` within 5 ms, then rest.
Points stroke(double way, double begin = 0) {
    Points points{{0, 0}, {begin + 0.0025, way / 0.0025}, {begin + 0.005, 0}, {1, 0}};
    if (begin > 0) points.insert(points.begin() + 1, {begin, 0});
    return points;
}
Points constant(double speed) {
    return {{0, speed}, {1, speed}};
}

DeckResult check(const std::string& text, const std::string& engine = {},
                 const std::optional<SceneMotion>& scene = {}) {
    MemoryReader reader;
    reader.add("deck_0000.rad", text);
    if (!engine.empty()) reader.add("deck_0001.rad", engine);
    CheckOptions options;
    options.scene = scene;
    return check_deck("deck_0000.rad", reader, {}, options);
}

const Finding* found(const DeckResult& result, const std::string& code) {
    const auto at = std::find_if(result.findings.begin(), result.findings.end(),
                                 [&](const Finding& f) { return f.code == code; });
    return at == result.findings.end() ? nullptr : &*at;
}

double measured(const Finding& f, const std::string& name) {
    for (const Measure& one : f.measured)
        if (one.name == name) return one.value;
    FAIL("no measure " << name);
    return 0;
}

std::string codes(const DeckResult& result) {
    std::string text = result.failure;
    for (const Finding& f : result.findings)
        text += (text.empty() ? "" : " ") + f.code;
    return text;
}

std::string run_until(double end) {
    return "#RADIOSS ENGINE\n/RUN/deck/1\n" + reals({end});
}

} // namespace

TEST_CASE("KIN001: a window needs a time of the run") {
    MotionDeck deck;
    deck.t_start = 0.01;
    CHECK(codes(check(deck.text())).empty());
    CHECK(codes(check(deck.text(), run_until(0.0101))).empty());
    CHECK(codes(check(deck.text(), run_until(0.01))) == "KIN001");
    deck.t_stop = 0.01;
    CHECK(codes(check(deck.text())) == "KIN001");
    deck.t_stop = 0.0101;
    CHECK(codes(check(deck.text())).empty());
    deck.t_stop = -1;
    CHECK(codes(check(deck.text())) == "KIN001");
    deck.t_start = 0;
    const DeckResult negative = check(deck.text());
    REQUIRE(found(negative, "KIN001"));
    CHECK(measured(*found(negative, "KIN001"), "restraint") == Approx(-3200));
}

TEST_CASE("KIN002: the share of the ramp that is skipped when the window opens") {
    MotionDeck deck;
    deck.held = true;
    deck.down = stroke(-3.5); // to d = 1.5, half of the ramp from d = 2.5 to 0.5
    deck.t_start = 0.01;
    const DeckResult half = check(deck.text());
    REQUIRE(codes(half) == "KIN002");
    CHECK(half.findings[0].severity == Severity::warning);
    CHECK(measured(half.findings[0], "normal force") == Approx(0.5 * 2560));
    CHECK(measured(half.findings[0], "restraint") == Approx(0.5 * 3200));
    deck.t_start = 1e-6; // before it closes
    CHECK(codes(check(deck.text())).empty());
    deck.down = stroke(-2.4); // d = 2.6: out of reach
    deck.t_start = 0.01;
    CHECK(codes(check(deck.text())) == "KIN004");

    SECTION("at the start of the run it is information, and for Fn alone") {
        MotionDeck closed;
        std::string text = closed.text();
        for (std::size_t at;
             (at = text.find("                 8.0                 5.0")) != std::string::npos;)
            text.replace(at, 40, "                 8.0                 1.5");
        const DeckResult start = check(text);
        REQUIRE(codes(start) == "KIN002");
        CHECK(start.findings[0].severity == Severity::info);
        CHECK(measured(start.findings[0], "normal force") == Approx(0.5 * 2560));
        CHECK(measured(start.findings[0], "restraint") == 0);
    }
}

TEST_CASE("KIN003 and ENG006: ways across the bead while it holds the sheet") {
    MotionDeck deck;
    deck.down = stroke(-5);
    deck.side = stroke(1.1, 0.006); // over half of DEPTH and a tenth of an element
    const DeckResult far = check(deck.text());
    REQUIRE(codes(far) == "ENG006 KIN003");
    CHECK(found(far, "KIN003")->severity == Severity::error);
    CHECK(measured(*found(far, "KIN003"), "sideways way") == Approx(1.1).epsilon(1e-6));
    CHECK(measured(*found(far, "KIN003"), "restraint") == Approx(3200));
    CHECK(found(far, "KIN003")->notes.size() == 1); // the blank is not prescribed
    deck.side = stroke(0.99, 0.006);
    CHECK(codes(check(deck.text())).empty());

    deck.side = stroke(1.1); // mostly before the sheet is reached, and before the window
    deck.t_start = 0.005;
    CHECK(codes(check(deck.text())) == "KIN002");
    deck.t_start = 0;
    deck.side.clear();
    deck.along = stroke(4, 0.006);
    CHECK(codes(check(deck.text())).empty());
    deck.along.clear();
    deck.side = stroke(4, 0.006);
    deck.ft = 0;
    CHECK(codes(check(deck.text())).empty());
}

TEST_CASE("KIN004: reach is DEPTH and half the thickness") {
    MotionDeck deck;
    deck.held = true;
    deck.down = stroke(-2.49);
    const DeckResult beyond = check(deck.text());
    REQUIRE(codes(beyond) == "KIN004");
    CHECK(measured(beyond.findings[0], "out of reach by") == Approx(0.01).epsilon(1e-6));
    CHECK(measured(beyond.findings[0], "normal force") == Approx(-2560));
    deck.down = stroke(-2.51);
    CHECK(codes(check(deck.text())).empty());
    deck.down.clear();
    CHECK(codes(check(deck.text())) == "KIN004"); // nothing moves
    deck.held = false;
    CHECK(codes(check(deck.text())).empty()); // a blank that may come
    deck.held = true;
    deck.down = constant(-1); // closes only after the run
    CHECK(codes(check(deck.text())).empty());
    CHECK(codes(check(deck.text(), run_until(0.01))) == "KIN004");
}

TEST_CASE("KIN005: the rim passes bead nodes") {
    MotionDeck deck;
    deck.down = stroke(-5);
    deck.blank = stroke(-12.4, 0.006); // the rim at y = 20 is 5 % of a segment away at 12.5
    CHECK(codes(check(deck.text())).empty());
    deck.blank = stroke(-12.7, 0.006);
    const DeckResult left = check(deck.text());
    REQUIRE(codes(left) == "KIN005");
    CHECK(left.findings[0].severity == Severity::info);
    CHECK(measured(left.findings[0], "length lost") == Approx(32));
    CHECK(measured(left.findings[0], "normal force") == Approx(-2560));
    deck.t_stop = 0.006; // the window is closed by then
    CHECK(codes(check(deck.text())).empty());
}

TEST_CASE("KIN006: lift-off and return of the incremental form") {
    const auto twice = [](double up, double down) {
        Points points = stroke(-5);
        points.pop_back();
        for (const auto& [way, begin] : {std::pair(up, 0.01), std::pair(down, 0.02)}) {
            points.emplace_back(begin, 0);
            points.emplace_back(begin + 0.0025, way / 0.0025);
            points.emplace_back(begin + 0.005, 0);
        }
        points.emplace_back(1, 0);
        return points;
    };
    MotionDeck deck;
    deck.down = twice(4, -4);
    const DeckResult lifted = check(deck.text());
    REQUIRE(codes(lifted) == "KIN006");
    CHECK(measured(lifted.findings[0], "lift") == Approx(1.5).epsilon(1e-6)); // beyond DEPTH and t/2
    CHECK(measured(lifted.findings[0], "restraint") == Approx(3200));
    deck.down = twice(2.4, -2.4); // stays on the ramp
    CHECK(codes(check(deck.text())).empty());
    deck.down = twice(4, -1); // does not come back
    CHECK(codes(check(deck.text())).empty());
    deck.down = twice(4, -4);
    deck.t_stop = 0.015;
    CHECK(codes(check(deck.text())).empty());
    CHECK_FALSE(found(check(deck.text()), "KIN006"));
    deck.t_stop = 0;
    CHECK_FALSE(found(check(deck.text(), run_until(0.02)), "KIN006"));
    deck.iform = 1;
    CHECK_FALSE(found(check(deck.text()), "KIN006"));
}

TEST_CASE("KIN007: a way of one element before the window opens") {
    MotionDeck deck;
    deck.down = stroke(-5, 0.02);
    deck.blank = stroke(-10.1);
    deck.t_start = 0.01;
    const DeckResult late = check(deck.text());
    REQUIRE(codes(late) == "KIN007");
    CHECK(measured(late.findings[0], "travel") == Approx(10.1));
    deck.blank = stroke(-9.9);
    CHECK(codes(check(deck.text())).empty());
    // Where the blank goes on moving the run may end at any time, but not before the window opens.
    deck.blank = constant(-1010);
    deck.down.clear();
    CHECK(codes(check(deck.text())) == "KIN007");
    deck.t_start = 0;
    CHECK(codes(check(deck.text())).empty());
}

TEST_CASE("rules about motion keep quiet where it is not known") {
    MotionDeck deck;
    deck.down = stroke(-5);
    deck.side = stroke(4, 0.006);
    REQUIRE(codes(check(deck.text())) == "ENG006 KIN003");
    SECTION("a sensor starts it") {
        std::string text = deck.text();
        const std::size_t at = text.find("/IMPVEL/2");
        const std::size_t sensor = text.find('\n', text.find('\n', at) + 1) + 31;
        text.replace(sensor, 10, cell("7", 10));
        CHECK(codes(check(text)).empty());
    }
    SECTION("its function does not exist") {
        std::string text = deck.text();
        text.replace(text.find("/FUNCT/2"), 8, "/FUNCT/9");
        CHECK(codes(check(text)).empty());
    }
    SECTION("it never ends, and no engine deck tells the end") {
        deck.side = constant(800);
        CHECK(codes(check(deck.text())).empty());
        CHECK(codes(check(deck.text(), run_until(0.01))) == "ENG006 KIN003");
        CHECK(codes(check(deck.text(), "#RADIOSS ENGINE\n/TFILE\n 1.E-4\n")).empty());
    }
    SECTION("two motions of one direction") {
        deck.more = MotionDeck::moved(8, 'Y', 3, constant(1));
        CHECK_FALSE(found(check(deck.text()), "KIN003"));
    }
}

TEST_CASE("a scene says how things move instead of the deck") {
    MotionDeck deck;
    deck.held = true;
    REQUIRE(codes(check(deck.text())) == "KIN004");
    SceneMotion scene;
    scene.prescribed.by_deck = false;
    Motion motion;
    motion.terms.push_back({false, 2, 1, 1, TimeTable({0, 0.005, 0.01}, {0, -5, -5})});
    motion.terms.push_back({false, 1, 1, 1, TimeTable({0, 0.005, 0.01}, {0, 0, 4})});
    scene.prescribed.motions = {motion};
    scene.prescribed.motion_of_target = {0};
    scene.targets = {{MotionTarget::Kind::bead, 1}};
    scene.places = {{3, 5}};
    scene.path = "scene.yaml";
    scene.end = 0.01;
    const DeckResult result = check(deck.text(), run_until(0.001), scene); // the scene's end counts
    REQUIRE(codes(result) == "ENG006 KIN003");
    CHECK(measured(*found(result, "KIN003"), "sideways way") == Approx(4).epsilon(1e-6));
    scene.targets[0].id = 8;
    const DeckResult failed = check(deck.text(), {}, scene);
    CHECK(failed.failure == "8 does not exist in the deck");
    CHECK(failed.failure_place.file == "scene.yaml");
    CHECK(failed.failure_place.line == 3);

    SECTION("the deck's own motion over the scene's time") {
        MotionDeck own;
        own.down = constant(-1);
        own.held = true;
        SceneMotion time;
        time.end = 1;
        CHECK(codes(check(own.text(), {}, time)) == "KIN004");
        time.end = 3;
        CHECK(codes(check(own.text(), {}, time)).empty());
    }
}

TEST_CASE("CTX002: two rigid bodies, of one node or of one bead") {
    const auto body = [](int id, int main, int group) {
        return "/RBODY/" + std::to_string(id) + "\ntool\n" +
               cells({std::to_string(main), "0", "0", "0"}).substr(0, 40) + cell("0.0", 20) +
               cells({std::to_string(group), "0", "0"}).substr(0, 30) + cell("0.0", 20) + "\n" +
               reals({0, 0, 0}) + reals({0, 0, 0, 0}) + reals({0, 0});
    };
    const std::string mains =
        "/NODE\n" + cell("201", 10) + reals({0, 0, 20}) + cell("202", 10) + reals({0, 0, 30});
    MotionDeck deck;
    std::string text = deck.text();
    text.erase(text.find("/BCS/1"), text.find("/INTER") - text.find("/BCS/1"));
    const auto with = [&](const std::string& more) {
        std::string out = text;
        return out.insert(out.find("/INTER"), mains + more);
    };
    CHECK(codes(check(with(body(1, 201, 3)))).empty());
    CHECK(codes(check(with(body(1, 201, 3) + body(2, 202, 3)))) == "CTX002");
    const std::string halves =
        "/GRNOD/NODE/6\na\n" + cells({"101", "102"}) + "/GRNOD/NODE/7\nb\n" + cells({"103", "104", "105"});
    const DeckResult apart = check(with(halves + body(1, 201, 6) + body(2, 202, 7)));
    REQUIRE(codes(apart) == "CTX002");
    CHECK(apart.findings[0].entities.nodes.ids == std::vector<int64_t>{101, 102});
    CHECK(measured(apart.findings[0], "normal force") == Approx(80 * (4 + 8)));
}

TEST_CASE("CTX003: mass scaling in the engine deck, or AMS") {
    MotionDeck deck;
    const auto with = [&](const std::string& option) {
        return codes(check(deck.text(), run_until(1) + option));
    };
    CHECK(with("/DT/NODA/CST\n 0.67 1.E-7\n") == "CTX003");
    CHECK(with("/DT/AMS/0\n 0.67 1.E-7\n") == "CTX003");
    CHECK(with("/DT/NODA/STOP\n 0.67 1.E-7\n").empty());
    CHECK(with("#/DT/NODA/CST\n").empty());
    deck.more = "/AMS\n";
    CHECK(codes(check(deck.text())) == "CTX003");
    deck.ft = 0;
    CHECK(codes(check(deck.text())).empty());
}

TEST_CASE("CTX004: coordinates against DEPTH") {
    MotionDeck deck;
    // 3/2 eps · 36 mm = 6.4e-6 mm
    deck.depth = 7e-4;
    CHECK_FALSE(found(check(deck.text()), "CTX004"));
    deck.depth = 6e-4;
    const DeckResult result = check(deck.text());
    REQUIRE(found(result, "CTX004"));
    CHECK(measured(*found(result, "CTX004"), "error of the distance") ==
          Approx(1.5 * std::numeric_limits<float>::epsilon() * 36));
}

TEST_CASE("CTX005: what the beads take of the holding force") {
    MotionDeck deck;
    std::string text = deck.text();
    text.erase(text.find("/BCS/1"), text.find("/INTER") - text.find("/BCS/1"));
    const auto with = [&](double force, const std::string& direction, const std::string& skew = "0") {
        std::string more = "/NODE\n" + cell("201", 10) + reals({0, 0, 20}) + "/RBODY/1\ntool\n" +
                           cells({"201", "0", "0", "0"}).substr(0, 40) + cell("0.0", 20) +
                           cells({"3", "0", "0"}).substr(0, 30) + cell("0.0", 20) + "\n" + reals({0, 0, 0}) +
                           reals({0, 0, 0, 0}) + reals({0, 0}) + "/GRNOD/NODE/6\nmain\n" + cells({"201"}) +
                           MotionDeck::function(1, {{0, 0}, {0.01, 1}, {1, 0.5}}) + "/CLOAD/1\npress\n" +
                           cells({"1", direction, skew, "0", "6", "0"}).substr(0, 60) + reals({1, force});
        std::string out = text;
        return check(out.insert(out.find("/INTER"), more));
    };
    const DeckResult lifts = with(-2559, "Z");
    REQUIRE(codes(lifts) == "CTX005");
    CHECK(lifts.findings[0].severity == Severity::warning);
    CHECK(measured(lifts.findings[0], "share of the holding force") == Approx(100 * 2560 / 2559.0));
    const DeckResult holds = with(-2561, "Z");
    REQUIRE(codes(holds) == "CTX005");
    CHECK(holds.findings[0].severity == Severity::info);
    CHECK(codes(with(-5121, "Z")).empty());
    CHECK(codes(with(2000, "Z")).empty());  // opens the tool
    CHECK(codes(with(-2000, "X")).empty()); // and pushes it sideways
    CHECK(codes(with(-2000, "Z", "5")).empty());
}

TEST_CASE("CTX007: an end of the bead on a plane of symmetry") {
    MotionDeck deck;
    std::string text = deck.text();
    const auto with = [&](double first, const std::string& bcs) {
        std::string out = text;
        const std::size_t row = out.find("       101                 4.0");
        out.replace(row, 30, cell("101", 10) + reals({first}).substr(0, 20));
        return codes(
            check(out.insert(out.find("/INTER"), "/GRNOD/NODE/6\nplane\n" + cells({"1", "6", "11"}) +
                                                     "/BCS/6\nsymmetry\n   " + bcs + cells({"0", "6"}))));
    };
    CHECK(with(0, "100 011").find("CTX007") != std::string::npos);
    CHECK(with(0.5, "100 011").find("CTX007") != std::string::npos); // 0.6 is a twentieth of the step
    CHECK(with(1, "100 011").find("CTX007") == std::string::npos);
    CHECK(with(0, "100 111").find("CTX007") == std::string::npos);
    CHECK(with(0, "111 111").find("CTX007") == std::string::npos);
    CHECK(with(0, "010 101").find("CTX007") == std::string::npos); // no plane
}

TEST_CASE("STB004: the step of an element with the stiffness of the ramp") {
    MotionDeck deck;
    deck.ft = 0;
    // Node 8 carries h = 0.8 of node 103 and 0.16 of each of its neighbours: K = slope · 8 mm · 1.12; K_e =
    // 4 E t / (1 − ν²) / ... of one element of 10 mm and the mass of four quarters.
    const double element = 4 * 210000 / (1 - 0.3 * 0.3);
    const auto ratio = [&](double depth) { return 1 / std::sqrt(1 + 80 / depth * 8 * 1.12 / element); };
    // Below the reset at DEPTH = 80 / 42000 the slope stays 42000.
    deck.depth = 80.0 / 42000 * 1.0001;
    const DeckResult result = check(deck.text());
    REQUIRE(found(result, "STB004"));
    CHECK(measured(*found(result, "STB004"), "share of the step") == Approx(100 * ratio(deck.depth)));
    CHECK(found(result, "STB004")->entities.nodes.ids == std::vector<int64_t>{8});
    double depth = deck.depth;
    while (ratio(depth) < 0.9)
        depth *= 1.001;
    deck.depth = depth;
    CHECK_FALSE(found(check(deck.text()), "STB004"));
    deck.depth = depth / 1.002;
    CHECK(found(check(deck.text()), "STB004"));
}

TEST_CASE("SRF001 judges as far as the blank will travel") {
    SheetDeck deck;
    deck.flipped = {50}; // five elements beside the line
    const auto says = [&](double way) {
        deck.more = "/GRNOD/PART/901\nblank\n" + cells({"1"});
        deck.more += MotionDeck::fixed(5, 901, way == 0 ? "111" : "011");
        if (way != 0) deck.more += MotionDeck::moved(6, 'X', 901, stroke(way));
        MemoryReader reader = reader_of(deck.files());
        return found(check_deck("deck.rad", reader, {}, {}), "SRF001") != nullptr;
    };
    CHECK_FALSE(says(0));
    CHECK_FALSE(says(-10));
    CHECK(says(-22));
    deck.flipped = {};
    CHECK_FALSE(says(-22));
}

TEST_CASE("rules about motion on the decks of the solver runs") {
    const auto of = [](const std::string& name, const std::string& code) {
        DiskReader reader;
        const DeckResult result =
            check_deck(DRAWBEAD_TESTS_DIR "/truth/" + name + "/" + name + "_0000.rad", reader, {}, {});
        const Finding* f = found(result, code);
        return f ? std::optional(*f) : std::nullopt;
    };
    // The bead stood over the blank without force for 10 cycles, as recorded.
    CHECK(of("win_late", "KIN007"));
    CHECK_FALSE(of("j_window", "KIN004"));
    for (const auto& entry : std::filesystem::directory_iterator(DRAWBEAD_TESTS_DIR "/truth")) {
        if (!entry.is_directory()) continue;
        const std::string name = entry.path().filename().string();
        INFO(name);
        CHECK_FALSE(of(name, "KIN001"));
        CHECK_FALSE(of(name, "KIN003"));
        CHECK_FALSE(of(name, "KIN004"));
        CHECK_FALSE(of(name, "ENG006"));
    }
}
