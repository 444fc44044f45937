#pragma once
// A run for ParaView and for whatever else reads VTK's files. Beside NAME.pvd, which names every file with its time,
// stand a folder NAME of data sets and NAME.py, a state for ParaView that shows the run as Fig. 5 does.
//
// Why a series of files: ParaView 5.11 (Debian 12) opens it with the reader that it picks by itself, and every element
// is a cell of eight points with its own numbers, so that a histogram counts an element once, a threshold takes whole
// elements, and a slice cuts ice. XDMF over the recording's own arrays would cost no further space, but they hold
// poses, and XDMF has nothing that turns a pose into a box: one would see points, and boxes only through a glyph that
// no filter looks into. VTKHDF files that change in time are read from ParaView 5.12 on.

#include <filesystem>
#include <string>
#include <vector>

#include "replay/recording.hpp"
#include "simulation/frame.hpp"
#include "vtk/vtk_parts.hpp"
#include "vtk/vtk_state.hpp"

namespace floes {

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
