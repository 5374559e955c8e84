// Compiled for AVX2 where the compiler knows it; called only where the processor does.
#include "force/solver_block_kernel.h"

namespace drawbead {

template <>
SolverBlockKernel<4> solver_block_kernel<4>(const Effects& effects) {
#ifdef __AVX2__
    return kernel_for<4>(effects);
#else
    static_cast<void>(effects);
    return nullptr;
#endif
}

} // namespace drawbead
