#pragma once
// Threads for work that is split into numbered pieces. Results are stored by piece, so they never depend on
// the count of threads.
#include <cstddef>
#include <functional>

namespace drawbead {

/// Runs work(piece) for every piece in [0, pieces) on at most `threads` threads, the calling one included,
/// and returns when all are done. Pieces are taken in ascending order. `work` must not throw except
/// std::bad_alloc, which is rethrown here.
void parallel_for(unsigned threads, std::size_t pieces, const std::function<void(std::size_t piece)>& work);

/// Number of threads meant by `-j0`: the cores this process may use.
unsigned available_threads();

} // namespace drawbead
