#pragma once
// A design: cases as points along axes, each axis a key of a scenario. [design] says how the points are chosen and each
// [[design.axis]] along what; every [[case]] is run at every point, and each such pair is a case like any other.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "keys/document.hpp"
#include "keys/read.hpp"

namespace floes {

enum class DesignMethod { none, grid, list, latin_hypercube, sobol };
enum class AxisScale { linear, log };

struct DesignAxis {
    std::string key;            ///< full path of a scenario's key: "ice.thickness_m"
    std::vector<Value> values;  ///< of a grid or a list, in the key's unit
    double from = 0;            ///< of a Latin hypercube or a Sobol sequence, in the key's unit
    double to = 0;              ///< above from
    AxisScale scale = AxisScale::linear;
    bool numeric = true;  ///< the key takes numbers
    bool whole = false;   ///< … whole ones
};

struct Design {
    DesignMethod method = DesignMethod::none;
    int points = 0;  ///< of a Latin hypercube or a Sobol sequence; with indices those of its base
    /// Saltelli's points for first-order and total indices. Base point j of k axes gives the points j (k + 2) + r: A
    /// (r = 0), B (r = 1), and A with axis i from B (r = 2 + i).
    bool indices = false;
    std::vector<DesignAxis> axes;
    std::string points_file;  ///< as it was given, beside the configuration; empty once its points are axes

    bool active() const { return method != DesignMethod::none; }
    /// Its axes have from and to, values of a grid or list otherwise.
    bool has_ranges() const { return method == DesignMethod::latin_hypercube || method == DesignMethod::sobol; }
};

/// The most cases that a design may make.
inline constexpr std::int64_t most_cases = 100'000;

/// Points of the design, most_cases + 1 where they are more; 0 of a list whose axes are not equally long.
std::int64_t point_count(const Design& design);

struct DesignPoint {
    std::string name;           ///< of letters, digits and _ - + . alone, unique in the design
    std::vector<Value> values;  ///< one an axis
};

/// The points of an active design in order, a pure function of its arguments.
///
/// Grid: every combination, the last axis fastest. List: the axes' values side by side. Latin hypercube: each of
/// `points` equal parts of each axis is met once, at random within (M. D. McKay, R. J. Beckman and W. J. Conover,
/// Technometrics 21 (1979) 239-245). Sobol: the sequence with the direction numbers of S. Joe and F. Y. Kuo (Boost),
/// from its first point on, with a random digital shift: without one the first point is a corner, and Saltelli's A and
/// B are the same there (A. B. Owen, "On dropping the first Sobol' point", arXiv:2008.08051). More points of a Sobol
/// design only add at the end. A whole-numbered axis gives each of its numbers an equal share. Numbers have ten digits,
/// so that they do not hang on the last bit of a machine's logarithm.
std::vector<DesignPoint> design_points(const Design& design, std::uint64_t seed);

// From [[design.axis]] blocks to a checked design. For this module only.

/// Where each key was last set, for messages: path -> "table3.toml:12".
using Origins = std::map<std::string, std::string>;

inline constexpr const char* axis_block = "design.axis";

/// Puts the axes of the blocks named axis_block into `design`, whose table has been read, and checks it as a whole:
/// keys of a scenario, each once; values, or from below to, that each key takes; points that the method wants; no more
/// than most_cases points. Gives the axes' places by key. Throws InputError, one sentence.
Origins read_axes(const std::vector<Block>& blocks, const Origins& origins, const std::string& file, Design& design);

}  // namespace floes
