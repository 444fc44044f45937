#pragma once
// One data set in VTK's XML format: .vtu (cells with a volume) and .vtp (surfaces and points), its arrays appended raw
// and compressed by zlib, as ParaView itself writes them.

#include <concepts>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "replay/recording.hpp"
#include "shapes/shape.hpp"
#include "simulation/record.hpp"
#include "simulation/sheets.hpp"

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

// What ParaView shows of a run, part by part. World axes and SI throughout; forces in N, velocities in m/s.

/// A hexahedron for each element. Cells have floe, piece (the first element of the piece), broken (1: a joint of its
/// floe has failed), utilisation (0-1, cracks to 2) and velocity. `broken`: of each floe.
VtkMesh ice_part(const Frame& frame, const IceLayout& layout, std::span<const std::uint8_t> broken);

/// A point for each contact that exerts a force. Points have normal, friction and force (their sum) on the element, the
/// element, and the other element or touches_structure or touches_ice_sheet.
VtkMesh contacts_part(const Frame& frame);

/// Four points on the structure's axis at the waterline. Points have the force on the structure and which one it is,
/// component: 0 surge, 1 heave, 2 sway (along x, y, z), 3 their sum.
VtkMesh load_part(const Frame& frame);

/// The surface of the structure with its axis there.
VtkMesh structure_part(const Shape& shape, const StructurePose& pose);

// A script for ParaView that shows a series of VTK files as Fig. 5 shows a run.

/// What a state needs to know of the series.
struct VtkStateOf {
    std::string collection;           ///< name of the .pvd file beside which the state will stand
    double first_axis = 0;            ///< x of the structure's axis in the first frame, m
    double last_axis = 0;             ///< in the last frame
    double largest_load = 0;          ///< on the structure in any frame, N
    double time_of_largest_load = 0;  ///< s
    double largest_force = 0;         ///< on the structure or at a contact, N
};

// A run for ParaView and for whatever else reads VTK's files. Beside NAME.pvd, which names every file with its time,
// stand a folder NAME of data sets and NAME.py, a state for ParaView that shows the run as Fig. 5 does.
//
// Why a series of files: ParaView 5.11 (Debian 12) opens it with the reader that it picks by itself, and every element
// is a cell of eight points with its own numbers, so that a histogram counts an element once, a threshold takes whole
// elements, and a slice cuts ice. XDMF over the recording's own arrays would cost no further space, but they hold
// poses, and XDMF has nothing that turns a pose into a box: one would see points, and boxes only through a glyph that
// no filter looks into. VTKHDF files that change in time are read from ParaView 5.12 on.

/// Writes the series of a recording, a frame at a time, over files of the same names. `path`: NAME.pvd. Throws
/// InputError for a path that does not end in .pvd, RunError when a file cannot be written.
void write_vtk_series(const std::filesystem::path& path, const Recording& recording);

/// The series of frames that come in order of time. Not complete before finish(): then NAME.pvd and NAME.py are
/// written.
class VtkSeries {
  public:
    /// As write_vtk_series(). `subject` and `breaks` (in order of time) are looked at until finish().
    VtkSeries(const std::filesystem::path& path, const RecordingSubject& subject,
              const std::vector<BreakEvent>& breaks);

    void add(const Frame& frame);
    void finish();

  private:
    void write(const std::string& part, int number, const VtkMesh& mesh, double time);
    void list(const std::string& part, int number, const std::string& file, double time);

    std::filesystem::path path_;
    std::filesystem::path folder_;
    const RecordingSubject& subject_;
    IceLayout layout_;
    const std::vector<BreakEvent>& breaks_;
    std::string sheets_;
    std::string datasets_;  // lines of NAME.pvd
    int frames_ = 0;
    VtkStateOf state_;
};

}  // namespace floes
