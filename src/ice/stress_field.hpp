#pragma once
// What a lattice of elements does not show of a load: the stress right below a contact. A joint's moment is a mean over
// the size of an element, but below a small contact the stress of a plate grows as the logarithm of the contact's size
// (theory/plate.hpp). The difference between the patch that a joint feels and the contact's own size b₀ is added:
//
//   Δσ = C log10(b_L / b₀),   C = stress per decade, at an edge or inside
//
// b_L is the radius of the circle below which the formula has the stress that the joint shows: a constant times the
// element's size, less the nearer the contact is to the joint (docs/fracture.md). Near a second free edge, a corner,
// the logarithm ends at the distance to it.

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "ice/joint_stress.hpp"
#include "shapes/polygon.hpp"
#include "world/world.hpp"

namespace floes {

/// A contact force on an element, in the axes of its floe.
struct Press {
    double x = 0;  ///< of the contact, from the middle of the element, m
    double z = 0;
    double down = 0;  ///< N, along -y
};

/// b_L over the side of a square of the element's area, for a contact level with the middle of an element, and the
/// decades by which it shrinks for each span that the contact is nearer to the joint.
struct FeltPatch {
    double share, decades;

    /// m; `towards`: the contact from the middle of the span to the joint.
    double radius(double size, double towards, double span) const {
        return share * size * std::pow(10, -decades * towards / span);
    }
};
struct FeltPatches {
    FeltPatch at_edge, inside;
};

// A load on a node of a lattice shows the sum of moments that the plate has on a circle: of a square grid e^-γ/√8 times
// the side, of one of hexagons e^-γ/√12 times the distance of their centres, 0.88 times as much for the same area
// (Peaceman's radius by which a well is joined to its cell, SPE Journal 18, 1978; from memory). The rest is fitted to
// Westergaard's formula (docs/fracture.md): a rim crosses joints in every direction, so more of them.
inline constexpr FeltPatches square_patch{{0.6, 0.66}, {1.0, 0.92}};
inline constexpr FeltPatches cell_patch{{0.64, 0.66}, {0.80, 0.92}};

/// Powers of ten from one radius to a larger one; 0 if it is not larger.
inline double decades(double from, double to) {
    return to > from ? std::log10(to / from) : 0.0;
}

// The ice below the contact has Westergaard's stress whatever the elements are, so what a joint lacks of it is the same
// logarithm, from the contact to the circle b_L that its grid feels:
//
//   inside   in every direction, up to the nearest free edge
//   at it    along that edge, from there on
//
// Where the edge ends at another free one, a corner that turns by φ, the logarithm goes on with √(max(0, cos φ)): as
// ever along a straight rim, not at all at the corner of a square, where the moment below a load is finite. In between
// it is a fit: below a load on a corner of 120° grids of any elements then have the same stress (docs/fracture.md).

/// A joint as one of its elements has it, in the axes of the floe from the element's centroid. SI.
struct ElementJoint {
    Corner outward;    ///< of length 1
    Corner pivot;      ///< halfway between the centroids of the two elements
    double length;     ///< of the common edge
    double span;       ///< between the centroids
    double thickness;  ///< of the ice there
    unsigned edge;     ///< bit of the element's edge that it holds
    bool live = true;  ///< or the edge is free there
};

/// An element as a contact meets it. SI.
struct PressedElement {
    Outline corners;  ///< in the axes of the floe, about the centroid
    double area = 0;
    FeltPatches patch = cell_patch;
    double poisson_ratio = 0;
    double crushing_pressure = 0;  ///< above 0: a force crushes a circle of this pressure
    double least_joint = 0;        ///< an edge up to this long between two joints that hold has ice beyond it
    std::vector<ElementJoint> joints{};
};

/// What a contact adds at a joint of its element; nothing if another joint within 45 degrees of its direction is
/// nearer, since one crack forms below a contact. `press`: in the axes of the floe from the centroid.
std::optional<LocalStress> contact_stress(const PressedElement& element, const Press& press, std::size_t joint);

/// The most that a force of 1 N can add at any joint of an element that has some, its shear included, wherever it acts,
/// Pa.
double most_contact_stress(const PressedElement& element);

// What acts at every joint of all floes: its reaction, the mean moment and force of its two elements across it, and the
// stress by contacts on them. The means follow from what acts on an element's faces, f_k at x_k, as that of a stress
// does: A N = Σ f_k ⊗ x_k (divergence theorem). All are averaged over the world's last steps, of which those before a
// joint was made count as nothing.

class StressField {
  public:
    /// Averages over this many steps, at least 1. For this many elements reading then allocates nothing unless contacts
    /// are very many.
    StressField(std::size_t steps, std::size_t elements);

