#pragma once
// Floes side by side, which may differ: shapes and materials stand in tables, and each floe says which are its own.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/vector.hpp"
#include "scenario/scenario.hpp"

namespace floes {

struct Floe {
    PlanarPose pose;           ///< of its centre
    std::size_t shape = 0;     ///< index in FloeSet::shapes
    std::size_t material = 0;  ///< index in FloeSet::materials
};

struct FloeSet {
    std::vector<FloeShape> shapes;
    std::vector<Material> materials;
    std::vector<Floe> floes;

    std::size_t size() const { return floes.size(); }
    const FloeShape& shape(std::size_t floe) const { return shapes[floes[floe].shape]; }
    const Material& material(std::size_t floe) const { return materials[floes[floe].material]; }
    bool alike() const { return shapes.size() == 1 && materials.size() == 1; }

    std::vector<PlanarPose> poses() const;
};

/// A floe by itself, without tables.
struct SingleFloe {
    PlanarPose pose;
    FloeShape shape;
    Material material;
};

/// A part of a field without end: the floes whose middles lie behind its end, and ahead of that of the part before.
struct FieldPart {
    std::vector<SingleFloe> floes;
    double end = 0;  ///< x, m
};

/// Of a field without end: what is laid already ends at `end`, x in m, and next() lays one part more.
struct IceAhead {
    double end = 0;
    std::function<FieldPart()> next;
};

/// The set of these floes, in their order; equal shapes and equal materials stand in the tables once.
FloeSet gathered(std::span<const SingleFloe> floes);

/// A floe of the scenario's own shape and material at each pose.
FloeSet floes_at(const Scenario& scenario, std::span<const PlanarPose> poses);

/// Which of a campaign's arrangements: what laws draw floes by.
struct Draw {
    std::uint64_t seed = 0;    ///< of the campaign
    std::uint32_t number = 0;  ///< of the arrangement
    std::uint64_t part = 0;    ///< of a field without end, laid part after part; 0: all of any other
};

/// The floes of a scenario, which an arrangement will give their places; given poses are kept. Throws InputError with
/// the column or the floe at fault if the values of single floes are not those of arrangement.columns.
FloeSet floes_of(const Scenario& scenario, const Draw& draw = {});

/// Whether floes of the scenario can differ from each other or from [floe] and [ice].
bool floes_may_differ(const Scenario& scenario);

/// Whether their sizes can.
bool sizes_may_differ(const Scenario& scenario);

/// Floes of a scenario that are computed at a time: all of them, or about those in the window of a field without end.
double computed_floes(const Scenario& scenario);

/// Of all floes, m².
double covered_area(const FloeSet& floes);

/// Of all floes together; a double, since what a user asks for may be more than any integer.
double element_count(const FloeSet& floes);

/// The largest side of any floe, m.
double largest_side(const FloeSet& floes);

}  // namespace floes
