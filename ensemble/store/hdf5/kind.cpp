#include "hdf5/kind.hpp"

#include <fmt/format.h>

#include <vector>

#include "core/error.hpp"
#include "hdf5/read.hpp"
#include "hdf5/write.hpp"
#include "records/build_info.hpp"

namespace floes::hdf5 {

void write_kind(hid_t file, const FileKind& kind, const std::string& title) {
    const std::vector<std::int32_t> version(kind.version.begin(), kind.version.end());
    write_attribute(file, "title", title);
    write_attribute(file, "Conventions", std::string("CF-1.8"));
    write_attribute(file, "filetype", std::string(kind.filetype));
    write_attribute(file, "version", version);
    write_attribute(file, "software", std::string("floes"));
    write_attribute(file, "softwareVersion", floes_version());
}

bool is_of_kind(hid_t file, const FileKind& kind) {
    return has_attribute(file, "filetype") && read_text_attribute(file, "filetype") == kind.filetype;
}

void check_kind(hid_t file, const FileKind& kind, const std::filesystem::path& path) {
    if (!is_of_kind(file, kind))
        throw InputError(fmt::format("{} is an HDF5 file, but no {}.", path.string(), kind.what));
    const std::vector<std::int32_t> version = read_int_attribute(file, "version");
    if (version.size() != kind.version.size() || version[0] != kind.version[0])
        throw InputError(
            fmt::format("{} has layout version {}, and this program reads version {}. Use the version of "
                        "floes that wrote it.",
                        path.string(), version.empty() ? 0 : version[0], kind.version[0]));
    if (version[1] < kind.oldest_minor)
        throw InputError(
            fmt::format("{} has layout {}.{}, of a floes before 1.0, which this program does not read any more; floes "
                        "1.0 does.",
                        path.string(), version[0], version[1]));
}

}  // namespace floes::hdf5
