# Every foreign library that the project uses. All are in Debian 12 (packages.txt); other systems may name them
# otherwise.
find_package(PkgConfig REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(Boost 1.74 REQUIRED)
find_package(TBB REQUIRED)
find_package(MPI REQUIRED COMPONENTS CXX)
find_package(ZLIB REQUIRED)

# Only its headers (src/keys/document.hpp).
find_path(FLOES_TOMLPLUSPLUS toml++/toml.h REQUIRED)
add_library(tomlplusplus INTERFACE)
target_include_directories(tomlplusplus SYSTEM INTERFACE ${FLOES_TOMLPLUSPLUS})

# Bullet's own CMake package names a library that Debian does not ship; pkg-config does not. It must be the one with
# double precision, which is called bullet where it was built so.
pkg_search_module(bullet REQUIRED IMPORTED_TARGET bullet-float64 bullet)
if(NOT bullet_CFLAGS MATCHES "BT_USE_DOUBLE_PRECISION")
  message(FATAL_ERROR "This Bullet computes in single precision; build it with USE_DOUBLE_PRECISION=ON "
                      "(docs/clusters.md).")
endif()
pkg_search_module(hdf5 REQUIRED IMPORTED_TARGET hdf5-serial hdf5)
pkg_check_modules(nlopt REQUIRED IMPORTED_TARGET nlopt)
pkg_check_modules(netcdf REQUIRED IMPORTED_TARGET netcdf)
pkg_check_modules(cairo REQUIRED IMPORTED_TARGET cairo)
pkg_check_modules(xlsxwriter REQUIRED IMPORTED_TARGET xlsxwriter)
pkg_check_modules(xxhash REQUIRED IMPORTED_TARGET libxxhash)

# Dimension scales live in HDF5's high-level library, which its pkg-config file leaves out.
find_library(FLOES_HDF5_HL NAMES hdf5_serial_hl hdf5_hl HINTS ${hdf5_LIBRARY_DIRS} REQUIRED)
target_link_libraries(PkgConfig::hdf5 INTERFACE ${FLOES_HDF5_HL})

# Not compiled: they become part of the pages with scripts, which play replays and show members to be explored.
find_file(FLOES_THREE three.min.js PATHS /usr/share/javascript/three NO_DEFAULT_PATH)
if(NOT FLOES_THREE)
  message(FATAL_ERROR "three.min.js is missing, which draws replays; install Debian's package libjs-three, or give its "
                      "place with -D FLOES_THREE=FILE.")
endif()
find_file(FLOES_D3 d3.min.js PATHS /usr/share/javascript/d3 NO_DEFAULT_PATH)
if(NOT FLOES_D3)
  message(FATAL_ERROR "d3.min.js is missing, which pages of floes explore need; install Debian's package libjs-d3, or "
                      "give its place with -D FLOES_D3=FILE.")
endif()
