# A toolchain for aarch64 on another machine: the root of a Debian 12 for arm64 lies in the folder FLOES_SYSROOT
# (environment). On Debian 12 with g++-aarch64-linux-gnu and mmdebstrap:
#
#     mmdebstrap --variant=extract --architectures=arm64 \
#         --include="$(sed 's/#.*//' packaging/debian/packages.txt | xargs | tr ' ' ,)" bookworm arm64
#     export FLOES_SYSROOT=$PWD/arm64 MPI=$PWD/arm64/usr/lib/aarch64-linux-gnu/openmpi
#     cmake --preset release -B build/aarch64 --toolchain packaging/cross/aarch64.cmake -D MPI_CXX_LIB_NAMES=mpi \
#         -D MPI_mpi_LIBRARY=$MPI/lib/libmpi.so -D MPI_CXX_HEADER_DIR=$MPI/include -D MPI_CXX_SKIP_MPICXX=ON
#     cmake --build build/aarch64 --target floes_solver floes_water floes_statistics
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_SYSROOT $ENV{FLOES_SYSROOT})
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_SYSROOT_DIR} ${CMAKE_SYSROOT})
set(ENV{PKG_CONFIG_LIBDIR} ${CMAKE_SYSROOT}/usr/lib/aarch64-linux-gnu/pkgconfig:${CMAKE_SYSROOT}/usr/share/pkgconfig)
