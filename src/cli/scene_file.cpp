// The only file that includes yaml-cpp.
#include "cli/scene_file.h"

#include "base/nearest.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

namespace drawbead {

namespace {

/// Thrown only inside this file: yaml-cpp reports by exceptions too.
struct SceneError {
    Error error;
};

class SceneParser {
public:
    SceneParser(std::string_view text, const std::string& path) : text_(text), path_(path) {}

    Scene parse() {
        refuse_second_document();
        const YAML::Node root = YAML::Load(std::string(text_));
        if (!root.IsMap()) fail(root, "a scene is a map of keys", "it begins with: deck: NAME_0000.rad");
        only(root, {"deck", "interfaces", "law", "time", "accuracy", "output", "motion"});
        scene_.path = path_;
        scene_.deck = beside(text(need(root, "deck"), "deck"));
        if (const YAML::Node node = root["interfaces"]) {
            scene_.interfaces = ids(node, "interfaces");
            scene_.interfaces_place = place(node);
        }
        if (const YAML::Node node = root["law"]) law(node);
        time(need(root, "time"));
        if (const YAML::Node node = root["accuracy"]) accuracy(node);
        if (const YAML::Node node = root["output"]) output(node);
        if (const YAML::Node node = root["motion"]) motion(node);
        return std::move(scene_);
    }

private:
    /// yaml-cpp reads the first document and says nothing of others. A line that begins with --- is never
    /// anything but the start of one.
    void refuse_second_document() const {
        bool begun = false;
        uint64_t line = 1;
        for (std::size_t at = 0; at < text_.size(); ++line) {
            const std::size_t end = std::min(text_.find('\n', at), text_.size());
            const std::string_view one = text_.substr(at, end - at);
            const bool marker = one.substr(0, 3) == "---" &&
                                one.substr(3, 1).find_first_not_of(" \t\r") == std::string_view::npos;
            if (marker && begun)
                throw SceneError{Error{"a second document in the file", path_, line, 1,
                                       "leave one scene, without --- behind it"}};
            const std::size_t first = one.find_first_not_of(" \t\r");
            begun =
                begun || marker || (first != std::string_view::npos && one[first] != '#' && one[0] != '%');
            at = end + 1;
        }
    }

    static ScenePlace place(const YAML::Node& node) {
        const YAML::Mark mark = node.Mark();
        return {static_cast<uint64_t>(mark.line + 1), static_cast<uint32_t>(mark.column + 1)};
    }

    [[noreturn]] void fail(const YAML::Node& node, std::string message, std::string help = {}) const {
        const ScenePlace at = place(node);
        throw SceneError{{std::move(message), path_, at.line, at.column, std::move(help)}};
    }

    std::string beside(const std::string& path) const {
        const std::filesystem::path given(path);
        if (given.is_absolute()) return path;
        const std::filesystem::path folder = std::filesystem::path(path_).parent_path();
        return folder.empty() ? path : (folder / given).string();
    }

    void only(const YAML::Node& map, const std::vector<std::string>& keys) const {
        for (const auto& entry : map) {
            const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
            if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
            std::string help = did_you_mean(key, keys);
            if (help.empty()) {
                help = "known here:";
                for (const std::string& known : keys)
                    help += " " + known;
            }
            fail(entry.first, "unknown key '" + key + "'", help);
        }
        // yaml-cpp keeps the first of two equal keys and says nothing.
        for (auto a = map.begin(); a != map.end(); ++a)
            for (auto b = std::next(a); b != map.end(); ++b)
                if (a->first.Scalar() == b->first.Scalar())
                    fail(b->first, "key '" + b->first.Scalar() + "' stands twice");
    }

    YAML::Node need(const YAML::Node& map, const std::string& key) const {
        const YAML::Node node = map[key];
        if (!node) fail(map, "key '" + key + "' is missing");
        return node;
    }

    std::string text(const YAML::Node& node, const std::string& what) const {
        if (!node.IsScalar() || node.Scalar().empty()) fail(node, what + " needs a text");
        return node.Scalar();
    }

    double real(const YAML::Node& node, const std::string& what) const {
        double value = 0;
        const std::string& written = node.IsScalar() ? node.Scalar() : "";
        const char* begin = written.data() + (!written.empty() && written[0] == '+' ? 1 : 0);
        const char* end = written.data() + written.size();
        const auto [stop, error] = std::from_chars(begin, end, value);
        if (error != std::errc() || stop != end || written.empty() || !std::isfinite(value))
            fail(node, what + " needs a number" + (written.empty() ? "" : ", not '" + written + "'"));
        return value;
    }

