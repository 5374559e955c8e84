#include "base/parallel.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace drawbead {

void parallel_for(unsigned threads, std::size_t pieces, const std::function<void(std::size_t)>& work) {
    if (threads <= 1 || pieces <= 1) {
        for (std::size_t piece = 0; piece < pieces; ++piece)
            work(piece);
        return;
    }
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::mutex guard;
    auto run = [&] {
        try {
            for (std::size_t piece; (piece = next.fetch_add(1, std::memory_order_relaxed)) < pieces;)
                work(piece);
        } catch (...) {
            const std::lock_guard lock(guard);
            if (!failure) failure = std::current_exception();
            next.store(pieces);
        }
    };
    std::vector<std::jthread> helpers;
    const std::size_t extra = std::min<std::size_t>(threads, pieces) - 1;
    for (std::size_t i = 0; i < extra; ++i)
        helpers.emplace_back(run);
    run();
    helpers.clear();
    if (failure) std::rethrow_exception(failure);
}

unsigned available_threads() {
    const unsigned count = std::thread::hardware_concurrency();
    return count ? count : 1;
}

} // namespace drawbead
