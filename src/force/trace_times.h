#pragma once
#include "force/trace.h"

#include <string>
#include <vector>

namespace drawbead {

/// The times of a recorded run from its first cycle on: index = cycle.
struct TraceTimes {
    std::vector<double> time, dt; ///< dt[n] from time[n−1] to time[n]; dt[0] = 0
    std::string note; ///< what had to be assumed of cycles that are not in the record; may be empty
};

/// A record that begins later, because no window was open before, gives its earlier cycles steps of equal
/// length.
TraceTimes times_of(const Trace&);

} // namespace drawbead
