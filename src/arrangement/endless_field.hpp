#pragma once
// A field without end of rectangles or polygons, laid part after part as a tow needs it: each of field.floes floes,
// scattered and pushed apart beside the floes of the part before, which stay where they are. There is no seam: ahead of
// each part wait more floes, between it and the straight wall against which all were packed. When the next part is
// laid, those near that wall are thrown again with the new floes, the others are pushed from where they lie, and some
// of all these are the next part.
//
// Part k is the same whatever the length of the run: a pure function of (scenario, seed, number, k).

#include <cstdint>
#include <span>
#include <vector>

#include "core/vector.hpp"
#include "scenario/floes.hpp"
#include "scenario/scenario.hpp"

namespace floes {

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
