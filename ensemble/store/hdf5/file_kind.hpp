#pragma once
// The kind of an HDF5 file and its layout version.

#include <array>
#include <string_view>

namespace floes::hdf5 {

struct FileKind {
    std::string_view filetype;   ///< attribute of the root
    std::array<int, 2> version;  ///< of the layout, {major, minor}: a new minor only adds names
    int oldest_minor;            ///< that can be read
    std::string_view what;       ///< as a message names it: "campaign of floes"
};

}  // namespace floes::hdf5
