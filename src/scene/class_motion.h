#pragma once
// What the deck, or somebody else, prescribes of the motion of classes of nodes.
#include "force/motion.h"
#include "model/model.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace drawbead {

/// Who moves the nodes.
struct PrescribedMotion {
    bool by_deck = true; ///< the deck's own options; else what follows
    /// Motions that are asked for, and which of them each target of Model::build follows. Several motions
    /// on one node add; what no target names stands still.
    std::vector<Motion> motions;
    std::vector<std::size_t> motion_of_target;
};

/// A motion, or why it is not known.
struct ClassMotion {
    std::optional<Motion> motion;
    std::string why;
    std::string key; ///< equal for equal motions
};

/// What the classes of nodes of a model do up to `end`. The model must be read with Needs::motion, and
/// outlive it, as must the prescription. `strict`: a motion that waits for a sensor is not known; else it
/// counts from the start.
class ClassMotions {
public:
    ClassMotions(const Model& model, const PrescribedMotion& prescribed, double end, bool strict = false)
        : model_(model), motion_(model.motion()), prescribed_(prescribed), end_(end), strict_(strict),
          known_(motion_.classes.size()) {}

    const ClassMotion& of(NodeRow node) { return of_class(motion_.of_node[index(node)]); }
    const ClassMotion& of_class(uint32_t number);

    /// What was assumed.
    std::vector<std::string> take_notes() { return {notes_.begin(), notes_.end()}; }

private:
    using Known = ClassMotion;
    using Condition = MotionCondition;

    std::string name(const Condition&) const;
    Known of_moves(uint32_t number) const;
    Known of_deck(uint32_t number);
    /// Adds one direction of a condition; gives why that is not possible.
    std::string take(const Condition&, std::size_t axis, Motion&);
    Known of_rigid_body(const Condition& body);

    const Model& model_;
    const DeckMotion& motion_;
    const PrescribedMotion& prescribed_;
    double end_;
    bool strict_;
    std::vector<std::optional<Known>> known_;
    std::set<std::string> notes_;
};

/// "/IMPVEL/3"
std::string name_of(const Model&, const MotionCondition&);

} // namespace drawbead
