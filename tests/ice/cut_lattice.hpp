#pragma once
// The beams between the elements of a floe at rest on water (docs/fracture.md), for the proofs of fracture: deflection
// and moments under a load.

#include <Eigen/SparseCholesky>
#include <cmath>
#include <utility>
#include <vector>

#include "beam_sheet.hpp"
#include "ice/joint_stress.hpp"
#include "ice/stress_field.hpp"
#include "shapes/elements.hpp"

namespace floes::test {

class CutLattice {
  public:
    CutLattice(const ElasticIce& ice, CutFloe cut, double foundation) : cut_(std::move(cut)), ice_(ice) {
        std::vector<Eigen::Triplet<double>> entries;
        for (std::size_t i = 0; i < cut_.elements.size(); ++i) {
            const CutElement& one = cut_.elements[i];
            const Corner own_z{-one.axis.z, one.axis.x};
            const auto area = [&](double Corner::*p, double Corner::*q) {
                return one.xx * (one.axis.*p) * (one.axis.*q) + one.zz * (own_z.*p) * (own_z.*q);
            };
            const int at = static_cast<int>(3 * i);
            entries.emplace_back(at, at, foundation * one.area);
            entries.emplace_back(at + 1, at + 1, foundation * area(&Corner::x, &Corner::x));
            entries.emplace_back(at + 2, at + 2, foundation * area(&Corner::z, &Corner::z));
            entries.emplace_back(at + 1, at + 2, foundation * area(&Corner::x, &Corner::z));
            entries.emplace_back(at + 2, at + 1, foundation * area(&Corner::x, &Corner::z));
        }
        for (const CutJoint& joint : cut_.joints) {
            const JointSpring spring = beam_joint(ice, joint.length, joint.span);
            const Corner from_a = joint.pivot - centre(joint.a);
            const Corner from_b = joint.pivot - centre(joint.b);
            const int a = 3 * joint.a;
            const int b = 3 * joint.b;
            add_spring(entries, spring.force[1],
                       {{b, 1}, {b + 1, from_b.x}, {b + 2, from_b.z}, {a, -1}, {a + 1, -from_a.x}, {a + 2, -from_a.z}});
            for (const int turn : {1, 2}) add_spring(entries, spring.moment[2], {{b + turn, 1}, {a + turn, -1}});
        }
        const auto size = static_cast<Eigen::Index>(3 * cut_.elements.size());
        Eigen::SparseMatrix<double> matrix(size, size);
        matrix.setFromTriplets(entries.begin(), entries.end());
        factor_.compute(matrix);
    }

    const CutFloe& cut() const { return cut_; }

    /// The element that has the point; -1 for none.
    int element_at(const Corner& point) const {
        for (std::size_t i = 0; i < cut_.elements.size(); ++i)
            if (contains(in_floe(i), point - centre(static_cast<int>(i)))) return static_cast<int>(i);
        return -1;
    }

    /// Presses down with 1 N at a point; every joint's load but for the contact follows.
    void press(int element, const Corner& point) {
        const Corner from = point - centre(element);
        Eigen::VectorXd load = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(3 * cut_.elements.size()));
        load[3 * element] = 1;
        load[3 * element + 1] = from.x;
        load[3 * element + 2] = from.z;
        motion_ = factor_.solve(load);
    }

    /// Bending and torsion of a joint, N m, by the frame of the world's joints; tension below positive.
    JointReaction reaction(std::size_t joint) const {
        const CutJoint& one = cut_.joints[joint];
        const Corner turned{motion_[3 * one.b + 1] - motion_[3 * one.a + 1],
                            motion_[3 * one.b + 2] - motion_[3 * one.a + 2]};
        // Slopes downwards: a joint whose slope grows along its normal hogs; one whose slope along -x grows twists.
        return {.torsion = stiffness(joint) * cross(one.normal, turned),
                .bending = -stiffness(joint) * dot(one.normal, turned)};
    }

    double stiffness(std::size_t joint) const {  // against bending, N m
        return beam_joint(ice_, cut_.joints[joint].length, cut_.joints[joint].span).moment[2];
    }

    /// By how much two elements are turned against each other, rad.
    double turned(int a, int b) const {
        return std::hypot(motion_[3 * b + 1] - motion_[3 * a + 1], motion_[3 * b + 2] - motion_[3 * a + 2]);
    }

    /// What a StressField would tell of a joint, without contacts.
    JointLoad load(std::size_t joint) const {
        const CutJoint& one = cut_.joints[joint];
        const Corner t{-one.normal.z, one.normal.x};
        JointLoad load{.reaction = reaction(joint)};
        for (const int element : {one.a, one.b}) {
            double sum = 0;
            for (std::size_t k = 0; k < cut_.joints.size(); ++k) {
                const CutJoint& other = cut_.joints[k];
                if (other.a != element && other.b != element) continue;
                const double way = other.a == element ? 1 : -1;
                const JointReaction beside = reaction(k);
                const double moment = way * (beside.bending * dot(other.normal, t) -
                                             beside.torsion * dot({-other.normal.z, other.normal.x}, t));
                sum += moment * dot(other.pivot - centre(element), t);
            }
            load.across += one.length / 2 * sum / cut_.elements[static_cast<std::size_t>(element)].area;
        }
        return load;
    }

    /// The prism of an element with its joints, and their numbers.
    PressedElement prism(int element, double crushing_pressure, std::vector<std::size_t>& numbers) const {
        PressedElement made{.corners = in_floe(static_cast<std::size_t>(element)),
                            .area = cut_.elements[static_cast<std::size_t>(element)].area,
                            .patch = cut_.squares ? square_patch : cell_patch,
                            .poisson_ratio = ice_.poisson_ratio,
                            .crushing_pressure = crushing_pressure};
        for (std::size_t k = 0; k < cut_.joints.size(); ++k) {
            const CutJoint& joint = cut_.joints[k];
            if (joint.a != element && joint.b != element) continue;
            const double way = joint.a == element ? 1 : -1;
            made.joints.push_back({way * joint.normal, joint.pivot - centre(element), joint.length, joint.span,
                                   ice_.thickness, joint.a == element ? joint.edge_a : joint.edge_b});
            numbers.push_back(k);
        }
        return made;
    }

  private:
    const Corner& centre(int element) const { return cut_.elements[static_cast<std::size_t>(element)].centre; }
    Outline in_floe(std::size_t element) const {
        return from_axes(cut_.elements[element].corners, {}, cut_.elements[element].axis);
    }

    CutFloe cut_;
    ElasticIce ice_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
    Eigen::VectorXd motion_;
};

}  // namespace floes::test