    int64_t whole(const YAML::Node& node, const std::string& what) const {
        int64_t value = 0;
        const std::string& written = node.IsScalar() ? node.Scalar() : "";
        const char* end = written.data() + written.size();
        const auto [stop, error] = std::from_chars(written.data(), end, value);
        if (error != std::errc() || stop != end || written.empty())
            fail(node, what + " needs a whole number" + (written.empty() ? "" : ", not '" + written + "'"));
        return value;
    }

    std::vector<int64_t> ids(const YAML::Node& node, const std::string& what) const {
        std::vector<int64_t> out;
        if (node.IsScalar()) {
            if (node.Scalar() == "all") return out;
            out.push_back(whole(node, what));
            return out;
        }
        if (!node.IsSequence() || node.size() == 0) fail(node, what + " needs a list of ids, or all");
        for (const YAML::Node& one : node)
            out.push_back(whole(one, what));
        return out;
    }

    void law(const YAML::Node& node) {
        const std::string word = text(node, "law");
        if (word != "manual" && word != "solver" && word != "both") {
            const std::string help = did_you_mean(word, {"manual", "solver", "both"});
            fail(node, "law knows no '" + word + "'",
                 help.empty() ? "please give manual, solver or both" : help);
        }
        scene_.solver = word != "manual";
        scene_.manual = word != "solver";
    }

    void time(const YAML::Node& node) {
        if (!node.IsMap()) fail(node, "time needs {end, step}, {end, steps} or {trace}");
        only(node, {"end", "step", "steps", "trace"});
        scene_.time.place = place(node);
        if (const YAML::Node trace = node["trace"]) {
            if (node.size() > 1) fail(node, "time takes a trace or an end, not both");
            scene_.time.trace = beside(text(trace, "trace"));
            return;
        }
        const YAML::Node end = need(node, "end");
        scene_.time.end = real(end, "end");
        if (!(*scene_.time.end > 0)) fail(end, "end must be above 0");
        const YAML::Node step = node["step"], steps = node["steps"];
        if (static_cast<bool>(step) == static_cast<bool>(steps))
            fail(node, "time needs either step or steps beside end");
        constexpr double most = 1e8;
        if (step) {
            scene_.time.step = real(step, "step");
            if (!(*scene_.time.step > 0)) fail(step, "step must be above 0");
            if (*scene_.time.end / *scene_.time.step > most) fail(step, "more than 1e8 steps");
        } else {
            const int64_t count = whole(steps, "steps");
            if (count < 1 || static_cast<double>(count) > most) fail(steps, "steps must be 1 to 1e8");
            scene_.time.steps = static_cast<uint64_t>(count);
        }
    }

    void accuracy(const YAML::Node& node) {
        if (!node.IsMap()) fail(node, "accuracy needs a map", "'drawbead accuracy' prints one");
        std::vector<std::string> keys{"steps", "line"};
        for (const Knob& knob : knobs())
            keys.emplace_back(knob.key);
        only(node, keys);
        ManualSettings settings;
        const YAML::Node steps = need(node, "steps");
        const int64_t count = whole(steps, "steps");
        if (count < 1 || static_cast<double>(count) > 1e8) fail(steps, "steps must be 1 to 1e8");
        settings.steps = static_cast<uint64_t>(count);
        scene_.accuracy_steps = place(steps);
        if (const YAML::Node line = node["line"]) settings.line = line_rule(line);
        for (const Knob& knob : knobs()) {
            const YAML::Node value = node[std::string(knob.key)];
            if (!value) continue;
            const std::string word = text(value, std::string(knob.key));
            const std::vector<std::string> words(knob.words.begin(), knob.words.end());
            const auto at = std::find(words.begin(), words.end(), word);
            if (at == words.end()) {
                const std::string help = did_you_mean(word, words);
                fail(value, std::string(knob.key) + " knows no '" + word + "'",
                     help.empty() ? "please give " + words[0] + " or " + words[1] : help);
            }
            knob.set(settings, static_cast<std::size_t>(at - words.begin()));
        }
        scene_.accuracy = settings;
    }

    LineRule line_rule(const YAML::Node& node) const {
        LineRule line;
        const std::string word = text(node, "line");
        if (word == "nodes") return line;
        line.kind = LineRule::Kind::adaptive;
        if (word == "adaptive") return line;
        if (word.find_first_not_of("0123456789") != std::string::npos)
            fail(node, "line knows no '" + word + "'", "please give nodes, adaptive, or the points per hop");
        const int64_t points = whole(node, "line");
        if (points < 2 || points > most_line_points || points % 2 != 0)
            fail(node, "the points per hop are an even number from 2 to " + std::to_string(most_line_points));
        line.kind = LineRule::Kind::points;
        line.points = static_cast<uint32_t>(points);
        return line;
    }