    /// Elements and joints are numbered from 0 in the order in which they are put in. One that comes under the number
    /// of another takes its place, and the body of an element, whose joints have been removed. `axis`: the element's
    /// own x axis in the axes of its floe. The joints are put in, not given with the element.
    void put_element(std::size_t number, BodyId body, const Corner& axis, PressedElement element);
    void put_joint(std::size_t number, JointId id, std::size_t a, const ElementJoint& at_a, std::size_t b,
                   const ElementJoint& at_b);

    void remove_joint(std::size_t joint);

    /// Reads the reactions of the live joints and the contacts. To be called once after a step.
    void read(const World& world);

    const JointReaction& reaction(std::size_t joint) const { return reactions_[joint]; }

    /// JointLoad::across, N m.
    double across(std::size_t joint) const;

    /// A bound of what contacts add to any tension at the joint, Pa.
    double most_by_contacts(std::size_t joint) const;

    /// Costs much more than the two above.
    JointLoad load(std::size_t joint) const;

    void archive(StateArchive& state);  ///< core/state_archive.hpp

  private:
    static constexpr std::size_t none = ~std::size_t{0};
    static constexpr std::uint32_t no_touch = ~std::uint32_t{0};

    struct Joint {
        JointId id;
        std::size_t a, b;
        std::size_t on_a, on_b;  ///< its number among the joints of either element
        // Of these ElementJoint what every step reads, side by side:
        Corner outward;  ///< of a
        Corner pivot_a, pivot_b;
        double length;
    };
    /// A symmetric tensor in the axes of a floe.
    struct Tensor {
        double xx = 0, zz = 0, xz = 0;

        void add(const Corner& force, const Corner& at) {
            xx += force.x * at.x;
            zz += force.z * at.z;
            xz += 0.5 * (force.x * at.z + force.z * at.x);
        }
        double along(const Corner& t) const { return xx * t.x * t.x + zz * t.z * t.z + 2 * xz * t.x * t.z; }
    };
    struct Element {
        PressedElement ice;
        BodyId body;
        Corner axis;                        ///< own x axis in the axes of the floe
        std::vector<std::size_t> joints{};  ///< of all, by their numbers among the element's
        int live = 0;                       ///< of them
    };
    /// What every step reads of an element.
    struct Within {
        double area = 0;           ///< m²
        double most_stress = 0;    ///< by a force of 1 N, Pa
        Tensor moment{}, force{};  ///< times the area, by its joints, N m² and N m
    };
    /// A contact as an element feels it in the axes of its floe, and the next one of the same element.
    struct Touch {
        Corner at;     ///< m from the centroid
        Corner force;  ///< N
        double down;   ///< N
        std::uint32_t next = no_touch;
    };
    struct Touched {
        double largest_force = 0;  ///< N
        std::uint32_t first = no_touch, last = no_touch;
    };
    /// What one step brought.
    struct Step {
        std::vector<JointReaction> reactions{};  ///< by joint
        std::vector<Touched> elements{};         ///< by element
        std::vector<Touch> touches{};
        std::vector<std::size_t> touched{};  ///< elements, by number
    };
    void touch(Step& step, const World& world, BodyId body, const ContactForce& contact, bool on_a) const;
    std::size_t join(std::size_t element, std::size_t joint, const ElementJoint& at);
    JointReaction average(std::size_t joint) const;
    void spread(const Joint& joint, const JointReaction& reaction);

    std::vector<Element> elements_;
    std::vector<Within> within_;  ///< by element
    std::vector<Joint> joints_;
    std::vector<bool> live_;
    std::vector<JointReaction> reactions_;      ///< averaged
    std::vector<std::size_t> element_of_body_;  ///< none: not an element
    std::vector<Step> steps_;
    std::size_t last_ = 0;                ///< of them
    std::vector<ContactForce> contacts_;  ///< of that step
};

}  // namespace floes
