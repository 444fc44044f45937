#pragma once
// What acts at every joint of all floes in the world's last step: its reaction, the moments beside it, and the stress
// by contacts on its elements.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "ice/contact_stress.hpp"
#include "ice/floe_grid.hpp"
#include "ice/joint_stress.hpp"
#include "ice/prism_stress.hpp"
#include "world/world.hpp"

namespace floes {

class StressField {
  public:
    /// For this many elements reading then allocates nothing unless contacts are very many.
    void reserve(std::size_t elements);

    /// Elements and joints are numbered from 0 in the order in which they are added.
    void add_element(BodyId body, const PressedElement& element);
    void add_joint(JointId id, std::size_t a, std::size_t b, JointAxis axis);

    /// The same of a polygon, at the end or, under the number and the body of one whose joints have been removed, in its
    /// place. `axis`: the element's own x axis in the axes of its floe. The joints are put in, not given with the prism.
    void put_prism(std::size_t number, BodyId body, const Corner& axis, PressedPrism prism);
    void put_prism_joint(std::size_t number, JointId id, std::size_t a, const PrismJoint& at_a, std::size_t b,
                         const PrismJoint& at_b);

    void remove_joint(std::size_t joint);

    /// Another element under the number, and the body, of one whose joints have been removed; and another joint between
    /// the same two elements.
    void put_in(std::size_t number, const PressedElement& element);
    void put_in_joint(std::size_t number);

    /// Reads the reactions of the live joints and the contacts. To be called once after a step.
    void read(const World& world);

    const JointReaction& reaction(std::size_t joint) const { return reactions_[joint]; }

    /// Mean bending moment of the joints beside it, N m: JointLoad::across.
    double across(std::size_t joint) const;

    /// A bound of what contacts add to any tension at the joint, Pa.
    double most_by_contacts(std::size_t joint) const;

    /// Costs much more than the two above. `world`: as it was read.
    JointLoad load(const World& world, std::size_t joint) const;

  private:
    static constexpr std::size_t none = ~std::size_t{0};
    static constexpr std::uint32_t no_touch = ~std::uint32_t{0};

    struct Joint {
        JointId id;
        std::size_t a, b;
        JointAxis axis;
        std::size_t on_a = 0, on_b = 0;  ///< its number among the joints of the prisms that it joins
    };
    /// What a polygon's element has in place of a square's faces.
    struct Prism {
        PressedPrism ice;
        Corner axis;                        ///< own x axis in the axes of the floe
        Corner size;                        ///< extents in the axes of the floe, m
        std::vector<std::size_t> joints{};  ///< by their numbers among the prism's
        int live = 0;                       ///< of them
    };
    struct Element {
        PressedElement ice;  ///< of a square
        BodyId body;
        double most_stress;                   ///< by a force of 1 N, Pa
        std::array<std::size_t, 4> joint_of;  ///< faces +x, -x, +z, -z
        std::size_t prism = none;             ///< in prisms_
        /// In the last step:
        double largest_force = 0;  ///< of its contacts, N
        std::uint32_t first = no_touch, last = no_touch;

        bool is_joined(const std::vector<Prism>& prisms) const {
            return prism == none ? ice.joined != 0 : prisms[prism].live > 0;
        }
    };
    /// A contact as one of its two bodies feels it, and the next one of the same body.
    struct Touch {
        std::size_t contact;
        bool on_a;
        std::uint32_t next = no_touch;
    };
    static Element made_of(BodyId body, const PressedElement& element);
    void join(std::size_t joint);
    void touch(BodyId body, std::size_t contact, bool on_a);
    bool is_prism(std::size_t element) const { return elements_[element].prism != none; }
    std::size_t join_prism(std::size_t element, std::size_t joint, const PrismJoint& at);
    void leave_prisms(const Joint& joint);
    double bending(const Element& element, int face) const;
    double across_in_prism(const Joint& joint, bool at_b) const;
    Press press(const World& world, const Element& element, const Touch& touch) const;

    /// What the contact adds to the joint, as its element a or b bears it; nothing where another joint is nearer.
    std::optional<LocalStress> added(const Joint& joint, bool at_b, const Press& press) const;
    std::optional<LocalStress> added_in_prism(const Joint& joint, bool at_b, const Press& press) const;

    std::vector<Element> elements_;
    std::vector<Prism> prisms_;
    std::vector<Joint> joints_;
    std::vector<bool> live_;
    std::vector<JointReaction> reactions_;
    std::vector<std::size_t> element_of_body_;  ///< none: not an element
    std::vector<ContactForce> contacts_;        ///< of the last step
    std::vector<Touch> touches_;
    std::vector<std::size_t> touched_;  ///< elements, by number
};

}  // namespace floes
