#include "scene/holding_force.h"

#include "scene/class_motion.h"

#include <algorithm>
#include <array>

namespace drawbead {

namespace {

using Condition = MotionCondition;

/// Why a load is not known as a force over time; empty when it is.
std::string doubt(const Model& model, const Condition& load) {
    const std::string name = name_of(model, load);
    if (!load.why.empty()) return name + ": " + load.why;
    if (load.sensor != 0) return name + " waits for sensor " + std::to_string(load.sensor);
    const MotionFunction& f = model.motion().functions[load.function];
    return f.unusable.empty() ? std::string() : name + ": " + f.unusable;
}

} // namespace

Vec3 HoldingForce::at(double t) const {
    constexpr std::array<double Vec3::*, 3> axes{&Vec3::x, &Vec3::y, &Vec3::z};
    Vec3 force;
    for (const Term& term : terms)
        force.*axes[term.axis] += term.scale * term.table.value(t / term.time_scale);
    return force;
}

std::vector<double> HoldingForce::times() const {
    std::vector<double> out;
    for (const Term& term : terms)
        for (const double t : term.table.times())
            out.push_back(t * term.time_scale);
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

std::optional<HoldingForce> holding_force(const Model& model, int64_t rigid_body) {
    const DeckMotion& motion = model.motion();
    const auto body =
        std::find_if(motion.conditions.begin(), motion.conditions.end(), [&](const Condition& c) {
            return c.kind == Condition::Kind::rigid_body && c.id == rigid_body && c.main != no_node;
        });
    if (body == motion.conditions.end()) return std::nullopt;
    HoldingForce out;
    for (const uint32_t number : motion.classes[motion.of_node[index(body->main)]]) {
        const Condition& load = motion.conditions[number];
        if (load.kind != Condition::Kind::load) continue;
        if (std::find(load.rotation.begin(), load.rotation.end(), true) != load.rotation.end()) continue;
        out.blocks.push_back(load.block);
        if (std::string why = doubt(model, load); !why.empty()) {
            out.unknown = std::move(why);
            continue;
        }
        const MotionFunction& f = motion.functions[load.function];
        for (std::size_t k = 0; k < 3; ++k)
            if (load.translation[k])
                out.terms.push_back({k, load.scale, load.time_scale, TimeTable(f.x, f.y)});
    }
    if (out.blocks.empty()) return std::nullopt;
    return out;
}

} // namespace drawbead
