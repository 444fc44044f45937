#pragma once
// The grid of beams of docs/ice.md at rest on water, for the proofs of fracture: deflection and moments under a load.

#include <Eigen/SparseCholesky>
#include <optional>
#include <vector>

#include "beam_sheet.hpp"
#include "core/vector.hpp"
#include "ice/floe_grid.hpp"
#include "ice/joint_stress.hpp"
#include "ice/stress_field.hpp"
#include "theory/plate.hpp"

namespace floes::test {

/// A sheet of long x broad elements; element (i, k) as in FloeGrid.
class Lattice {
  public:
    Lattice(const ElasticIce& ice, double element, int elements_long, int elements_broad, double foundation)
        : grid_{elements_long, elements_broad, element}, joints_(joint_order(grid_)) {
        const JointSpring spring = beam_joint(ice, element, element);
        bending_ = spring.moment[2];
        std::vector<Eigen::Triplet<double>> entries;
        for (int i = 0; i < grid_.elements(); ++i) {
            entries.emplace_back(3 * i, 3 * i, foundation * element * element);
            for (const int turn : {1, 2})
                entries.emplace_back(3 * i + turn, 3 * i + turn, foundation * std::pow(element, 4) / 12);
        }
        for (const GridJoint& joint : joints_) {
            const int along = joint.axis == JointAxis::x ? 1 : 2;
            const double half = element / 2;
            add_spring(
                entries, spring.force[1],
                {{3 * joint.b, 1}, {3 * joint.b + along, -half}, {3 * joint.a, -1}, {3 * joint.a + along, -half}});
            for (const int turn : {1, 2})
                add_spring(entries, bending_, {{3 * joint.b + turn, 1}, {3 * joint.a + turn, -1}});
        }
        Eigen::SparseMatrix<double> matrix(3 * grid_.elements(), 3 * grid_.elements());
        matrix.setFromTriplets(entries.begin(), entries.end());
        factor_.compute(matrix);
    }

    /// Presses down with 1 N on an element, at (x, z) from its middle.
    void press(int element, double x, double z) {
        Eigen::VectorXd load = Eigen::VectorXd::Zero(3 * grid_.elements());
        load[3 * element] = 1;
        load[3 * element + 1] = x;
        load[3 * element + 2] = z;
        motion_ = factor_.solve(load);
    }

    /// Under that load, N m; tension below positive. None where there is no joint.
    struct Moments {
        double bending = 0;
        double torsion = 0;
    };
    std::optional<Moments> moments(int element, JointAxis axis, int towards = 1) const {
        const int i = element % grid_.elements_long;
        const int k = element / grid_.elements_long;
        const int step = axis == JointAxis::x ? 1 : grid_.elements_long;
        const int place = axis == JointAxis::x ? i : k;
        const int last = (axis == JointAxis::x ? grid_.elements_long : grid_.elements_broad) - 1;
        if (place + towards < 0 || place + towards > last) return std::nullopt;
        const int a = towards > 0 ? element : element - step;
        const int along = axis == JointAxis::x ? 1 : 2;
        const auto turn = [&](int axis_of_turn) {
            return motion_[3 * (a + step) + axis_of_turn] - motion_[3 * a + axis_of_turn];
        };
        return Moments{-bending_ * turn(along), -bending_ * turn(3 - along)};
    }

    /// The joint on the +x face of an element: what a StressField would tell, without contacts.
    JointLoad load_at_plus_x(int element) const {
        const Moments here = *moments(element, JointAxis::x);
        JointLoad load;
        load.reaction.bending = here.bending;
        load.reaction.torsion = here.torsion;
        for (const int beside : {element, element + 1}) {
            for (const int towards : {1, -1})
                if (const auto there = moments(beside, JointAxis::z, towards)) load.across += there->bending / 4;
        }
        return load;
    }

    double rotation_at_plus_x(int element) const {
        const Moments here = *moments(element, JointAxis::x);
        return std::hypot(here.bending, here.torsion) / bending_;
    }

    double joint_stiffness() const { return bending_; }

  private:
    FloeGrid grid_;
    std::vector<GridJoint> joints_;
    double bending_ = 0;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
    Eigen::VectorXd motion_;
};

}  // namespace floes::test
