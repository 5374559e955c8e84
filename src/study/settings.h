#pragma once
// How finely the manual's law is evaluated: one knob per source of error.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace drawbead {

/// How the line of a bead becomes points that carry force.
struct LineRule {
    enum class Kind : uint8_t {
        nodes,    ///< its nodes, as the law is written
        points,   ///< midpoints of `points` equal parts of each hop between nodes
        adaptive, ///< parts of half a hop, halved where the contact changes along them
    };
    Kind kind = Kind::nodes;
    uint32_t points = 2; ///< even, so that no part belongs to two nodes

    friend bool operator==(const LineRule&, const LineRule&) = default;
};
inline constexpr uint32_t most_line_points = 64;

enum class Kinks : uint8_t { stepped, split };     ///< steps run on over bends of the motion, or end there
enum class Tributary : uint8_t { chord, arc };     ///< |½(x_{i+1} − x_{i−1})|, or half the adjacent hops
enum class Projecting : uint8_t { ratio, exact };  ///< the solver's area ratios, or the closest point
enum class Searching : uint8_t { tracked, exact }; ///< one ring per step, or the whole surface
enum class Summing : uint8_t { plain, compensated };
enum class Number : uint8_t { single, twice }; ///< "float", "double"

/// The manual's law by plain stepping: the slider's return map at the end of each of `steps` equal steps over
/// the run. Nothing is located in between.
struct ManualSettings {
    uint64_t steps = 1024;
    Kinks kinks = Kinks::stepped;
    LineRule line;
    Tributary tributary = Tributary::chord; ///< of nodes; parts of a hop have their own length
    Projecting projection = Projecting::exact;
    Searching search = Searching::exact;
    Summing sum = Summing::compensated;
    Number number = Number::twice;

    friend bool operator==(const ManualSettings&, const ManualSettings&) = default;
};

std::string text(const LineRule&); ///< "nodes", "adaptive", or the number of points
std::string_view name(Kinks);
std::string_view name(Tributary);
std::string_view name(Projecting);
std::string_view name(Searching);
std::string_view name(Summing);
std::string_view name(Number);

/// One knob by name: what words it knows, and setting it by one of them. `steps` and the points of `line` are
/// numbers and not among the words.
struct Knob {
    std::string_view key;
    std::array<std::string_view, 2> words;
    void (*set)(ManualSettings&, std::size_t word);
};
inline constexpr std::size_t knob_count = 6;
const std::array<Knob, knob_count>& knobs(); ///< all but steps and line

/// "{steps: 256, line: nodes, …}": a YAML value with every key.
std::string yaml(const ManualSettings&);
/// Short, for a table: "256 steps, nodes, chord" and what differs from exact, compensated and double.
std::string brief(const ManualSettings&);

} // namespace drawbead
