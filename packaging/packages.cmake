# The packages: floes_VERSION_ARCHITECTURE.deb, and a tarball that has all it needs and runs from any folder.
set(CPACK_GENERATOR External)  # bundle.cmake
find_program(FLOES_DPKG_DEB dpkg-deb)
if(FLOES_DPKG_DEB)
  list(PREPEND CPACK_GENERATOR DEB)
endif()
set(CPACK_PACKAGE_NAME floes)
set(CPACK_PACKAGE_VENDOR "the floes developers")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR})
set(CPACK_PACKAGE_FILE_NAME floes-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
    WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_SOURCE_DIR}/debian.cmake)
set(CPACK_EXTERNAL_PACKAGE_SCRIPT ${CMAKE_CURRENT_SOURCE_DIR}/bundle.cmake)
set(CPACK_EXTERNAL_ENABLE_STAGING ON)
set(CPACK_FLOES_PACKAGING ${CMAKE_CURRENT_SOURCE_DIR})
set(CPACK_FLOES_RELEASE_DATE ${FLOES_RELEASE_DATE})
set(CPACK_VERBATIM_VARIABLES ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "the floes developers <floes@localhost.localdomain>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "ensembles of the ice load on a structure in managed ice floes")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"floes computes the ice load on a structure that is towed through managed ice
floes, and its scatter over many random arrangements of the floes. Members of
a campaign are rigid-body simulations of floes with breakable joints; they
run on every core of a laptop or of a cluster and end in one HDF5 file, from
which floes reports mean loads, maxima and broken floes with confidence
intervals.")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS openmpi-bin)  # run --ranks
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "ffmpeg, slurm-wlm, python3, python3-h5py, python3-pandas, python3-xarray, python3-matplotlib")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
include(CPack)
