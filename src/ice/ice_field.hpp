#pragma once
// All floes of a run: their elements and joints in a World, and how they break.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <ranges>
#include <span>
#include <vector>

#include "core/vector.hpp"
#include "ice/failure.hpp"
#include "ice/failure_mode.hpp"
#include "ice/stress_field.hpp"
#include "scenario/floes.hpp"
#include "scenario/scenario.hpp"
#include "shapes/elements.hpp"
#include "world/world.hpp"

namespace floes {

// The empty world of a scenario, the common start of a tow and of a laboratory test.

/// Thickness of the scenario's ice over that of the paper's tank, 0.033 m: the scale of lengths that have no key.
double size_of_ice(const Scenario& scenario);

/// Time step, iterations, solver, gravity and contacts are those of the scenario; the unit of length is the size of its
/// ice, so that Bullet's margins keep their share of the thickness. Throws InputError for values that World refuses.
World scenario_world(const Scenario& scenario);

/// How IceField numbers the elements and joints of floes: floe by floe, within a floe as its CutFloe has them.
struct IceLayout {
    struct LaidElement {
        int floe = 0;
        Vec3 half_extents = Vec3::Zero();  ///< m
        std::uint32_t outline = 0;         ///< bit k: edge k lies on the outline of the floe
        Outline corners{};                 ///< in its own x and z, m
        bool square = true;
    };
    struct LaidJoint {
        int a = 0;
        int b = 0;
        std::uint32_t edge_a = 0;  ///< bit of the edge of a that it holds
        std::uint32_t edge_b = 0;
    };

    explicit IceLayout(const FloeSet& floes);

    std::vector<LaidElement> elements;
    std::vector<LaidJoint> joints;
    std::vector<std::size_t> first_joint;  ///< of each floe, and the number of all

    int floes() const { return static_cast<int>(first_joint.size()) - 1; }

    /// The floe of the joint with this index.
    std::size_t floe_of_joint(std::size_t index) const {
        return static_cast<std::size_t>(std::ranges::upper_bound(first_joint, index) - first_joint.begin()) - 1;
    }

    /// Index of a floe's joint by its number in its CutFloe, as the break log has it.
    std::size_t joint(int floe, int number) const {
        return first_joint[static_cast<std::size_t>(floe)] + static_cast<std::size_t>(number);
    }
};

//   IceField ice(world, scenario, floes);
//   ... world.step();  ice.break_joints(world, time);

struct IceElement {
    BodyId body;
    int floe = 0;                     ///< index of its floe in the arrangement
    int index = 0;                    ///< within its floe, as its CutFloe has it
    int piece = 0;                    ///< index in IceField::elements() of the first element of its connected piece
    std::uint32_t exposed_edges = 0;  ///< with form drag, water.form_drag_on: bit k for edge k
};

class IceField {
  public:
    /// Puts each floe at its pose, flat at its floating height: its middle is T/2 above its lower face, and the draught
    /// is T ρ_i/ρ_w. Creates the elements of a floe, then its joints, floe by floe; every floe is one
    /// piece. Of the scenario it takes the water and what the paper leaves open, not the ice.
    IceField(World& world, const Scenario& scenario, const FloeSet& floes);

    /// A floe more, in the place of one of as many elements that has left, or behind all others if there is none.
    /// Returns its place: the index by which elements() and the functions below know it.
    int enter(World& world, const Scenario& scenario, const SingleFloe& floe);

    /// Joins floes that are elements of one sheet (FieldPart): numbers of floes in the order of entry, those of `a`
    /// that entered last. All lie as they were laid, or are moved by one way along x. `of`: the ice of the sheet. From
    /// now on pieces may be of many floes.
    void join(World& world, const SingleFloe& of, std::span<const CutJoint> joints);

    /// Freezes the straight edge of the floe at this place, whose outward normal is along one of the world's axes, to a
    /// body that nothing moves: each rim element there is held as by a clamp at the edge. These joints never fail; the
    /// next ones towards the middle do. Of beam joints.
    void hold_edge(World& world, const SingleFloe& floe, int place, BodyId support, const Vec3& outwards);

    /// Force of the ice on what holds its edges, or on floes at rest to which it is joined, in the world's last step,
    /// N, along the world's axes at the start.
    Vec3 force_on_supports(const World& world) const;

    /// Places of the floes, not at rest, of which nothing lies at x or farther ahead, m; given the states of all
    /// elements. Of a sheet: of pieces that lie behind as a whole, and of what is joined to floes at rest whatever
    /// does.
    std::vector<int> behind(std::span<const BodyState> states, double x) const;

