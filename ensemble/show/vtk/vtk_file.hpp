#pragma once
// One data set in VTK's XML format: .vtu (cells with a volume) and .vtp (surfaces and points), its arrays appended raw
// and compressed by zlib, as ParaView itself writes them.

#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace floes {

/// An array as the file holds it: tuple by tuple, in the machine's byte order.
struct VtkArray {
    std::string name;
    std::string_view type;  ///< "Float32", "Int32", "UInt8"
    int components = 1;
    std::vector<char> bytes;
};

/// The array of `values`, whose number is a multiple of `components`.
template <class Value>
VtkArray vtk_array(std::string name, const std::vector<Value>& values, int components = 1) {
    constexpr bool real = std::same_as<Value, float>;
    static_assert(real || std::same_as<Value, std::int32_t> || std::same_as<Value, std::uint8_t>);
    constexpr std::string_view type = real ? "Float32" : sizeof(Value) == 1 ? "UInt8" : "Int32";
    VtkArray array{std::move(name), type, components, std::vector<char>(values.size() * sizeof(Value))};
    if (!values.empty()) std::memcpy(array.bytes.data(), values.data(), array.bytes.size());
    return array;
}

enum class VtkCells {
    points,     ///< a vertex for each point
    polygons,   ///< a surface
    lines,      ///< from point to point
    hexahedra,  ///< eight points each: four round the bottom, the four above them
    solids      ///< hexahedra, and any other convex set of points
};

struct VtkMesh {
    VtkCells kind = VtkCells::points;
    std::vector<float> points = {};  ///< x, y, z of each, m
    std::vector<std::int32_t> connectivity =
        {};                                  ///< the points of all cells, cell by cell; each point once for `points`
    std::vector<std::int32_t> offsets = {};  ///< where each cell ends in `connectivity`
    std::vector<VtkArray> point_data = {};
    std::vector<VtkArray> cell_data = {};

    /// ".vtu" for hexahedra and solids, else ".vtp".
    std::string_view extension() const;
};

/// Writes `mesh` at `time`, s (as field data TimeValue). Throws RunError when the file cannot be written.
void write_vtk(const std::filesystem::path& path, const VtkMesh& mesh, double time);

}  // namespace floes
