#pragma once
// What acts at every joint of all floes in the world's last step: its reaction, the moments beside it, and the stress
// by contacts on its elements.

#include <array>
#include <cstdint>
#include <vector>

#include "ice/contact_stress.hpp"
#include "ice/floe_grid.hpp"
#include "ice/joint_stress.hpp"
#include "world/world.hpp"

namespace floes {

class StressField {
  public:
    /// For this many elements reading then allocates nothing unless contacts are very many.
    void reserve(std::size_t elements);

    /// Elements and joints are numbered from 0 in the order in which they are added; bodies of elements follow one
    /// another in the world.
    void add_element(BodyId body, const PressedElement& element);
    void add_joint(JointId id, std::size_t a, std::size_t b, JointAxis axis);

    void remove_joint(std::size_t joint);

    /// Reads the reactions of the live joints and the contacts. To be called once after a step.
    void read(const World& world);

    const JointReaction& reaction(std::size_t joint) const { return reactions_[joint]; }

    JointLoad load(std::size_t joint) const;

  private:
    struct Joint {
        JointId id;
        std::size_t a, b;
        JointAxis axis;
    };
    static constexpr std::size_t none = ~std::size_t{0};

    void press(const World& world, BodyId body, const Vec3& point, const Vec3& force);
    double bending(std::size_t element, int face) const;

    std::vector<PressedElement> elements_;
    std::vector<std::array<std::size_t, 4>> joint_of_face_;  ///< of each element: faces +x, -x, +z, -z
    std::vector<Joint> joints_;
    std::vector<bool> live_;
    std::vector<JointReaction> reactions_;
    std::size_t first_body_ = 0;
    /// Of the contact that adds most tension to one fibre, at the face of each element that is nearest to it.
    struct Peak {
        LocalStress sagging, hogging;
    };
    std::vector<std::array<Peak, 4>> by_contacts_;  ///< of each element and face
    std::vector<std::size_t> pressed_;              ///< elements with contacts in the last step
    std::vector<ContactForce> contacts_;
};

}  // namespace floes
