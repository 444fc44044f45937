from spack.package import *


class Floes(CMakePackage):
    """Ensembles of the ice load on a structure that is towed through managed ice floes."""

    # Not in Spack's own repository and without an address to fetch it from: docs/start.md says how to build with it.
    license("BSD-3-Clause")

    version("4.0.0")

    generator("ninja")

    depends_on("cxx", type="build")
    depends_on("cmake@3.22:", type="build")
    depends_on("pkgconfig", type="build")
    depends_on("bullet3+double_precision")
    depends_on("eigen@3.4:")
    depends_on("random123")
    depends_on("boost@1.74:")
    depends_on("netcdf-c~mpi")
    depends_on("nlopt")
    depends_on("xxhash")
    depends_on("mpi")
    depends_on("intel-oneapi-tbb")
    depends_on("hdf5@1.10:+hl~mpi")
    depends_on("zlib")
    depends_on("nlohmann-json@3.11:")
    depends_on("tomlplusplus@3.3:")
    depends_on("cli11@2.1:")
    depends_on("fmt@9:")
    depends_on("cairo")
    depends_on("libxlsxwriter")

    # What pages with scripts contain is no package of Spack: three.min.js of release 111, d3.min.js of release 3.5.17.
    variant("three", default="", values=str, description="Where three.min.js lies")
    variant("d3", default="", values=str, description="Where d3.min.js lies")

    def cmake_args(self):
        return [
            self.define("FLOES_TESTS", False),
            self.define("FLOES_WARNINGS_AS_ERRORS", False),
            self.define("FLOES_THREE", self.spec.variants["three"].value),
            self.define("FLOES_D3", self.spec.variants["d3"].value),
        ]
