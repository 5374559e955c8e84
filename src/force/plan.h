#pragma once
// Which effects a bead's evaluation needs, decided from the scene before the first step by bounds that err on
// the side of doing the work.
#include "force/evaluation.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace drawbead {

/// One stage of the step loop that can be left out. What is left out would have added 0 or multiplied by 1.
enum class Effect : uint8_t {
    window,          ///< test of Tstart and Tstop in each step
    search,          ///< contact: segment, projection, distance
    normal,          ///< normal force
    ramp,            ///< normal force below DEPTH
    thickness,       ///< half thickness added to DEPTH
    reset,           ///< slope of the ramp by segment instead of Fn/DEPTH
    ft_ramp,         ///< restraint scaled by δ/DEPTH
    variation,       ///< limits that change along the bead
    viscous,         ///< restraint of Iform 1
    incremental,     ///< restraint of Iform 2
    stick_reset,     ///< stored force forgotten at lift-off (the manual's law)
    moving,          ///< anything moves: each step is computed
    deforming_blank, ///< nodes of the blank move against each other
    moving_tool,     ///< bead nodes move
    edge,            ///< contact lost beside the blank
    energy,          ///< work and energies
    count
};
inline constexpr std::size_t effect_count = static_cast<std::size_t>(Effect::count);
std::string_view name(Effect);
std::string_view what(Effect); ///< one line for people

class EffectSet {
public:
    constexpr bool has(Effect e) const { return bits_ >> static_cast<unsigned>(e) & 1; }
    constexpr EffectSet& add(Effect e) { return bits_ |= 1u << static_cast<unsigned>(e), *this; }
    constexpr EffectSet& remove(Effect e) { return bits_ &= ~(1u << static_cast<unsigned>(e)), *this; }
    static constexpr EffectSet all() {
        EffectSet set;
        set.bits_ = (1u << effect_count) - 1;
        return set;
    }
    friend constexpr EffectSet operator|(EffectSet a, EffectSet b) {
        a.bits_ |= b.bits_;
        return a;
    }
    friend constexpr bool operator==(EffectSet, EffectSet) = default;

private:
    uint32_t bits_ = 0;
};

enum class Verdict : uint8_t { off, partly, on };
std::string_view name(Verdict);

struct EffectVerdict {
    Verdict verdict = Verdict::on;
    std::string reason;     ///< with numbers
    uint64_t estimated = 0; ///< how often the stage will do its work
};

struct BeadPlan {
    std::array<EffectVerdict, effect_count> effect;
    double d_low = 0, d_high = 0; ///< bounds of the distance over all nodes and times, where known
    bool bounded = false;

    const EffectVerdict& operator[](Effect e) const { return effect[static_cast<std::size_t>(e)]; }
    EffectVerdict& operator[](Effect e) { return effect[static_cast<std::size_t>(e)]; }
    EffectSet needed() const; ///< all that are not off
};

/// How the numbers of reasons are written.
struct PlanUnits {
    std::string length, time, force_per_length;
};

struct PlanOptions {
    bool node_output = false; ///< samples of nodes are asked for: their segments are to be known
    PlanUnits units;
};

/// `steps` as integrate() gives them for each motion of the scene.
BeadPlan plan(const EvaluationScene&, const std::vector<MotionSteps>& steps, std::size_t bead, Law,
              const PlanOptions&);

} // namespace drawbead
