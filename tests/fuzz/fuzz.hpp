#pragma once
// What the fuzz targets share. A target is one function that reads any bytes. Whatever it is given, it may refuse with
// a sentence or take it; what it takes must survive being written and read again.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <span>
#include <string_view>

#include "core/error.hpp"

/// The one function of a target; libFuzzer and replay.cpp call it. Gives 0.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace floes::fuzz {

/// Ends the program when it does not hold: the input is a finding.
inline void require(bool holds, std::string_view what) {
    if (holds) return;
    std::fprintf(stderr, "the input is a finding: %.*s\n", static_cast<int>(what.size()), what.data());
    std::abort();
}

/// What read() gives; empty if it refuses. Any other exception ends the program, and so does a refusal without words.
template <class Read>
auto taken(const Read& read) -> std::optional<decltype(read())> {
    try {
        return read();
    } catch (const InputError& error) {
        require(!std::string_view(error.what()).empty(), "an InputError says nothing");
    } catch (const RunError& error) {
        require(!std::string_view(error.what()).empty(), "a RunError says nothing");
    }
    return std::nullopt;
}

inline std::string_view as_text(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

inline std::span<const std::byte> as_bytes(const std::uint8_t* data, std::size_t size) {
    return std::as_bytes(std::span(data, size));
}

}  // namespace floes::fuzz
