#pragma once
// All that is fixed for one simulation: Tables 1 and 2 of the paper, and what the paper leaves open, as one value.
// SI units throughout. Keys and ranges: scenario/tables_*.cpp.

#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/vector.hpp"
#include "scenario/laws.hpp"
#include "shapes/elements.hpp"
#include "shapes/moorings.hpp"
#include "shapes/path.hpp"
#include "shapes/polygon.hpp"
#include "shapes/shape.hpp"
#include "solver/contact_law.hpp"
#include "solver/solver_kind.hpp"

namespace floes {

// Sets of contact laws that belong together, docs/convergence.md.

enum class ContactPreset {
    paper,     ///< what Bullet does by default: friction in one direction, rigid contacts, internal edges act
    physical,  ///< friction in the whole contact plane, edges that crush, internal edges do not act
    own        ///< anything else
};

/// The words of the enumerations, in order, for keys, files and reports.
inline constexpr std::array<std::string_view, 3> preset_words{"paper", "physical", "own"};
inline constexpr std::array<std::string_view, 2> friction_words{"one_direction", "cone"};
inline constexpr std::array<std::string_view, 3> slip_effect_words{"constant", "power", "rate_and_state"};
inline constexpr std::array<std::string_view, 2> normal_law_words{"rigid", "crushing"};

/// The law with the choices of the preset; unchanged for `own`.
constexpr ContactLaw with_preset(ContactLaw law, ContactPreset preset) {
    if (preset == ContactPreset::own) return law;
    const bool physical = preset == ContactPreset::physical;
    law.friction = physical ? Friction::cone : Friction::one_direction;
    law.normal = physical ? NormalLaw::crushing : NormalLaw::rigid;
    law.internal_edges = !physical;
    return law;
}

constexpr ContactPreset preset_of(const ContactLaw& law) {
    for (const ContactPreset preset : {ContactPreset::paper, ContactPreset::physical}) {
        if (with_preset(law, preset) == law) return preset;
    }
    return ContactPreset::own;
}

// Units of length in files that do not say theirs.

enum class LengthUnit { m, mm, cm, inch, foot };

inline constexpr std::array<std::string_view, 5> length_unit_words{"m", "mm", "cm", "in", "ft"};

constexpr double metres(LengthUnit unit) {
    constexpr std::array lengths{1.0, 1e-3, 1e-2, 0.0254, 0.3048};
    return lengths.at(static_cast<std::size_t>(unit));
}

// What single floes may differ in: their sizes, and their ice.

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
    /// As they lie, m: from x = 0 on and about z = 0, not yet scaled; they may have bays.
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

    friend auto operator<=>(const Spread&, const Spread&) = default;
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
    /// m: of level ice, over which thickness, strength and modulus vary within the sheet. 0: each floe has one of each
    double length = 0;
    int draw = 0;  ///< number of the draw: another one gives the same arrangements other ice

    bool any() const;
};

/// Where bending strength and modulus come from if not from [ice].
struct Brine {
    double salinity = 0;      ///< in parts; 0: from [ice]
    double temperature = -5;  ///< °C
};

enum class JointModel { cfm, beam };  ///< Σ and Γ, or an elastic beam from centre to centre
/// What is compared with the bending strength: the moment of a joint, Eq. (3), or the stress of its outer fibres.
enum class JointFailure { moment, stress };
/// What floes are cut into: the paper's grid of squares, or cells without a direction (docs/fracture.md).
enum class ElementForm { squares, cells };
/// The point about which the bending moment of Eq. (3) is taken: where the joint is, or the centre of its first
/// element, about which Bullet reports a joint's torque.
enum class MomentAbout { pivot, element_centre };
enum class ThresholdForm { force, as_printed };  ///< of Eqs. (1)-(2): L_e T_e σ, or L_e T_e² σ as the paper prints them
/// How floes get their places; traced: those that they have in shapes.file; level: one sheet is the whole field.
enum class ArrangementMethod { monte_carlo, lattice, file, scattered, traced, level };
enum class ArrangementStart { lattice, stripes };  ///< of the Monte Carlo chain; the result forgets it
/// What stands behind the ice field; never: ice comes from ahead as long as the run lasts.
enum class FarEnd { ice_sheet, open, never };
enum class FieldSides { ice_sheet, open, wall };  ///< what bounds it abeam of the tow
/// Edges at which level ice is frozen to the ice sheets round the field.
enum class LevelHeld { nowhere, far_end, far_end_and_sides };
enum class WaterFlow { potential, still };  ///< water velocity that drag is relative to
/// Where added mass and the damping by waves come from: a share, alike for all elements, or the outline of each piece.
enum class WaterFrom { share, outline };
enum class FormDragOn { outline, every_element };  ///< edge faces that form drag acts on

