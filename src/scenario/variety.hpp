#pragma once
// What single floes may differ in: their sizes, and their ice.

#include <string>
#include <vector>

#include "laws/factor_law.hpp"
#include "outline/polygon.hpp"
#include "scenario/length_unit.hpp"

namespace floes {

enum class SizeLaw { one, list, lognormal, power_law };  ///< one: all floes are as [floe] says
enum class SharesOf { number, area };                    ///< what shares of a law are shares of
enum class ElementSide { given, of_floe, of_ice };       ///< floe.element_m, or a share of the floe or of its ice

struct ListedSize {
    double length = 0;   ///< m
    double breadth = 0;  ///< m
    double share = 0;    ///< 0 to 1
};

/// Sizes of the floes of every arrangement. D is the side of the square with the floe's area.
struct Sizes {
    SizeLaw law = SizeLaw::one;
    SharesOf by = SharesOf::number;
    std::vector<ListedSize> list{};
    double smallest = 0.4;   ///< D, m, of lognormal and power_law
    double largest = 1.2;    ///< D, m
    double mean = 0.6;       ///< D, m, of lognormal before it is cut off at the smallest and the largest
    double cov = 0.4;        ///< standard deviation of D over its mean, likewise
    double exponent = 2.5;   ///< of power_law: density in proportion to D^-exponent
    double least_ratio = 1;  ///< length over breadth, evenly between these two
    double largest_ratio = 1;
    ElementSide element = ElementSide::given;
    int elements_across = 3;      ///< of_floe: along the shorter side
    double element_share = 0.25;  ///< of_ice: of the characteristic length of [ice]
};

enum class ShapeKind { rectangle, polygon, voronoi, file };  ///< of floes seen from above

/// Outlines that came from a file, which was read once.
struct TracedOutlines {
    std::string path;  ///< empty once its outlines are here
    LengthUnit unit = LengthUnit::m;
    /// Convex, as they lie, m: from x = 0 on and about z = 0, not yet scaled.
    std::vector<Outline> outlines;
    std::vector<double> areas;  ///< of each in the file, m²; empty: they came from none
    std::string names;          ///< of each, divided by commas; empty: the file has none
    double most_added = 0.1;    ///< area that hulls and filled holes may add to a floe, over its own
    double scale = 1;           ///< lengths of floes over those in the file
};

/// Outlines of the floes.
struct Shapes {
    ShapeKind kind = ShapeKind::rectangle;
    int corners = 6;            ///< of polygon
    double irregularity = 0.5;  ///< of polygon: 0 evenly spread corners
    int relaxations = 2;        ///< of voronoi: steps of Lloyd's
    TracedOutlines traced;      ///< of file

    bool from_file() const { return kind == ShapeKind::file; }
    bool any() const { return kind != ShapeKind::rectangle; }
};

/// How one property differs between floes: by a factor on what [ice] or [brine] says.
struct Spread {
    LawKind law = LawKind::none;
    double cov = 0.2;                     ///< before it is cut off
    std::vector<double> within{0.25, 4};  ///< least and largest factor

    FactorLaw factors() const { return {law, cov, within.at(0), within.at(1)}; }
    bool any() const { return law != LawKind::none; }
};

struct IceSpread {
    Spread thickness{};
    Spread strength{};  ///< all strengths by the same factor
    Spread elastic_modulus{};
    Spread density{.cov = 0.01, .within = {0.95, 1.05}};
    Spread salinity{};         ///< of [brine]
    Spread temperature{};      ///< of [brine], in °C
    double correlation = 0;    ///< of the normal variables behind thickness and strength (Gaussian copula)
    double weakened = 0;       ///< share of the floes, each by a draw of its own, that are weaker; 0 to 1
    double weakened_to = 0.6;  ///< factor on all their strengths
    int draw = 0;              ///< number of the draw: another one gives the same arrangements other ice

    bool any() const;
};

/// Where bending strength and modulus come from if not from [ice].
struct Brine {
    double salinity = 0;      ///< in parts; 0: from [ice]
    double temperature = -5;  ///< °C
};

}  // namespace floes
