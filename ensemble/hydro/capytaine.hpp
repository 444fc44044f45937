#pragma once
// The one door to NetCDF: what Capytaine wrote of a body, in either of its two containers.

#include <string>
#include <string_view>

#include "hydro/radiation.hpp"

namespace floes {

/// Judged by the first bytes: NetCDF-3, or HDF5 as NetCDF-4 is.
bool is_netcdf(std::string_view bytes);

/// One body by the names of variables, dimensions and motions: their order is another from Capytaine 3.0 on. Rows with
/// a number that is none, as at low frequencies, are left out, with a remark. Throws InputError for what is no such
/// file, for several bodies, depths or speeds, for motions other than the six, and for a frequency that stands twice
/// with other values.
RadiationFile read_capytaine(std::string_view bytes, const std::string& file);

}  // namespace floes
