#pragma once
// A run for ParaView, and for whatever else reads XDMF 2: NAME.xdmf2 says in XML what there is at which time,
// NAME.xdmf2.h5 has the numbers (HDF5), and NAME.py is a state for ParaView that shows the run as Fig. 5 does.
//
// Why XDMF 2: ParaView 5.11 (Debian 12) opens it with the reader that it picks by itself. It reads no VTKHDF file that
// changes in time; of its readers of XDMF 3 the parts lose their names. XDMF 2 has no cell with the faces of a prism of
// any number of corners, so an element that is one is cut into hexahedra and a wedge, which have its numbers each.

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "hdf5/handle.hpp"
#include "replay/recording.hpp"
#include "shapes/shape.hpp"
#include "simulation/record.hpp"
#include "simulation/sheets.hpp"

namespace floes {

/// Numbers, tuple by tuple.
using XdmfValues = std::variant<std::vector<float>, std::vector<std::int32_t>, std::vector<std::int8_t>>;

struct XdmfArray {
    std::string name;
    XdmfValues values;
    int components = 1;  ///< 1 or 3
};

struct XdmfMesh {
    std::vector<float> points = {};        ///< x, y, z of each, m
    std::vector<std::int32_t> cells = {};  ///< of each its kind by XDMF, how many points where that differs, the points
    int count = 0;                         ///< of the cells
    std::vector<XdmfArray> point_data = {};
    std::vector<XdmfArray> cell_data = {};
};

// What ParaView shows of a run, part by part. World axes and SI throughout; forces in N, velocities in m/s.

/// Hexahedra and wedges of the elements, one for each that is a box. Cells have element, floe, piece (the first element
/// of the piece), broken (1: a joint of its floe has failed; of level ice: it has broken off), utilisation (0-1, cracks
/// to 2) and velocity. `broken`: of each floe. `sheet`: of level ice, its piece that is not broken off.
XdmfMesh ice_part(const Frame& frame, const IceLayout& layout, std::span<const std::uint8_t> broken, int sheet = -1);

/// A point for each contact that exerts a force. Points have normal, friction and force (their sum) on the element, the
/// element, and the other element or one of touches_structure, touches_ice_sheet, touches_bed.
XdmfMesh contacts_part(const Frame& frame);

/// Four points on the structure's axis at the waterline. Points have the force on the structure and which one it is,
/// component: 0 surge, 1 heave, 2 sway (along x, y, z), 3 their sum.
XdmfMesh load_part(const Frame& frame);

/// The surface of the structure, given about its axis, with its axis there.
XdmfMesh structure_part(const SurfaceMesh& surface, const StructurePose& pose);

// A script for ParaView that shows a series as Fig. 5 shows a run.

/// What a state needs to know of the series.
struct SeriesState {
    std::string file;                 ///< name of the .xdmf2 file beside which the state will stand
    double first_axis = 0;            ///< x of the structure's axis in the first frame, m
    double last_axis = 0;             ///< in the last frame
    double largest_load = 0;          ///< on the structure in any frame, N
    double time_of_largest_load = 0;  ///< s
    double largest_force = 0;         ///< on the structure or at a contact, N
};

/// Writes the three files of a recording, a frame at a time, over files of the same names. `path`: NAME.xdmf2. Throws
/// InputError for a path that does not end so, RunError when a file cannot be written.
void write_xdmf_series(const std::filesystem::path& path, const Recording& recording);

/// The series of frames that come in order of time. Not complete before finish(). What is as it was in the frame before
/// is not written again: the fixed ice, the faces of the hull and, of one that is towed straight, all but its x.
class XdmfSeries {
  public:
    /// As write_xdmf_series(). `subject` and `breaks` (in order of time) are looked at until finish().
    XdmfSeries(const std::filesystem::path& path, const RecordingSubject& subject,
               const std::vector<BreakEvent>& breaks);

    void add(const Frame& frame);
    void finish();

  private:
    struct Written {
        XdmfValues values;
        std::string item;
    };

    void write(const std::string& part, const XdmfMesh& mesh, double time);
    std::string item(const std::string& part, const XdmfArray& array);
    std::string attributes(const std::string& part, const std::vector<XdmfArray>& arrays, std::string_view centre);

    std::filesystem::path path_;
    hdf5::QuietErrors quiet_;
    hdf5::Handle numbers_;
    const RecordingSubject& subject_;
    IceLayout layout_;
    const std::vector<BreakEvent>& breaks_;
    XdmfMesh sheets_;
    SurfaceMesh hull_;
    std::vector<std::pair<std::string, std::string>> grids_;  ///< parts as they come, and their grids in XML
    std::map<std::string, Written> written_;                  ///< the last of each array
    int frames_ = 0;
    SeriesState state_;
};

}  // namespace floes