/// Time stepping and the constraint solver.
struct General {
    double time_step = 0.02;  ///< Δt, s (Table 1)
    int iterations = 500;     ///< projected Gauss-Seidel sweeps a step; direct: over contacts, at most
    /// m/s, of direct: sweeps end after one that changed no contact's velocity by this, for the paper's thickness of
    /// ice; 0: after `iterations`
    double tolerance = 1e-3;
    SolverKind solver = SolverKind::direct;
    double gravity = 9.81;        ///< m/s²
    double runaway_speed = 10.0;  ///< m/s; an element faster than this ends the member as failed
};

/// The ice of a floe, without its joints (Table 1).
struct Ice {
    double density = 930.0;                 ///< ρ_i, kg/m³
    double bending_strength = 36.4e3;       ///< σ_b, Pa
    double compressive_strength = 145.6e3;  ///< σ_c, Pa
    double shear_strength = 72.8e3;         ///< σ_s, Pa
    double tensile_strength = 0;            ///< Pa; 0: by moment no criterion (the paper has none), by stress σ_b
    double torsion_strength = 0;            ///< Pa; 0: no criterion
    double in_plane_bending_strength = 0;   ///< Pa; 0: no criterion
    double elastic_modulus = 60e6;          ///< E, Pa; of joints that follow Σ it is what a plate test shows
    double poisson_ratio = 0.3;             ///< ν, of beam joints
    double fracture_energy = 0;             ///< G_f, J/m², of joints that fail by stress; 0: they lose all at once

    friend auto operator<=>(const Ice&, const Ice&) = default;
};

/// Elements of floes with beam joints; others are cut into squares.
struct Elements {
    ElementForm form = ElementForm::cells;
    int draw = 0;  ///< of the cells' points
};

/// A sheet of ice, made of elements of its own thickness (Table 1).
struct FloeShape {
    double length = 0.6;       ///< L_i along the floe's own x, m
    double breadth = 0.6;      ///< B_i along the floe's own z, m
    double thickness = 0.033;  ///< T_i = T_e, m
    double element = 0.2;      ///< L_e, m; squares divide length and breadth
    /// About its centroid, in the floe's own axes; length and breadth are its extents then. Empty: a rectangle.
    Outline outline{};
    int pattern = squares;  ///< which draw of cells it is cut into; rectangles alone may be cut into squares

    static constexpr int squares = -1;

    /// Squares along x and along z, at least 1.
    int elements_long() const { return static_cast<int>(std::lround(length / element)); }
    int elements_broad() const { return static_cast<int>(std::lround(breadth / element)); }
    double elements() const;                                                               ///< of the whole floe
    double area() const { return outline.empty() ? length * breadth : area_of(outline); }  ///< m²
    bool is_polygon() const { return !outline.empty(); }
    bool has_squares() const { return pattern == squares && !is_polygon(); }
    Outline corners() const;  ///< of its outline, of a rectangle as well
    Outline hull() const;     ///< the same without bays, which is how floes are laid beside each other
    /// Its elements and joints.
    CutFloe cut() const;
    double element_mass(const Ice&) const;  ///< of a square of ice, kg
    double element_mass(const Ice&, const CutElement&) const;
    /// Height of the middle of the floe above the water at rest, m; negative above half draught. Density of the water:
    /// kg/m³.
    double floating_height(const Ice&, double water_density) const;

