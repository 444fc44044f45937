#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <system_error>

#include "core/error.hpp"
#include "hdf5/contents.hpp"
#include "hdf5/kind.hpp"
#include "hdf5/pages.hpp"
#include "records/file_calls.hpp"
#include "replay/frame_series.hpp"
#include "replay/recording.hpp"
#include "replay/recording_kind.hpp"
#include "replay/written_ice.hpp"

namespace floes {
namespace {

using hdf5::Handle;
using hdf5::Scale;

Scale words_scale(hid_t parent, const char* name, const char* long_name, const std::vector<std::string>& words) {
    return hdf5::write_scale(parent, {name, "1", long_name}, words);
}

void write_root(hid_t file, const RecordingSubject& subject) {
    const auto write_number = [file](const char* name, std::int32_t value) {
        hdf5::write_attribute(file, name, std::span<const std::int32_t>(&value, 1));
    };
    hdf5::write_kind(file, recording_kind,
                     fmt::format("{}: member {}, case {}, arrangement {}", subject.campaign, subject.member,
                                 subject.case_name, subject.arrangement));
    hdf5::write_attribute(file, "campaign", subject.campaign);
    hdf5::write_attribute(file, "fingerprint", subject.fingerprint);
    hdf5::write_attribute(file, "case", subject.case_name);
    write_number("member", subject.member);
    write_number("arrangement", subject.arrangement);
    hdf5::write_attribute(file, "time_step", subject.scenario.general.time_step);
}

void write_structure(hid_t file, const Shape& shape) {
    const Handle group = hdf5::create_group(file, "structure");
    const std::vector<std::vector<double>> rows = shape.profile();
    if (rows.empty()) return;  // the configuration has its sizes or pieces
    const Scale point =
        hdf5::write_index_scale(group.id(), "profile_point", "point of the profile, from the bottom up", rows.size());
    for (std::size_t k = 0; k < Shape::columns.size(); ++k) {
        std::vector<double> column;
        for (const std::vector<double>& row : rows) column.push_back(row[k]);
        const ShapeColumn& about = Shape::columns[k];
        hdf5::write_values(group.id(), {std::string(about.name), std::string(about.unit), std::string(about.text)},
                           {point}, column);
    }
}

void write_sheets(hid_t file, const std::vector<IceSheet>& all, const Scale& coordinate) {
    const Handle group = hdf5::create_group(file, "ice_sheets");
    const Scale sheet = hdf5::write_index_scale(group.id(), "sheet", "fixed box of ice along the channel", all.size());
    std::vector<double> centres;
    std::vector<double> sides;
    for (const IceSheet& one : all) {
        const Vec3 whole = 2 * one.half_extents;
        centres.insert(centres.end(), one.centre.begin(), one.centre.end());
        sides.insert(sides.end(), whole.begin(), whole.end());
    }
    hdf5::write_values(group.id(), {"centre", "m", "middle of each sheet"}, {sheet, coordinate}, centres);
    hdf5::write_values(group.id(), {"sides", "m", "length of its sides"}, {sheet, coordinate}, sides);
}

void write_history(hid_t file, const LoadHistory& history, double time_step) {
    std::vector<double> end;
    for (std::size_t k = 0; k < history.surge.size(); ++k) end.push_back(static_cast<double>(k + 1) * time_step);
    const Handle group = hdf5::create_group(file, "history");
    const Scale step = hdf5::write_scale(file, {"step_end", "s", "end of each time step"}, end);
    hdf5::write_values(group.id(), {"surge_load", "N", "positive against the tow"}, {step}, history.surge);
    hdf5::write_values(group.id(), {"sway_load", "N", "positive towards +z"}, {step}, history.sway);
    hdf5::write_values(group.id(), {"heave_load", "N", "positive up"}, {step}, history.heave);
}

/// None of a field without end, whose elements are known at the end.
std::optional<Scale> elements_known(hid_t file, const RecordingSubject& subject) {
    if (subject.scenario.field.endless()) return {};
    return element_scale(file, IceLayout(subject.floes));
}

std::optional<Scale> line_scale(hid_t file, const Scenario& scenario) {
    const std::size_t lines = scenario.moorings.give_way() ? scenario.moorings.lines.size() : 0;
    if (lines == 0) return {};
    return hdf5::write_index_scale(file, "mooring_line", "mooring line, in the order of moorings.lines", lines);
}

}  // namespace

class RecordingWriter::File {
  public:
    File(std::filesystem::path path, const RecordingSubject& subject)
        : path_(std::move(path)), aside_(path_.string() + ".tmp"), subject_(subject) {
        file_.emplace(hdf5::create_file(aside_));
        open_.emplace(file_->id(), subject_);
    }
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File() {
        if (file_) drop();
    }

    void add(const Frame& frame) {
        const double x = frame.structure.x;
        subject_.way = any_ ? Vec2(std::min(subject_.way.x(), x), std::max(subject_.way.y(), x)) : Vec2(x, x);
        any_ = true;
        open_->series.add(frame);
    }

    void finish(const RecordingOutcome& outcome, const FloeRoll& roll) {
        if (subject_.scenario.field.endless()) {
            subject_.floes = roll.floes();
            write_floes(file_->id(), subject_.floes, roll.numbers());
        }
        const IceLayout layout(subject_.floes);
        RecordScales& scales = open_->scales;
        if (!scales.element) scales.element.emplace(element_scale(file_->id(), layout));
        write_ice(file_->id(), subject_.scenario.floe, layout, scales);
        write_sheets(file_->id(), subject_.channel().sheets, scales.coordinate);
        write_joints(file_->id(), layout, outcome.breaks);
        write_history(file_->id(), outcome.history, subject_.scenario.general.time_step);
        open_->series.finish();
        hdf5::write_contents_digests(file_->id());
        open_.reset();  // only then does closing the file write everything
        file_->close("H5Fclose", path_.string());
        file_.reset();
        hdf5::append_page_digests(aside_);
        sync_data(open_file(aside_, O_RDWR), aside_);
        rename_into_place(aside_, path_);
    }

  private:
    struct Open {
        Open(hid_t file, const RecordingSubject& subject)
            : scales{words_scale(file, "coordinate", "axis of a vector", {"x", "y", "z"}),
                     words_scale(file, "quaternion", "part of a quaternion", {"w", "x", "y", "z"}),
                     elements_known(file, subject), line_scale(file, subject.scenario)},
              series(file, scales) {
            write_root(file, subject);
            hdf5::write_text(file, {"configuration", "1", "the member's case as a campaign, TOML"},
                             subject.configuration);
            write_structure(file, subject.scenario.structure.shape);
        }
        RecordScales scales;
        FrameSeries series;
    };

    void drop() {
        open_.reset();
        file_.reset();
        std::error_code ignored;
        std::filesystem::remove(aside_, ignored);
    }

    std::filesystem::path path_;
    std::filesystem::path aside_;
    RecordingSubject subject_;
    bool any_ = false;
    hdf5::QuietErrors quiet_;
    std::optional<Handle> file_;
    std::optional<Open> open_;
};

RecordingWriter::RecordingWriter(const std::filesystem::path& path, const RecordingSubject& subject)
    : file_(std::make_unique<File>(path, subject)) {}
RecordingWriter::~RecordingWriter() = default;

void RecordingWriter::add(const Frame& frame) {
    file_->add(frame);
}

void RecordingWriter::finish(const RecordingOutcome& outcome) {
    file_->finish(outcome, {});
}

void RecordingWriter::finish(const RecordingOutcome& outcome, const FloeRoll& roll) {
    file_->finish(outcome, roll);
}

}  // namespace floes
