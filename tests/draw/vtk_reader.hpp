#pragma once
// Reads what vtk/vtk_file writes, so that tests see the numbers that a reader of VTK's format finds.

#include <zlib.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

namespace floes {

inline std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("no file " + path.string());
    return {std::istreambuf_iterator<char>(file), {}};
}

class VtkReader {
  public:
    explicit VtkReader(const std::filesystem::path& path) : text_(text_of(path)) {
        const std::string opening = "<AppendedData encoding=\"raw\">\n_";
        data_ = text_.find(opening) + opening.size();
    }

    /// The number in an attribute of the piece, as "NumberOfPoints".
    int number(const std::string& attribute) const { return std::stoi(found(attribute + "=\"([0-9]+)\"")); }

    std::string type(const std::string& array) const { return found("type=\"([A-Za-z0-9]+)\" Name=\"" + array + "\""); }

    template <class Value>
    std::vector<Value> values(const std::string& array) const {
        const std::size_t at = data_ + std::stoul(found("Name=\"" + array + "\"[^/]*offset=\"([0-9]+)\""));
        std::array<std::uint64_t, 4> header{};  // blocks, size of a block, of the last one, compressed size
        std::memcpy(header.data(), text_.data() + at, 3 * sizeof(std::uint64_t));
        if (header[0] == 0) return {};
        std::memcpy(header.data(), text_.data() + at, sizeof header);
        std::vector<Value> values(header[1] / sizeof(Value));
        uLongf size = header[1];
        const auto* const packed = reinterpret_cast<const Bytef*>(text_.data() + at + sizeof header);
        if (uncompress(reinterpret_cast<Bytef*>(values.data()), &size, packed, header[3]) != Z_OK ||
            size != values.size() * sizeof(Value))
            throw std::runtime_error("cannot unpack " + array);
        return values;
    }

  private:
    std::string found(const std::string& pattern) const {
        std::smatch match;
        const std::string head = text_.substr(0, data_);
        if (!std::regex_search(head, match, std::regex(pattern))) throw std::runtime_error("nothing like " + pattern);
        return match[1];
    }

    std::string text_;
    std::size_t data_ = 0;
};

}  // namespace floes
