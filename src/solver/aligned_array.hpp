#pragma once
// Arrays of the kernels: doubles that start on a vector boundary, zero at first, and where a field of one lane lies in
// them.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <span>

#include "core/state_archive.hpp"

namespace floes {

template <class Value>
class AlignedArray {
  public:
    explicit AlignedArray(std::size_t size = 0) : values_(allocate(size)), size_(size) {}

    Value* data() { return values_.get(); }
    const Value* data() const { return values_.get(); }
    std::size_t size() const { return size_; }
    Value& operator[](std::size_t i) { return values_[i]; }
    const Value& operator[](std::size_t i) const { return values_[i]; }

    /// Room for at least `size` values; their content is lost when the array has to grow.
    void reserve(std::size_t size) {
        if (size > size_) *this = AlignedArray(size + size / 2);
    }

  private:
    static constexpr std::align_val_t boundary{64};  // a cache line, and the widest vector

    struct Free {
        void operator()(Value* p) const { ::operator delete[](p, boundary); }
    };

    static std::unique_ptr<Value[], Free> allocate(std::size_t size) {
        auto* values = static_cast<Value*>(::operator new[](std::max<std::size_t>(size, 1) * sizeof(Value), boundary));
        std::fill_n(values, size, Value{});
        return std::unique_ptr<Value[], Free>(values);
    }

    std::unique_ptr<Value[], Free> values_;
    std::size_t size_;
};

/// Index of `field` (of `fields` a group) of a slot in its array.
inline std::size_t place(std::uint32_t slot, int fields, int field, int width) {
    const auto w = static_cast<std::uint32_t>(width);
    return (slot / w) * static_cast<std::size_t>(fields * width) + static_cast<std::size_t>(field * width) + slot % w;
}

/// Groups that hold as many slots.
inline std::size_t groups_of(std::size_t slots, int width) {
    const auto w = static_cast<std::size_t>(width);
    return (slots + w - 1) / w;
}

/// All `fields` of some slots, saved or set, whatever the width.
template <class Value>
void archive_slots(StateArchive& state, AlignedArray<Value>& values, std::span<const std::uint32_t> slots, int fields,
                   int width) {
    for (const std::uint32_t slot : slots)
        for (int field = 0; field < fields; ++field) state(values[place(slot, fields, field, width)]);
}

}  // namespace floes
