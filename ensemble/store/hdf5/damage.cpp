#include "hdf5/damage.hpp"

#include <fmt/format.h>

namespace floes::hdf5 {
namespace {

constexpr std::string_view remedy =
    "Restore it from a copy, or make it anew: a campaign file from the journal beside it (floes run CONFIG.toml -o "
    "FILE.h5 --resume), a record by floes replay. floes verify says what of it is whole.";

std::string path_of(hid_t object) {
    const auto length = H5Fget_name(object, nullptr, 0);
    if (length <= 0) return "the file";
    std::string path(static_cast<std::size_t>(length) + 1, '\0');
    H5Fget_name(object, path.data(), path.size());
    path.resize(static_cast<std::size_t>(length));
    return path;
}

}  // namespace

DamagedFile::DamagedFile(std::string_view path, std::string_view fault)
    : RunError(fmt::format("{} is damaged: {}. {}", path, fault, remedy)), fault_(fault) {}

void refuse_damaged(hid_t object, std::string_view fault) {
    throw DamagedFile(path_of(object), fault);
}

void refuse_unreadable(hid_t object, const std::string& name) {
    const std::string reason = last_reason();  // before further calls change it
    refuse_damaged(object, fmt::format("{} cannot be read (HDF5: {})", name, reason));
}

}  // namespace floes::hdf5
