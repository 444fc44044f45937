#pragma once
// Whole files as text, and as bytes for tests that damage them.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "core/bytes.hpp"

namespace floes {

inline std::string file_text(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

inline Bytes file_bytes(const std::filesystem::path& path) {
    const std::string text = file_text(path);
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

inline void write_file_bytes(const std::filesystem::path& path, std::span<const std::byte> bytes) {
    // A file emptied and written again would be flushed to the disk by the file system; a new one is not.
    std::filesystem::remove(path);
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace floes