    /// Takes the floes at these places out of the world; the counts below keep them.
    void leave(World& world, std::span<const int> places);

    /// A floe at rest does not fail, and nor do its joints crack.
    void set_resting(int place, bool rests) { floes_[static_cast<std::size_t>(place)].rests = rests; }

    bool rests(int place) const { return floes_[static_cast<std::size_t>(place)].rests; }

    /// Whether floes are the elements of a sheet.
    bool is_sheet() const { return sheet_; }

    /// Where an element's centroid is in the axes that its piece was cut in, m.
    Corner centre(const IceElement& element) const {
        return cut_element(element).centre + floes_[static_cast<std::size_t>(element.floe)].laid;
    }

    bool is_there(int place) const { return floes_[static_cast<std::size_t>(place)].there; }

    /// Where the floe is that was the `number`-th to enter, from 0: as the break log knows it. It is there.
    int place_of(int number) const;
    int number_of(int place) const { return floes_[static_cast<std::size_t>(place)].number; }
    bool is_broken(int place) const { return floes_[static_cast<std::size_t>(place)].broken; }

    /// The index in elements() of the element with this body; nothing for a body that is no ice.
    std::optional<std::size_t> element_of(BodyId body) const;

    /// All elements, floe by floe, within a floe by index; those of a place without a floe are of the last one there.
    const std::vector<IceElement>& elements() const { return elements_; }

    /// To be called after every step of the world, which must be the one given to the constructor. Every joint whose
    /// reaction exceeds a threshold fails and is removed, or begins to crack and fails when the crack is open; pieces,
    /// exposed edges, the break log and the peaks are updated. `time`: end of the step, s. Returns the number of joints
    /// that failed.
    int break_joints(World& world, double time);

    /// Refills `worst` with the largest utilisation of the live joints of each element, in the order of elements(); 0
    /// without any. Of the world's last step. A joint that cracks has 1 and the share of its stiffness that is gone.
    void read_utilisation(const World& world, std::vector<double>& worst) const;

    /// Power that the joints gave to the ice in the world's last step, W: their reactions times how the elements moved,
    /// given the states at the step's beginning and the velocities (m/s, rad/s) of each element, in the order of
    /// elements(). To be called before break_joints().
    double joint_power(const World& world, std::span<const BodyState> before, std::span<const Vec3> velocity,
                       std::span<const Vec3> angular_velocity) const;

    /// Repeats the breaks of another run over the same floes: removes their joints and copies them to the log
    /// unchanged.
    void repeat_breaks(World& world, std::span<const BreakEvent> breaks);

    const std::vector<BreakEvent>& breaks() const { return breaks_; }  ///< by time, then floe, then joint
    const PeakReactions& peaks() const { return peaks_; }              ///< of all steps, failing joints included

    /// The elements and joints of a floe.
    const CutFloe& cut(int floe) const { return *floes_[static_cast<std::size_t>(floe)].cut; }
    const CutElement& cut_element(const IceElement& element) const {
        return cut(element.floe).elements[static_cast<std::size_t>(element.index)];
    }
    int elements(int floe) const { return floes_[static_cast<std::size_t>(floe)].elements(); }
    int first_element(int floe) const { return floes_[static_cast<std::size_t>(floe)].first; }  ///< in elements()
    /// Where the elements of the floe at this place are in elements().
    auto indices(int place) const {
        const auto first = static_cast<std::size_t>(first_element(place));
        return std::views::iota(first, first + static_cast<std::size_t>(elements(place)));
    }

    int places() const { return static_cast<int>(floes_.size()); }
    int floes() const { return entered_; }                                   ///< that are there or have left
    int broken_floes() const;                                                ///< floes with at least one failed joint
    double failure_ratio() const { return share_of_floes(broken_floes()); }  ///< 0-1
    int split_floes() const;                                                 ///< floes in more than one piece
    int cracked_floes() const;  ///< floes of which a joint reached its strength, whether or not it failed
    double fracture_work() const { return fracture_work_; }  ///< J, that cracks have taken, of joints that soften
    double share_of_floes(int some) const { return entered_ == 0 ? 0.0 : static_cast<double>(some) / floes(); }
    int pieces() const;  ///< of all floes
    /// Pieces of the floes in more than one piece, by floe, as the break log knows it.
    std::vector<PieceArea> piece_areas() const;
    int live_joints() const { return static_cast<int>(joints_.size()); }

