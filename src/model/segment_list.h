#pragma once
// Oriented main segments, and lists of them that need no memory of their own where shells can be looked at
// instead.
#include "base/buffer.h"
#include "model/ids.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <span>
#include <utility>

namespace drawbead {

/// What a segment comes from.
enum class ElementKind : uint8_t { none, shell4, shell3, solid };

/// One oriented main segment: a triangle repeats its third node.
struct Segment {
    std::array<NodeRow, 4> n{no_node, no_node, no_node, no_node};
    uint32_t element = 0;                 ///< row in its table
    ElementKind kind = ElementKind::none; ///< the element that gives stiffness and thickness
    int8_t sense = 1;                     ///< −1: reversed against the element, by a minus sign or _O
    bool solid_backed = false;            ///< turned outward by the Starter: its listed order does not count
    bool repaired = false; ///< two equal neighbours were listed and brought to n1 n2 n3 n3 (warning 106)
};
static_assert(sizeof(Segment) == 24 && offsetof(Segment, n) == 0);

/// Segments by index: stored one by one, or seen where they stand already, in consecutive rows of a table of
/// shells. A blank of millions of shells is of the second kind.
class SegmentList {
public:
    SegmentList() = default;
    explicit SegmentList(Buffer<Segment> stored)
        : stored_(std::move(stored)), first_(reinterpret_cast<const std::byte*>(stored_.data())),
          size_(stored_.size()), stride_(sizeof(Segment)) {}
    /// The rows of a table of shells of this kind from `first_row` on, none of them repaired or reversed. The
    /// nodes must stay where they are for as long as the list is in use.
    SegmentList(ElementKind kind, uint32_t first_row, std::span<const std::array<NodeRow, 4>> nodes)
        : first_(reinterpret_cast<const std::byte*>(nodes.data())), size_(nodes.size()),
          stride_(sizeof(nodes[0])), kind_(kind), first_row_(first_row) {}

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    Segment operator[](std::size_t i) const {
        if (is_stored()) return stored_[i];
        return {nodes(i), first_row_ + static_cast<uint32_t>(i), kind_};
    }
    std::array<NodeRow, 4> nodes(std::size_t i) const {
        std::array<NodeRow, 4> n;
        std::memcpy(&n, first_ + i * stride_, sizeof n);
        return n;
    }
    bool solid_backed(std::size_t i) const { return is_stored() && stored_[i].solid_backed; }

    bool is_stored() const { return !stored_.empty(); }
    std::span<Segment> stored() { return stored_.span(); } ///< empty when they are only seen
    /// Four node rows of a segment every `stride` bytes.
    const void* first_nodes() const { return first_; }
    std::size_t stride() const { return stride_; }

    class Iterator {
    public:
        using iterator_category = std::input_iterator_tag;
        using value_type = Segment;
        using difference_type = std::ptrdiff_t;
        using pointer = void;
        using reference = Segment;
        Iterator() = default;
        Iterator(const SegmentList& list, std::size_t at) : list_(&list), at_(at) {}
        Segment operator*() const { return (*list_)[at_]; }
        Iterator& operator++() {
            ++at_;
            return *this;
        }
        Iterator operator++(int) {
            Iterator before = *this;
            ++at_;
            return before;
        }
        friend bool operator==(const Iterator& a, const Iterator& b) { return a.at_ == b.at_; }

    private:
        const SegmentList* list_ = nullptr;
        std::size_t at_ = 0;
    };
    Iterator begin() const { return {*this, 0}; }
    Iterator end() const { return {*this, size_}; }

private:
    Buffer<Segment> stored_;
    const std::byte* first_ = nullptr;
    std::size_t size_ = 0, stride_ = 0;
    ElementKind kind_ = ElementKind::none;
    uint32_t first_row_ = 0;
};

} // namespace drawbead
