#pragma once
// A field without end of the cells of one Voronoi diagram, laid part after part as a tow needs it: a sheet that broke
// and opened. Of each part field.floes points are thrown; its floes are the next field.floes cells along x of the
// diagram of all points (shapes/drawn.hpp), with their edges moved inwards by one distance that leaves the
// concentration. Cells that this would leave narrower than the ice is thick are open water.
//
// Part k is the same whatever the length of the run: a pure function of (scenario, seed, number, k).

#include <cstdint>
#include <vector>

#include "core/vector.hpp"
#include "scenario/floes.hpp"
#include "scenario/scenario.hpp"
#include "shapes/drawn.hpp"

namespace floes {

class CellField {
  public:
    /// Nothing is laid yet. The scenario's shapes.kind is voronoi.
    CellField(const Scenario& scenario, std::uint64_t seed, std::uint32_t number);

    /// Lays the next part. Its floes stand in the order of their cells' middles; they keep the clearance from each
    /// other, from those of the parts before and from the sides. Throws InputError if the cells are too narrow or lie
    /// too near.
    FieldPart next();

  private:
    void throw_points();
    std::vector<Outline> opened(std::size_t count, std::size_t& taken);
    void check_beside_last(const std::vector<SingleFloe>& floes) const;

    Scenario scenario_;
    std::uint64_t seed_;
    std::uint32_t number_;
    WaterArea strip_;  // of the points that are thrown next
    EndlessCells diagram_;
    std::uint64_t thrown_ = 0;      // times
    std::uint64_t parts_ = 0;       // laid
    std::vector<SingleFloe> last_;  // part
};

// Level ice without end: the cells of one Voronoi diagram that does not end (shapes/drawn.hpp), relaxed until they are
// much alike, laid part after part and joined to those that lie. The sheet begins at field.begin_m and has straight
// sides.
//
// Part k is the same whatever the length of the run: a pure function of (scenario, seed, number, k).

class EndlessSheet {
  public:
    /// Nothing is laid yet. The scenario's arrangement.method is level.
    EndlessSheet(const Scenario& scenario, std::uint64_t seed, std::uint32_t number);

    /// Lays the next part, some rows of cells, in the order of their middles' x; all parts have equally many.
    FieldPart next();

  private:
    /// A cell that others may still be joined to.
    struct Laid {
        int number;
        Corner centre;    ///< m, in the field
        Outline corners;  ///< likewise
        double side;      ///< of a square of its area, m
    };

    void throw_points();
    void join(const Laid& cell, std::vector<CutJoint>& joints) const;

    SingleFloe sheet_;  ///< the ice of all of it
    std::uint64_t seed_;
    std::uint32_t number_;
    std::uint64_t draw_;  ///< of the cells
    std::size_t cells_;   ///< of a part
    WaterArea strip_;     ///< of the points that are thrown next
    EndlessCells diagram_;
    std::uint64_t thrown_ = 0;  ///< times
    int laid_ = 0;              ///< cells
    std::vector<Laid> edge_;    ///< by number
};

// A field without end of rectangles or polygons, laid part after part as a tow needs it: each of field.floes floes,
// scattered and pushed apart beside the floes of the part before, which stay where they are. There is no seam: ahead of
// each part wait more floes, between it and the straight wall against which all were packed. When the next part is
// laid, those near that wall are thrown again with the new floes, the others are pushed from where they lie, and some
// of all these are the next part.
//
// Part k is the same whatever the length of the run: a pure function of (scenario, seed, number, k).

class EndlessField {
  public:
    /// Nothing is laid yet. The scenario's arrangement.method is scattered, without ordering_sweeps; geometry: its
    /// geometry_key().
    EndlessField(const Scenario& scenario, std::uint64_t seed, std::uint32_t number, std::uint64_t geometry);

    /// Lays the next part. Its floes stand in the order of their middles' x; they keep the clearance from each other,
    /// from those of the parts before and from the sides. Throws InputError if they do not come to rest.
    FieldPart next();

  private:
    std::vector<SingleFloe> drawn(std::uint64_t part) const;
    double end_of_all() const;

    Scenario scenario_;
    std::uint64_t seed_;
    std::uint32_t number_;
    std::uint64_t geometry_;
    std::uint64_t parts_ = 0;
    double area_ = 0;                  // of all floes so far, waiting ones included, m²
    double end_ = 0;                   // of what is laid, m
    std::vector<SingleFloe> waiting_;  // ahead of the last part, to be thrown anew
    std::vector<SingleFloe> laid_;     // of the last parts, as far as they are near the end
};

}  // namespace floes
