// SPDX-License-Identifier: MIT
// An array that does not grow, aligned for vectors and, when large, backed by huge pages where the system has them.
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>

namespace tress {

/// Zero-filled memory of at least `bytes`, aligned to 64; free with free_aligned. Throws std::bad_alloc.
void* allocate_aligned(size_t bytes);
void free_aligned(void* memory);

template <class T>
class AlignedArray {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    AlignedArray() = default;
    explicit AlignedArray(size_t size)
        : data_(size ? static_cast<T*>(allocate_aligned(size * sizeof(T))) : nullptr), size_(size) {}

    T* data() { return data_.get(); }
    const T* data() const { return data_.get(); }
    size_t size() const { return size_; }
    T& operator[](size_t i) { return data_.get()[i]; }
    const T& operator[](size_t i) const { return data_.get()[i]; }

private:
    struct Free {
        void operator()(T* memory) const { free_aligned(memory); }
    };
    std::unique_ptr<T, Free> data_;
    size_t size_ = 0;
};

}  // namespace tress
