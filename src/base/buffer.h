#pragma once
// An array that is not zeroed before it is filled: tables of millions of rows are written once, by several
// threads.
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>

namespace drawbead {

/// Anonymous pages, huge ones where the kernel allows; nullptr for 0 bytes. Throws std::bad_alloc.
void* allocate_pages(std::size_t bytes);
void* allocate_zeroed_pages(std::size_t bytes);
void free_pages(void* memory, std::size_t bytes) noexcept;

/// Fixed-capacity array of trivially copyable T, uninitialised; `resize` only changes the count within the
/// capacity.
template <class T>
class Buffer {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    Buffer() = default;
    /// All bytes 0; of a large one only what is touched costs time and memory.
    static Buffer zeroed(std::size_t capacity) {
        Buffer out;
        out.data_ = static_cast<T*>(allocate_zeroed_pages(capacity * sizeof(T)));
        out.size_ = out.capacity_ = capacity;
        return out;
    }
    explicit Buffer(std::size_t capacity)
        : data_(static_cast<T*>(allocate_pages(capacity * sizeof(T)))), size_(capacity), capacity_(capacity) {
    }
    Buffer(Buffer&& other) noexcept
        : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)),
          capacity_(std::exchange(other.capacity_, 0)) {}
    Buffer& operator=(Buffer&& other) noexcept {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
        return *this;
    }
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;
    ~Buffer() { free_pages(data_, capacity_ * sizeof(T)); }

    T* data() { return data_; }
    const T* data() const { return data_; }
    std::size_t size() const { return size_; }
    std::size_t capacity() const { return capacity_; }
    bool empty() const { return size_ == 0; }
    void resize(std::size_t size) { size_ = size < capacity_ ? size : capacity_; }
    T& operator[](std::size_t i) { return data_[i]; }
    const T& operator[](std::size_t i) const { return data_[i]; }
    T* begin() { return data_; }
    T* end() { return data_ + size_; }
    const T* begin() const { return data_; }
    const T* end() const { return data_ + size_; }
    std::span<T> span() { return {data_, size_}; }
    std::span<const T> span() const { return {data_, size_}; }

private:
    T* data_ = nullptr;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
};

} // namespace drawbead