    /// Everything that the next steps depend on, saved or set (core/state_archive.hpp). Where it is set and floes have
    /// entered or left, what is at each place is to be given anew.
    void archive(StateArchive& state);
    void set_floe(int place, const SingleFloe& floe);

  private:
    struct Joint {
        JointId id;
        int floe;           // its place
        int number;         // in the floe
        int a, b;           // elements, in elements_; b may be of another floe of the sheet
        std::size_t place;  // among all joints ever made
        std::optional<Crack> crack{};

        void archive(StateArchive& state);
    };

    /// A floe as its elements and joints need it.
    struct Sheet {
        int first;   // of its elements
        int number;  // in the order of entry
        std::shared_ptr<const CutFloe> cut;
        std::vector<JointStrength> strength{};  // of the joints, by number
        std::vector<std::size_t> joints{};      // likewise, which of those ever made
        std::vector<CutJoint> outer{};          // to others of its sheet, from element 0; pivots in its own axes
        Corner laid{};                          // where it was laid, m
        bool cracked = false;
        bool broken = false;
        bool there = true;
        bool rests = false;

        int elements() const { return static_cast<int>(cut->elements.size()); }
        void archive(StateArchive& state);
    };

    /// What floes that have left leave behind.
    struct Left {
        int broken = 0, split = 0, cracked = 0, pieces = 0;
        std::vector<PieceArea> areas{};  // of those in more than one piece
    };

    /// How far a joint is turned out of the plane, bending and torsion together, and how fast that grows.
    struct Turned {
        double angle = 0;  ///< rad
        double rate = 0;   ///< rad/s
    };
    Turned turned(const World& world, const Joint& joint) const;

    /// Whether the joint fails now, and how; it may begin to crack, or crack on.
    std::optional<FailureMode> failing(World& world, Joint& joint);
    std::optional<FailureMode> crack_on(World& world, Joint& joint);

    int pieces_at(const Sheet& sheet) const;
    /// Which of elements_ are first elements of a piece that is joined to floes at rest.
    std::vector<bool> held_pieces() const;
    std::map<int, double> loose_pieces(std::span<const int> places) const;
    std::vector<int> all_places() const;
    void regroup(World& world, std::size_t first, std::size_t count);
    void add_piece_areas(const Sheet& sheet, std::vector<PieceArea>& areas) const;
    void add_floe(World& world, const Scenario& scenario, const SingleFloe& floe, std::shared_ptr<const CutFloe> cut);
    void put_element(World& world, std::size_t at, const IceElement& element, const ElementDefinition& definition);
    void add_joint(World& world, int place, int a, int b, const JointDefinition& definition);
    void feel(const Joint& joint);
    /// The axes of its floe as an element has them; floe -> world.
    Mat3 floe_axes(int element, const BodyState& state) const;
    const IceElement& at(int element) const { return elements_[static_cast<std::size_t>(element)]; }
    const Sheet& floe_of(const Joint& joint) const { return floes_[static_cast<std::size_t>(joint.floe)]; }
    const JointStrength& strength_of(const Joint& joint) const {
        return floe_of(joint).strength[static_cast<std::size_t>(joint.number)];
    }
    const CutJoint& cut_joint(const Joint& joint) const {
        const Sheet& sheet = floe_of(joint);
        return (sheet_ ? sheet.outer : sheet.cut->joints)[static_cast<std::size_t>(joint.number)];
    }
    void fail(World& world, const Joint& joint, const BreakEvent& event);
    void split_broken(World& world, std::size_t first_break);
    void expose_edges(const Joint& joint);

    std::vector<Sheet> floes_;
    std::vector<IceElement> elements_;
    std::vector<std::size_t> element_of_body_;
    std::vector<JointId> joint_ids_;  // of all ever made
    struct Support {
        JointId joint;
        Quat axes;  // joint -> world
    };
    std::vector<Support> supports_;         // joints to bodies that hold an edge
    std::vector<std::size_t> free_joints_;  // of these, joints of floes that have left; the first last
    int entered_ = 0;
    bool sheet_ = false;
    Left left_;
    std::vector<Joint> joints_;  // live, in order of creation
    std::vector<BreakEvent> breaks_;
    PeakReactions peaks_;
    double time_step_;
    std::optional<StressField> stress_;  // where joints fail by stress
    std::vector<std::size_t> failed_;    // in this step, still in stress_
    double fracture_work_ = 0;
};

}  // namespace floes
