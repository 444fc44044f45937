// A CAD file: the first byte says whether it is an OBJ file ('o') or an STL file.

#include "campaign/hull_file.hpp"
#include "fuzz/campaign_text.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0 || size > 20000) return 0;  // more triangles take longer and tell no more
    const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    floes::Structure structure;
    const auto taken = floes::fuzz::taken([&] {
        floes::take_hull(structure, bytes, data[0] == 'o' ? "a.obj" : "a.stl");
        return true;
    });
    if (!taken) return 0;
    structure.shape.set_kind(floes::HullKind::file);
    floes::Shape again = structure.shape;
    again.set_pieces(structure.shape.piece_rows());
    floes::fuzz::require(again.piece_rows() == structure.shape.piece_rows(), "pieces are those of their corners");
    static_cast<void>(structure.shape.fault());
    return 0;
}