    friend auto operator<=>(const FloeShape&, const FloeShape&) = default;
};

/// The fixed joints between elements.
struct Joint {
    JointModel model = JointModel::beam;
    double cfm = 0.016;                           ///< Σ, Bullet's relative number (docs/fracture.md); below 1
    double erp = 0.8;                             ///< Γ (Table 1)
    double damping_ratio = 0.05;                  ///< of beam joints, of critical
    double averaging = 0;                         ///< s, of the stress that cracks; 0: Scenario::stress_averaging()
    JointFailure failure = JointFailure::stress;  ///< of beam joints; others fail by moment
    ThresholdForm threshold_form = ThresholdForm::force;
    MomentAbout moment_about = MomentAbout::pivot;

    bool fails_by_stress() const { return model == JointModel::beam && failure == JointFailure::stress; }

    friend auto operator<=>(const Joint&, const Joint&) = default;
};

/// How the ice varies within a floe: factors on thickness, strengths and modulus where a joint is
/// (scenario/varied_ice.hpp).
struct IceVariation {
    double length = 0;  ///< m, of correlation; 0: it does not
    std::uint64_t seed = 0;
    std::uint32_t arrangement = 0;
    std::uint64_t draw = 0;
    Spread thickness{};
    Spread strength{};
    Spread elastic_modulus{};
    double correlation = 0;  ///< of the normal fields behind thickness and strength

    friend auto operator<=>(const IceVariation&, const IceVariation&) = default;
};

/// All that a floe is made of.
struct Material {
    Ice ice;
    Joint joint;
    IceVariation variation{};

    friend auto operator<=>(const Material&, const Material&) = default;
};

/// The channel and the ice field in it.
struct Field {
    int floes = 189;              ///< number of floes
    double concentration = 0.75;  ///< IC, covered fraction of the field (Table 1)
    double begin = 6.0;           ///< x of the field's near edge, m
    double half_width = 2.4;      ///< the field lies in |z| <= half_width, m (between the wall ice sheets)
    double sheet_width = 1.0;     ///< breadth of the fixed ice sheets along the walls and at the far end, m
    FarEnd far_end = FarEnd::ice_sheet;
    FieldSides sides = FieldSides::ice_sheet;
    double confining = 0;      ///< p, N/m: line load by which the ice sheets press on the field; 0: they are fixed
    double closing_speed = 0;  ///< m/s, of a sheet that meets nothing; 0: Scenario::drift()
    double wake_radius = 0;    ///< m from the structure's axis; untouched floes beyond it are at rest. 0: none are
    /// m; of a field without end, floes farther ahead of the structure's axis rest. 0: Scenario::window_ahead()
    double ahead = 0;
    double behind = 0;  ///< m; likewise, floes farther behind it are taken out. 0: Scenario::window_behind()
    LevelHeld level_held = LevelHeld::far_end;  ///< of ArrangementMethod::level
    bool level_pushed = false;                  ///< the structure rests, and what holds the sheet moves

    bool endless() const { return far_end == FarEnd::never; }
};

/// How the initial positions of the floes are generated.
struct ArrangementRule {
    ArrangementMethod method = ArrangementMethod::scattered;
    ArrangementStart start = ArrangementStart::lattice;
    double clearance = 0.002;       ///< least gap kept between floes, and to walls, m
    int sweeps = 20000;             ///< Monte Carlo sweeps with the frozen step size
    int ordering_sweeps = 0;        ///< scattered: Monte Carlo sweeps after scattering
    double jitter = 0;              ///< lattice: largest random shift, m
    double jitter_angle = 0;        ///< lattice: largest random turn, rad
    std::string file;               ///< method file: CSV that the poses come from; empty once they are in `poses`
    std::vector<PlanarPose> poses;  ///< method file: one pose a floe
    /// Method file: keys of [floe], [ice] and [joint] that each floe has values of its own for, as in the header of
    /// arrangement.file: "ice.thickness_m,floe.length_m". Empty: all floes are as these tables say.
    std::string columns;
    std::vector<std::vector<double>> values;  ///< of each floe, in the order of `columns` and in the units of the keys

