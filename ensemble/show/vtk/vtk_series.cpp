#include "vtk/vtk_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <system_error>

#include "core/error.hpp"
#include "simulation/channel.hpp"
#include "tables/table.hpp"

namespace floes {
namespace {

void write_text(const std::filesystem::path& path, const std::string& text) {
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file)
        throw RunError(fmt::format("Cannot write {}; is the disk full, or the folder read-only?", path.string()));
}

}  // namespace

void write_vtk_series(const std::filesystem::path& path, const Recording& recording) {
    VtkSeries series(path, recording.subject(), recording.outcome().breaks);
    Frame frame;
    for (int number = 0; number < recording.frames(); ++number) {
        recording.read(number, frame);
        series.add(frame);
    }
    series.finish();
}

VtkSeries::VtkSeries(const std::filesystem::path& path, const RecordingSubject& subject,
                     const std::vector<BreakEvent>& breaks)
    : path_(path),
      folder_(std::filesystem::path(path).replace_extension()),
      subject_(subject),
      layout_(subject.floes),
      breaks_(breaks),
      state_{.collection = path.filename().string()} {
    if (path.extension() != ".pvd")
        throw InputError(
            fmt::format("A series for ParaView is named NAME.pvd; '{}' does not end in .pvd.", path.string()));
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error) throw RunError(fmt::format("Cannot make the folder {}: {}.", folder_.string(), error.message()));

    const VtkMesh sheets = ice_sheets_part(subject.channel());
    sheets_ = fmt::format("ice_sheets{}", sheets.extension());
    write_vtk(folder_ / sheets_, sheets, 0);
}

void VtkSeries::add(const Frame& frame) {
    write("ice", 0, ice_part(frame, layout_, broken_floes(breaks_, layout_.floes(), frame.time)), frame.time);
    write("structure", 1, structure_part(subject_.scenario.structure.shape, frame.structure), frame.time);
    write("load", 2, load_part(frame), frame.time);
    write("contacts", 3, contacts_part(frame), frame.time);
    list("ice_sheets", 4, sheets_, frame.time);
    if (!subject_.scenario.moorings.lines.empty()) write("moorings", 5, moorings_part(frame), frame.time);

    if (frames_ == 0) state_.first_axis = frame.structure.x;
    state_.last_axis = frame.structure.x;
    if (frames_ == 0 || frame.load.norm() > state_.largest_load) {
        state_.largest_load = frame.load.norm();
        state_.time_of_largest_load = frame.time;
    }
    state_.largest_force = std::max(state_.largest_force, frame.load.norm());
    for (const FrameContact& contact : frame.contacts)
        state_.largest_force = std::max(state_.largest_force, (contact.normal + contact.friction).norm());
    ++frames_;
}

void VtkSeries::write(const std::string& part, int number, const VtkMesh& mesh, double time) {
    const std::string file = fmt::format("{}_{:05}{}", part, frames_, mesh.extension());
    write_vtk(folder_ / file, mesh, time);
    list(part, number, file, time);
}

void VtkSeries::list(const std::string& part, int number, const std::string& file, double time) {
    datasets_ += fmt::format(R"(<DataSet timestep="{}" part="{}" name="{}" file="{}/{}"/>)"
                             "\n",
                             time, number, part, html_escaped(folder_.filename().string()), file);
}

void VtkSeries::finish() {
    write_text(std::filesystem::path(path_).replace_extension(".py"), vtk_state(state_, subject_));
    write_text(path_, fmt::format("<?xml version=\"1.0\"?>\n"
                                  "<VTKFile type=\"Collection\" version=\"1.0\">\n<Collection>\n{}"
                                  "</Collection>\n</VTKFile>\n",
                                  datasets_));
}

}  // namespace floes
