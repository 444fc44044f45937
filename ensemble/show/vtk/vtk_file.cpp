#include "vtk/vtk_file.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <array>
#include <fstream>
#include <utility>

#include "core/error.hpp"

namespace floes {
namespace {

constexpr int zlib_level = 1;  // higher ones save a hundredth of the bytes and take up to twice as long
constexpr std::uint8_t vtk_hexahedron = 12;
constexpr std::uint8_t vtk_convex_point_set = 41;

/// The bytes of an array as one compressed block behind VTK's header: number of blocks, size of a block, size of the
/// last one if it is shorter, compressed size.
std::string packed(const std::vector<char>& bytes) {
    if (bytes.empty()) return std::string(3 * sizeof(std::uint64_t), '\0');
    uLongf size = compressBound(bytes.size());
    std::string block(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(block.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                  bytes.size(), zlib_level) != Z_OK)
        throw RunError("zlib could not compress an array of a VTK file; memory may be short.");
    block.resize(size);
    const std::array<std::uint64_t, 4> header{1, bytes.size(), 0, size};
    return std::string(reinterpret_cast<const char*>(header.data()), sizeof header) + block;
}

/// The document is collected in two parts: elements that say where the data stand, and the data.
class Document {
  public:
    void line(std::string_view text) { text_.append(text).append("\n"); }

    void array(const VtkArray& array) {
        line(fmt::format(R"(<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="appended" offset="{}"/>)",
                         array.type, array.name, array.components, data_.size()));
        data_ += packed(array.bytes);
    }

    void arrays(std::string_view element, const std::vector<VtkArray>& all) {
        line(fmt::format("<{}>", element));
        for (const VtkArray& one : all) array(one);
        line(fmt::format("</{}>", element));
    }

    const std::string& text() const { return text_; }
    const std::string& data() const { return data_; }

  private:
    std::string text_;
    std::string data_;
};

std::vector<std::uint8_t> cell_types(const VtkMesh& mesh) {
    std::vector<std::uint8_t> types(mesh.offsets.size(), vtk_hexahedron);
    for (std::size_t k = 0; k < types.size() && mesh.kind == VtkCells::solids; ++k)
        if (mesh.offsets[k] - (k > 0 ? mesh.offsets[k - 1] : 0) != 8) types[k] = vtk_convex_point_set;
    return types;
}

}  // namespace

std::string_view VtkMesh::extension() const {
    return kind == VtkCells::hexahedra || kind == VtkCells::solids ? ".vtu" : ".vtp";
}

void write_vtk(const std::filesystem::path& path, const VtkMesh& mesh, double time) {
    const bool volume = mesh.kind == VtkCells::hexahedra || mesh.kind == VtkCells::solids;
    const std::string_view type = volume ? "UnstructuredGrid" : "PolyData";
    const std::size_t points = mesh.points.size() / 3;
    const std::string_view cells = volume                          ? "Cells"
                                   : mesh.kind == VtkCells::points ? "Verts"
                                   : mesh.kind == VtkCells::lines  ? "Lines"
                                                                   : "Polys";

    std::vector<VtkArray> topology{vtk_array("connectivity", mesh.connectivity), vtk_array("offsets", mesh.offsets)};
    if (volume) topology.push_back(vtk_array("types", cell_types(mesh)));

    Document document;
    document.line(R"(<?xml version="1.0"?>)");
    document.line(fmt::format(R"(<VTKFile type="{}" version="1.0" byte_order="{}" header_type="UInt64" )"
                              R"(compressor="vtkZLibDataCompressor">)",
                              type, std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian"));
    document.line(fmt::format("<{}>", type));
    document.line(fmt::format(R"(<FieldData><DataArray type="Float64" Name="TimeValue" NumberOfTuples="1" )"
                              R"(format="ascii">{}</DataArray></FieldData>)",
                              time));
    document.line(fmt::format(R"(<Piece NumberOfPoints="{}" {}="{}">)", points,
                              volume ? "NumberOfCells" : fmt::format("NumberOf{}", cells), mesh.offsets.size()));
    document.arrays("PointData", mesh.point_data);
    document.arrays("CellData", mesh.cell_data);
    document.arrays("Points", {vtk_array("Points", mesh.points, 3)});
    document.arrays(cells, topology);
    document.line("</Piece>");
    document.line(fmt::format("</{}>", type));
    document.line(R"(<AppendedData encoding="raw">)");

    std::ofstream file(path, std::ios::binary);
    file << document.text() << '_' << document.data() << "\n</AppendedData>\n</VTKFile>\n";
    file.close();
    if (!file)
        throw RunError(fmt::format("Cannot write {}; is the disk full, or the folder read-only?", path.string()));
}

}  // namespace floes