    bool level() const { return method == ArrangementMethod::level; }
    /// Every arrangement is the same, and the places of its floes are input.
    bool given() const { return method == ArrangementMethod::file || method == ArrangementMethod::traced || level(); }
};

enum class HullAxis { plus_x, minus_x, plus_y, minus_y, plus_z, minus_z };  ///< of a file

/// How a CAD file becomes a hull. It is read once; the shape's pieces are the truth from then on.
struct HullFile {
    std::string path;  ///< empty once its pieces are in the shape
    LengthUnit unit = LengthUnit::m;
    HullAxis up = HullAxis::plus_z;
    HullAxis forward = HullAxis::plus_x;
    double waterline = 0;      ///< height of the waterline along `up` in the file, m
    double most_added = 0.05;  ///< volume that pieces may add to the hull, over its own
    double volume = 0;         ///< of the hull in the file, m³; 0: it came from none
};

/// The towed structure.
struct Structure {
    Shape shape;  ///< Table 2
    HullFile hull_file;
    double start = 2.0;   ///< x of the axis at t = 0, m
    double speed = 0.07;  ///< V, m/s (Table 1)
};

/// Hydrostatics and hydrodynamics of an element; sources in scenario/tables_field.cpp.
struct Water {
    double density = 1000.0;  ///< ρ_w, kg/m³ (Table 1)
    WaterFlow flow = WaterFlow::potential;
    double form_drag = 1.0;  ///< C_d on the wetted edge faces that meet the flow
    FormDragOn form_drag_on = FormDragOn::outline;
    double shelter_draughts = 5.56;  ///< over which ice ahead shelters an edge, in its draughts; 0: no ice does
    double skin_drag = 0.009;        ///< C_s on the bottom face
    double heave_drag = 1.0;         ///< C_h, quadratic, on vertical motion
    WaterFrom heave_damping_from = WaterFrom::outline;
    double heave_damping = 0.15;  ///< linear, as a fraction of critical damping of an element's heave
    WaterFrom added_mass_from = WaterFrom::outline;
    double added_mass = 0.0;           ///< water that an element carries along in every direction, over its mass
    double added_mass_in_plane = 0.1;  ///< likewise along the surface, of an outline

    double current = 0;            ///< speed of the current, m/s; ice that lies still moves with it
    double current_direction = 0;  ///< towards which it flows, rad: 0 along the tow, π/2 towards +z
    double turning = 0;  ///< θ, rad: skin drag is turned by it, anticlockwise from above, as seen from the ice

    double depth = 0;           ///< of the bed below the structure's start, m; 0: there is none
    double bed_slope = 0;       ///< angle by which it rises along +x, rad
    double bed_friction = 0.3;  ///< Coulomb's coefficient of ice on it

    bool has_bed() const { return depth > 0; }
    Vec2 current_velocity() const;  ///< along x and z, m/s
    double isotropic_mass() const { return added_mass_from == WaterFrom::share ? added_mass : 0.0; }
};

/// The wind, on ice above the water.
struct Wind {
    double speed = 0;           ///< U, m/s, at the height to which the drag coefficient belongs
    double direction = 0;       ///< towards which it blows, rad: 0 along the tow, π/2 towards +z
    double drag = 1.5e-3;       ///< C_a: the air's stress is ρ_a C_a U²
    double air_density = 1.25;  ///< ρ_a, kg/m³

    Vec2 stress() const;  ///< on ice, along x and z, Pa
};

/// The window in which the load is measured. It ends the run.
struct Analysis {
    double steady_start = 120.0;              ///< s after the tow begins
    double window = 150.0;                    ///< s
    int segments = 3;                         ///< equal parts of the window, one maximum each
    bool keep_history = true;                 ///< a member keeps its load over time, not only the statistics of it
    int history_stride = 1;                   ///< successive steps whose mean is one value of the kept load
    std::vector<double> exceedance_levels{};  ///< N, rising; a member counts its steps above each
    std::vector<double> averaging{0.1, 0.5, 1, 2};  ///< s, rising: times that the load is averaged over
    double peak_separation = 5;                     ///< s, between peaks of the averaged load that count as two
};