    void output(const YAML::Node& node) {
        if (!node.IsMap()) fail(node, "output needs a map");
        only(node, {"every", "nodes", "csv", "vtu"});
        if (const YAML::Node every = node["every"]) {
            const int64_t count = whole(every, "every");
            if (count < 1) fail(every, "every must be at least 1");
            scene_.output.every = static_cast<uint64_t>(count);
        }
        if (const YAML::Node nodes = node["nodes"]) {
            scene_.output.nodes = ids(nodes, "nodes");
            scene_.output.nodes_place = place(nodes);
        }
        if (const YAML::Node csv = node["csv"]) scene_.output.csv = beside(text(csv, "csv"));
        if (const YAML::Node vtu = node["vtu"]) scene_.output.vtu = beside(text(vtu, "vtu"));
    }

    void motion(const YAML::Node& node) {
        if (node.IsScalar()) {
            if (node.Scalar() != "deck") fail(node, "motion needs deck, or a list of moves");
            return;
        }
        if (!node.IsSequence()) fail(node, "motion needs deck, or a list of moves");
        scene_.deck_motion = false;
        for (const YAML::Node& one : node)
            move(one);
    }

    void move(const YAML::Node& node) {
        if (!node.IsMap()) fail(node, "a move needs a map", "such as {move: {surface: 1}, velocity: {x: 1}}");
        only(node, {"move", "velocity", "displacement", "rotate"});
        Motion motion;
        const YAML::Node velocity = node["velocity"], displacement = node["displacement"],
                         turn = node["rotate"];
        if (velocity && displacement) fail(node, "a move takes velocity or displacement, not both");
        if (!velocity && !displacement && !turn) fail(node, "a move needs velocity, displacement or rotate");
        if (velocity) components(velocity, "velocity", true, motion);
        if (displacement) components(displacement, "displacement", false, motion);
        if (turn) rotate(turn, motion);
        const std::size_t index = scene_.motions.size();
        scene_.motions.push_back(std::move(motion));
        target(need(node, "move"), index);
    }

    void target(const YAML::Node& node, std::size_t motion) {
        static const std::vector<std::string> keys{"surface", "part", "node_group", "interface", "side"};
        if (!node.IsMap()) fail(node, "move needs one of surface, part, node_group or interface");
        only(node, keys);
        using Target = MotionTarget::Kind;
        const YAML::Node side = node["side"];
        std::size_t named = 0;
        for (const auto& [key, kind] :
             {std::pair{"surface", Target::surface}, std::pair{"part", Target::part},
              std::pair{"node_group", Target::node_group}, std::pair{"interface", Target::bead}}) {
            const YAML::Node value = node[key];
            if (!value) continue;
            ++named;
            Target what = kind;
            if (what == Target::bead) {
                if (!side) fail(node, "an interface needs a side: main or secondary");
                const std::string word = text(side, "side");
                if (word != "main" && word != "secondary") fail(side, "side is main or secondary");
                if (word == "main") what = Target::main_surface;
            } else if (side) {
                fail(side, "side belongs to an interface");
            }
            const std::vector<int64_t> all = ids(value, key);
            if (all.empty()) fail(value, std::string(key) + " needs an id");
            for (const int64_t id : all)
                scene_.moves.push_back({{what, id}, motion, place(value)});
        }
        if (named != 1) fail(node, "move needs exactly one of surface, part, node_group and interface");
    }

    /// A list of [t, value].
    TimeTable table(const YAML::Node& node, const std::string& what) {
        std::vector<double> t, y;
        for (const YAML::Node& point : node) {
            if (!point.IsSequence() || point.size() != 2) fail(point, what + " needs points [time, value]");
            t.push_back(real(point[0], "a time"));
            y.push_back(real(point[1], "a value"));
            if (t.size() > 1 && !(t[t.size() - 2] < t.back())) fail(point, "times must increase");
        }
        if (t.size() < 2) fail(node, what + " needs at least two points");
        scene_.tables.push_back({t.front(), t.back(), place(node)});
        return {std::move(t), std::move(y)};
    }

