#include "scene/class_motion.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace drawbead {

namespace {

using Condition = MotionCondition;

ClassMotion unknown(std::string why) {
    return {{}, std::move(why), ""};
}

/// With all digits: equal texts are equal numbers.
std::string key_of(const Condition& c, std::size_t axis) {
    char text[96];
    std::snprintf(text, sizeof text, "%c%c%u*%a/%a ", c.kind == Condition::Kind::velocity ? 'v' : 'd',
                  "xyz"[axis], c.function, c.scale, c.time_scale);
    return text;
}

/// Whether it says where the nodes go; else it changes only how they start, or pushes.
bool prescribes(const Condition& c) {
    return c.kind != Condition::Kind::initial_unread && c.kind != Condition::Kind::load;
}

} // namespace

std::string name_of(const Model& model, const MotionCondition& c) {
    const Block& block = model.deck().blocks()[c.block];
    return "/" + std::string(block.keyword) + "/" + std::to_string(c.id);
}

std::string ClassMotions::name(const Condition& c) const {
    return name_of(model_, c);
}

const ClassMotion& ClassMotions::of_class(uint32_t number) {
    if (!known_[number]) {
        known_[number] = Known{{}, "rigid bodies follow each other in a ring", ""};
        known_[number] = prescribed_.by_deck ? of_deck(number) : of_moves(number);
    }
    return *known_[number];
}

ClassMotion ClassMotions::of_moves(uint32_t number) const {
    Known out;
    out.motion.emplace();
    std::set<std::size_t> acting; // a motion of two targets that share a node moves it once
    for (const uint32_t c : motion_.classes[number])
        if (motion_.conditions[c].kind == Condition::Kind::asked)
            acting.insert(prescribed_.motion_of_target[motion_.conditions[c].function]);
    for (const std::size_t move : acting) {
        const Motion& part = prescribed_.motions[move];
        out.motion->terms.insert(out.motion->terms.end(), part.terms.begin(), part.terms.end());
        if (part.turn && out.motion->turn) return unknown("two rotations act on the same nodes");
        if (part.turn) out.motion->turn = part.turn;
        if (!part.at_rest()) out.key += "m" + std::to_string(move) + " ";
    }
    if (out.motion->at_rest()) out.motion = Motion{};
    return out;
}

ClassMotion ClassMotions::of_deck(uint32_t number) {
    std::vector<uint32_t> acting;
    for (const uint32_t c : motion_.classes[number]) {
        const Condition& condition = motion_.conditions[c];
        if (condition.kind == Condition::Kind::initial_unread)
            notes_.insert(name(condition) + ": " + condition.why);
        if (prescribes(condition)) acting.push_back(c);
    }
    if (acting.empty()) return unknown("nothing in the deck prescribes its motion");
    for (const uint32_t c : acting) {
        const Condition& condition = motion_.conditions[c];
        if (condition.kind == Condition::Kind::unknown)
            return unknown(name(condition) + ": " + condition.why);
        if (condition.kind == Condition::Kind::rigid_body) return of_rigid_body(condition);
    }
    Known out;
    out.motion.emplace();
    Motion& motion = *out.motion;
    std::array<const Condition*, 3> by{};
    for (const uint32_t c : acting) {
        const Condition& condition = motion_.conditions[c];
        if (condition.kind == Condition::Kind::initial_velocity) {
            motion.initial_velocity = condition.velocity;
            continue;
        }
        for (std::size_t k = 0; k < 3; ++k) {
            if (!condition.translation[k]) continue;
            const bool both_hold =
                by[k] && by[k]->kind == Condition::Kind::fixed && condition.kind == Condition::Kind::fixed;
            if (by[k] && !both_hold)
                return unknown(name(*by[k]) + " and " + name(condition) + " act in the same direction " +
                               "XYZ"[k]);
            by[k] = &condition;
            if (std::string why = take(condition, k, motion); !why.empty()) return unknown(std::move(why));
        }
    }
    for (std::size_t k = 0; k < 3; ++k)
        if (!by[k]) return unknown(std::string("it is free in ") + "XYZ"[k]);
    if (motion.at_rest()) motion.terms.clear();
    for (const uint32_t c : acting)
        if (motion_.conditions[c].kind == Condition::Kind::initial_velocity)
            out.key += "i" + std::to_string(c) + " ";
    for (std::size_t k = 0; k < 3 && !motion.terms.empty(); ++k)
        if (by[k]->kind != Condition::Kind::fixed) out.key += key_of(*by[k], k);
    return out;
}

std::string ClassMotions::take(const Condition& condition, std::size_t axis, Motion& motion) {
    if (condition.kind == Condition::Kind::fixed) return {};
    const MotionFunction& f = motion_.functions[condition.function];
    if (!f.unusable.empty()) return name(condition) + ": " + f.unusable;
    if (condition.sensor != 0 && strict_)
        return name(condition) + " waits for sensor " + std::to_string(condition.sensor);
    if (condition.sensor != 0)
        notes_.insert(name(condition) + ": sensor " + std::to_string(condition.sensor) +
                      " is ignored, the motion counts from the start");
    if (condition.t_start > 0 || condition.t_stop < end_)
        return name(condition) + " does not act over the whole run";
    motion.terms.push_back({condition.kind == Condition::Kind::velocity, axis, condition.scale,
                            condition.time_scale, TimeTable(f.x, f.y)});
    return {};
}

ClassMotion ClassMotions::of_rigid_body(const Condition& body) {
    if (body.main == no_node) return unknown(name(body) + " has no main node");
    const uint32_t main = motion_.of_node[index(body.main)];
    if (body.sensor != 0 && strict_)
        return unknown(name(body) + " waits for sensor " + std::to_string(body.sensor));
    if (body.sensor != 0)
        notes_.insert(name(body) + ": sensor " + std::to_string(body.sensor) +
                      " is ignored, the body counts as rigid from the start");
    std::array<bool, 3> held{};
    for (const uint32_t c : motion_.classes[main])
        if (motion_.conditions[c].kind == Condition::Kind::fixed)
            for (std::size_t k = 0; k < 3; ++k)
                held[k] = held[k] || motion_.conditions[c].rotation[k];
    const Known& known = of_class(main);
    if (!known.motion) return unknown(name(body) + ", main node: " + known.why);
    if (!(held[0] && held[1] && held[2]))
        return unknown(name(body) + " may turn: nothing holds the rotation of its main node");
    return known;
}

} // namespace drawbead
