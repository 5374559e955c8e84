#include "base/buffer.h"

#include <cstring>
#include <new>
#include <sys/mman.h>

namespace drawbead {

namespace {
constexpr std::size_t huge_page = std::size_t{2} << 20;
constexpr std::size_t whole_pages(std::size_t bytes) {
    return (bytes + huge_page - 1) / huge_page * huge_page;
}
} // namespace

void* allocate_pages(std::size_t bytes) {
    if (bytes == 0) return nullptr;
    if (bytes < huge_page) return ::operator new(bytes);
    void* memory =
        mmap(nullptr, whole_pages(bytes), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    madvise(memory, whole_pages(bytes), MADV_HUGEPAGE);
    return memory;
}

void* allocate_zeroed_pages(std::size_t bytes) {
    void* const memory = allocate_pages(bytes);
    if (bytes < huge_page && memory) std::memset(memory, 0, bytes); // the kernel's pages are zero
    return memory;
}

void free_pages(void* memory, std::size_t bytes) noexcept {
    if (!memory) return;
    if (bytes < huge_page) {
        ::operator delete(memory);
        return;
    }
    munmap(memory, whole_pages(bytes));
}

} // namespace drawbead
