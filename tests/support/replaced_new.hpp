#pragma once
// Replaces operator new and delete of a whole test program, in all their forms, by ones that tell two functions that it
// defines. To be included in one file of the program.

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace floes::replaced_new {

/// After memory was taken; nullptr where there was none left.
void taken(void* memory) noexcept;
/// Before it is freed.
void leaving(void* memory) noexcept;

inline void* take(std::size_t size, std::size_t boundary) noexcept {
    const std::size_t whole = (std::max<std::size_t>(size, 1) + boundary - 1) / boundary * boundary;
    void* const memory = std::aligned_alloc(boundary, whole);
    taken(memory);
    return memory;
}

inline void give_back(void* memory) noexcept {
    leaving(memory);
    std::free(memory);
}

inline void* take_or_throw(std::size_t size, std::size_t boundary = alignof(std::max_align_t)) {
    void* const memory = take(size, boundary);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

}  // namespace floes::replaced_new

void* operator new(std::size_t size) {
    return floes::replaced_new::take_or_throw(size);
}
void* operator new[](std::size_t size) {
    return floes::replaced_new::take_or_throw(size);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return floes::replaced_new::take(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t boundary) {
    return floes::replaced_new::take_or_throw(size, static_cast<std::size_t>(boundary));
}
void* operator new[](std::size_t size, std::align_val_t boundary) {
    return floes::replaced_new::take_or_throw(size, static_cast<std::size_t>(boundary));
}
void operator delete(void* memory) noexcept {
    floes::replaced_new::give_back(memory);
}
void operator delete[](void* memory) noexcept {
    floes::replaced_new::give_back(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    floes::replaced_new::give_back(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    floes::replaced_new::give_back(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    floes::replaced_new::give_back(memory);
}
void operator delete[](void* memory, std::align_val_t) noexcept {
    floes::replaced_new::give_back(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    floes::replaced_new::give_back(memory);
}
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept {
    floes::replaced_new::give_back(memory);
}