/// What is open to ice between the structure and the bank, the ice sheet on either side of it.
struct BankGap {
    double breadth = 0;  ///< m, at the waterline
    double floes = 0;    ///< the same in sides of a floe: of the square of their mean area
};

struct Scenario {
    General general;
    Ice ice;
    FloeShape floe;
    Elements elements;
    Joint joint;
    Field field;
    ArrangementRule arrangement;
    Structure structure;
    Path path;          ///< of the structure, if not the straight tow; with moorings of where these would have it
    Moorings moorings;  ///< none: it moves as prescribed
    ContactLaw contact = with_preset({}, ContactPreset::physical);
    Water water;
    Wind wind;
    Analysis analysis;
    Sizes sizes;
    Shapes shapes;
    IceSpread spread;
    Brine brine;

    /// m: covered area / (concentration * 2 half_width); of level ice that of the sheet or, without end, of its window
    double field_length() const;
    double field_end() const { return field.begin + field_length(); }  ///< x of the field's far edge, m
    /// Of the moored hull, by Motion: N/m, N, N m; nothing where it neither heaves nor pitches nor rolls.
    Mat6 water_stiffness() const;
    /// Time over which stress is averaged before it meets the strength, s: joint.averaging, or its default, a tenth of
    /// √(l/g), l = (E T³/(12 (1 - ν²) ρ_w g))^(1/4) of the plate on water (docs/fracture.md).
    double stress_averaging() const;
    Ice mean_ice() const;  ///< [ice], with strengths and modulus of [brine] where that says them
    /// L_c = (E T³/(12 (1 - ν²) ρ_w g))^(1/4) of that ice on the scenario's water, m.
    double characteristic_length() const;
    int stress_steps() const;  ///< the same in steps, at least 1
    /// Of a field without end: field.ahead, or its default, m: two widths of the field; in level ice the structure's
    /// radius and eight characteristic lengths.
    double window_ahead() const;
    double window_behind() const;  ///< likewise field.behind: a width; its radius and four characteristic lengths
    /// Of the structure past ice at rest, m/s: on a path the mean while it moves, without one, or on one that never
    /// moves, that of the tow.
    double drift() const;
    double closing_speed() const { return field.closing_speed > 0 ? field.closing_speed : drift(); }  ///< m/s
    bool towed_straight() const { return !path.any() && !moorings.give_way(); }
    /// Where the structure starts; none where the sides are open, in level ice, where a path takes it elsewhere, or
    /// where it is as broad as the channel.
    std::optional<BankGap> gap() const;
    std::vector<PathPlace> places() const;  ///< of a path, places_of() it; empty without one
    double first_yaw() const;               ///< of the structure, rad; 0 without a path
    double reach() const;                   ///< m, how far ahead of its start it comes, without its moorings
    double towed() const;                   ///< m, how far the structure goes in a run, along its path
    Material material() const { return {ice, joint, {}}; }  ///< of floes that have no other
    bool has_cells() const { return elements.form == ElementForm::cells && joint.model == JointModel::beam; }
    /// FloeShape::pattern of a floe by its number: a stock of them, taken in turn.
    int pattern_of(std::size_t floe) const;
    int pattern_of_sheet(std::uint32_t arrangement) const;  ///< of level ice: one of each arrangement's own
    ContactLaw contact_law() const {
        return contact_law(mean_ice());
    }                                             ///< contact, with the crushing pressure in force
    ContactLaw contact_law(const Ice& of) const;  ///< for such ice
    /// Averaging times that are measured, s: those given; of the default, only whole steps that fit into a segment.
    std::vector<double> averaging_times() const;
    /// Whether the time is whole steps, at least one, and fits into a segment.
    bool is_averaging_time(double time) const;
    int step_count() const;  ///< steps of a run: (steady_start + window) / time_step, rounded
    /// Index of the first step inside the window.
    int first_window_step() const { return static_cast<int>(std::lround(analysis.steady_start / general.time_step)); }
};

}  // namespace floes
