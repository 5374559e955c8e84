#include "force/solver_block_kernel.h"

namespace drawbead {

template <>
SolverBlockKernel<2> solver_block_kernel<2>(const Effects& effects) {
    return kernel_for<2>(effects);
}

bool runs_four_lanes() {
#ifdef DRAWBEAD_FOUR_LANES
    static const bool runs = __builtin_cpu_supports("avx2");
    return runs;
#else
    return false;
#endif
}

} // namespace drawbead