    void components(const YAML::Node& node, const std::string& what, bool velocity, Motion& motion) {
        if (!node.IsMap() || node.size() == 0) fail(node, what + " needs x, y or z");
        only(node, {"x", "y", "z"});
        static constexpr std::array<const char*, 3> names{"x", "y", "z"};
        for (std::size_t k = 0; k < 3; ++k) {
            const YAML::Node value = node[names[k]];
            if (!value) continue;
            const std::string component = what + " " + names[k];
            if (value.IsSequence()) {
                const TimeTable points = table(value, component);
                if (!velocity && points.value(0) != 0) fail(value, "a displacement starts at 0");
                motion.terms.push_back({velocity, k, 1, 1, points});
                continue;
            }
            const double constant = real(value, component);
            if (!velocity && constant != 0)
                fail(value, "a displacement starts at 0", "give a table [[0, 0], [time, value]]");
            motion.terms.push_back({velocity, k, 1, 1, TimeTable::constant(constant)});
        }
    }

    Vec3 vector(const YAML::Node& node, const std::string& what) const {
        if (!node.IsSequence() || node.size() != 3) fail(node, what + " needs three numbers");
        return {real(node[0], what), real(node[1], what), real(node[2], what)};
    }

    void rotate(const YAML::Node& node, Motion& motion) {
        if (!node.IsMap()) fail(node, "rotate needs about, axis and angle");
        only(node, {"about", "axis", "angle"});
        const Vec3 about = vector(need(node, "about"), "about");
        const YAML::Node axis_node = need(node, "axis"), angle = need(node, "angle");
        const Vec3 axis = vector(axis_node, "axis");
        if (!(norm(axis) > 0)) fail(axis_node, "axis has no length");
        if (!angle.IsSequence()) fail(angle, "angle needs a table of degrees", "such as [[0, 0], [1e-3, 5]]");
        const TimeTable degrees = table(angle, "angle");
        if (degrees.value(0) != 0) fail(angle, "an angle starts at 0");
        std::vector<double> radians;
        for (const double one : degrees.values())
            radians.push_back(one * std::numbers::pi / 180);
        motion.turn = Motion::Turn{about, axis / norm(axis), TimeTable(degrees.times(), radians)};
    }

    std::string_view text_;
    const std::string& path_;
    Scene scene_;
};

} // namespace

Result<Scene> parse_scene(std::string_view text, const std::string& path) {
    try {
        return SceneParser(text, path).parse();
    } catch (const SceneError& failure) {
        return failure.error;
    } catch (const YAML::Exception& failure) {
        const bool known = !failure.mark.is_null();
        // What the library says of brackets in brackets in brackets.
        const std::string message =
            failure.msg == YAML::ErrorMsg::BAD_FILE ? "nested too deeply" : failure.msg;
        return Error{message, path, known ? static_cast<uint64_t>(failure.mark.line + 1) : 0,
                     known ? static_cast<uint32_t>(failure.mark.column + 1) : 0, ""};
    }
}

Result<Scene> read_scene(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    std::error_code failure;
    if (!file || std::filesystem::is_directory(path, failure)) return Error{"cannot be read", path, 0, 0, ""};
    text << file.rdbuf(); // of an empty file this fails
    return parse_scene(text.str(), path);
}

PrescribedMotion prescribed_by(const Scene& scene) {
    PrescribedMotion out;
    out.by_deck = scene.deck_motion;
    out.motions = scene.motions;
    for (const SceneMove& move : scene.moves)
        out.motion_of_target.push_back(move.motion);
    return out;
}

std::vector<MotionTarget> targets_of(const Scene& scene) {
    std::vector<MotionTarget> out;
    for (const SceneMove& move : scene.moves)
        out.push_back(move.target);
    return out;
}

std::vector<double> equal_steps(double end, std::optional<double> step, std::optional<uint64_t> steps) {
    std::vector<double> t;
    if (steps) {
        const auto count = static_cast<double>(*steps);
        for (uint64_t n = 0; n < *steps; ++n)
            t.push_back(end * (static_cast<double>(n) / count));
    } else {
        // A remainder within rounding is no step of its own.
        for (uint64_t n = 0; static_cast<double>(n) * *step < end * (1 - 1e-9); ++n)
            t.push_back(static_cast<double>(n) * *step);
    }
    t.push_back(end);
    return t;
}

Result<void> check_tables(const Scene& scene, double end) {
    std::ostringstream text;
    text << end;
    for (const Scene::Table& table : scene.tables)
        if (table.first > 0 || table.last < end * (1 - 1e-12))
            return Error{"the table does not cover the run, 0 to " + text.str(), scene.path, table.place.line,
                         table.place.column, "give its first and last point there"};
    return {};
}

} // namespace drawbead
