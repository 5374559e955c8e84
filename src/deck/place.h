#pragma once
// Where something stands in the text of a deck.
#include <cstdint>

namespace drawbead {

enum class FileId : uint32_t {};
enum class ScopeId : uint32_t {};
constexpr uint32_t index(FileId id) {
    return static_cast<uint32_t>(id);
}
constexpr uint32_t index(ScopeId id) {
    return static_cast<uint32_t>(id);
}

/// Half-open byte range [begin, end) of one file.
struct Span {
    FileId file{};
    uint64_t begin = 0, end = 0;

    uint64_t size() const { return end - begin; }
    friend bool operator==(const Span&, const Span&) = default;
};

} // namespace drawbead
