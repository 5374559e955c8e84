#include "study/settings.h"

namespace drawbead {

namespace {

template <class Value, Value ManualSettings::*member>
void set(ManualSettings& settings, std::size_t word) {
    settings.*member = static_cast<Value>(word);
}

} // namespace

const std::array<Knob, knob_count>& knobs() {
    using S = ManualSettings;
    static constexpr std::array<Knob, knob_count> all{{
        {"kinks", {"stepped", "split"}, set<Kinks, &S::kinks>},
        {"tributary", {"chord", "arc"}, set<Tributary, &S::tributary>},
        {"projection", {"ratio", "exact"}, set<Projecting, &S::projection>},
        {"search", {"tracked", "exact"}, set<Searching, &S::search>},
        {"sum", {"plain", "compensated"}, set<Summing, &S::sum>},
        {"number", {"float", "double"}, set<Number, &S::number>},
    }};
    return all;
}

namespace {

std::string_view word(std::size_t knob, std::size_t value) {
    return knobs()[knob].words[value];
}

} // namespace

std::string_view name(Kinks v) {
    return word(0, static_cast<std::size_t>(v));
}
std::string_view name(Tributary v) {
    return word(1, static_cast<std::size_t>(v));
}
std::string_view name(Projecting v) {
    return word(2, static_cast<std::size_t>(v));
}
std::string_view name(Searching v) {
    return word(3, static_cast<std::size_t>(v));
}
std::string_view name(Summing v) {
    return word(4, static_cast<std::size_t>(v));
}
std::string_view name(Number v) {
    return word(5, static_cast<std::size_t>(v));
}

std::string text(const LineRule& line) {
    if (line.kind == LineRule::Kind::nodes) return "nodes";
    return line.kind == LineRule::Kind::adaptive ? "adaptive" : std::to_string(line.points);
}

std::string yaml(const ManualSettings& s) {
    std::string out = "{steps: " + std::to_string(s.steps) + ", line: " + text(s.line);
    const auto add = [&](std::size_t knob, auto value) {
        out += ", " + std::string(knobs()[knob].key) + ": " + std::string(name(value));
    };
    add(0, s.kinks);
    add(1, s.tributary);
    add(2, s.projection);
    add(3, s.search);
    add(4, s.sum);
    add(5, s.number);
    return out + "}";
}

std::string brief(const ManualSettings& s) {
    std::string out = std::to_string(s.steps) + (s.kinks == Kinks::split ? " steps, split" : " steps");
    if (s.line.kind == LineRule::Kind::nodes)
        out += s.tributary == Tributary::arc ? ", nodes, arc" : ", nodes, chord";
    else
        out += s.line.kind == LineRule::Kind::adaptive ? ", adaptive"
                                                       : ", " + std::to_string(s.line.points) + " per hop";
    if (s.projection == Projecting::ratio) out += ", ratio";
    if (s.search == Searching::tracked) out += ", tracked";
    if (s.sum == Summing::plain) out += ", plain sums";
    if (s.number == Number::single) out += ", float";
    return out;
}

} // namespace drawbead
