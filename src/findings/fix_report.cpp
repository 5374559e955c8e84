#include "findings/fix_report.h"

#include <tuple>

namespace drawbead {

bool InterfaceOutcome::changed() const {
    if (segments_turned != 0 || nodes_moved != 0 || before.has_value() != after.has_value()) return true;
    if (!before) return false;
    return std::tie(before->nodes, before->fn, before->ft, before->slope, before->messages) !=
           std::tie(after->nodes, after->fn, after->ft, after->slope, after->messages);
}

} // namespace drawbead
