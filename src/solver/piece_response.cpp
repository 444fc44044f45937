#include "solver/piece_response.hpp"

#include <algorithm>
#include <cmath>

namespace floes {
namespace {

using Row = Eigen::Vector<double, 6>;  // of the linear, then the angular velocity of one body

/// The parts of a joint's motion that a body's velocities make: row i is that of part i.
Eigen::Matrix<double, 6, 6> motion(const PieceJoint& joint, const Vec3& lever) {
    Eigen::Matrix<double, 6, 6> rows = Eigen::Matrix<double, 6, 6>::Zero();
    for (int i = 0; i < 3; ++i) {
        const Vec3 axis = joint.axes.col(i);
        rows.row(i) << axis.transpose(), lever.cross(axis).transpose();
        rows.row(3 + i).tail<3>() = axis.transpose();
    }
    return rows;
}

void add_block(std::vector<Eigen::Triplet<double>>& to, int row, int column, const Eigen::Matrix<double, 6, 6>& block) {
    for (int i = 0; i < 6; ++i) {
        for (int k = 0; k < 6; ++k) to.emplace_back(6 * row + i, 6 * column + k, block(i, k));
    }
}

Eigen::SparseMatrix<double> assembled(const std::vector<PieceBody>& bodies, const std::vector<PieceJoint>& joints) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < static_cast<int>(bodies.size()); ++i) {
        const PieceBody& body = bodies[static_cast<std::size_t>(i)];
        Eigen::Matrix<double, 6, 6> inertia = Eigen::Matrix<double, 6, 6>::Identity();  // of a fixed body anything
        if (body.mass > 0) {
            inertia.topLeftCorner<3, 3>() *= body.mass;
            inertia.bottomRightCorner<3, 3>() = body.inertia;
        }
        add_block(entries, i, i, inertia);
    }
    for (const PieceJoint& joint : joints) {
        const bool moves[] = {bodies[static_cast<std::size_t>(joint.a)].mass > 0,
                              bodies[static_cast<std::size_t>(joint.b)].mass > 0};
        const int ends[] = {joint.a, joint.b};
        const Eigen::Matrix<double, 6, 6> rows[] = {motion(joint, joint.lever_a), -motion(joint, joint.lever_b)};
        const auto hold = Eigen::Map<const Row>(joint.hold.data()).asDiagonal();
        for (int i = 0; i < 2; ++i) {
            for (int k = 0; k < 2; ++k) {
                if (moves[i] && moves[k]) add_block(entries, ends[i], ends[k], rows[i].transpose() * hold * rows[k]);
            }
        }
    }
    const auto size = static_cast<Eigen::Index>(6 * bodies.size());
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

bool close(double a, double b) {
    return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

/// Compared with the largest of its entries: the others may be rounding.
template <class Matrix>
bool close(const Matrix& a, const Matrix& b, double size) {
    return (a - b).cwiseAbs().maxCoeff() <= 1e-9 * size;
}

bool equal(const PieceBody& a, const PieceBody& b) {
    return close(a.mass, b.mass) && close(a.inertia, b.inertia, a.inertia.cwiseAbs().maxCoeff());
}

bool equal(const PieceJoint& a, const PieceJoint& b) {
    const double size = a.lever_a.norm() + a.lever_b.norm();
    return a.a == b.a && a.b == b.b && close(a.axes, b.axes, 1.0) && close(a.lever_a, b.lever_a, size) &&
           close(a.lever_b, b.lever_b, size) &&
           std::ranges::equal(a.hold, b.hold, [](double x, double y) { return close(x, y); });
}

}  // namespace

PieceResponse::PieceResponse(std::vector<PieceBody> bodies, std::vector<PieceJoint> joints)
    : bodies_(std::move(bodies)),
      joints_(std::move(joints)),
      factor_(assembled(bodies_, joints_)),
      columns_(bodies_.size()) {}

bool PieceResponse::is_of(std::span<const PieceBody> bodies, std::span<const PieceJoint> joints) const {
    const auto same = [](const auto& a, const auto& b) { return equal(a, b); };
    return std::ranges::equal(bodies_, bodies, same) && std::ranges::equal(joints_, joints, same);
}

const double* PieceResponse::column(std::size_t source) {
    AlignedArray<double>& column = columns_[source];
    if (column.size() > 0) return column.data();
    column = AlignedArray<double>(bodies_.size() * block);
    if (!(bodies_[source].mass > 0)) return column.data();  // it does not feel impulses
    const auto size = static_cast<Eigen::Index>(6 * bodies_.size());
    Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(size, 6);
    unit.middleRows<6>(static_cast<Eigen::Index>(6 * source)).setIdentity();
    const Eigen::MatrixXd answer = factor_.solve(unit);
    for (std::size_t body = 0; body < bodies_.size(); ++body) {
        for (std::size_t k = 0; k < 6; ++k) {
            for (std::size_t i = 0; i < 6; ++i) {
                column[body * block + 8 * k + i + (i < 3 ? 0 : 1)] =
                    answer(static_cast<Eigen::Index>(6 * body + i), static_cast<Eigen::Index>(k));
            }
        }
    }
    return column.data();
}

void PieceResponse::respond(const double* impulses, double* changes) {
    impulses_.resize(static_cast<Eigen::Index>(6 * bodies_.size()));
    for (std::size_t body = 0; body < bodies_.size(); ++body) {
        for (std::size_t i = 0; i < 6; ++i) {
            impulses_[static_cast<Eigen::Index>(6 * body + i)] =
                bodies_[body].mass > 0 ? impulses[8 * body + i + (i < 3 ? 0 : 1)] : 0;
        }
    }
    changes_ = factor_.solve(impulses_);
    for (std::size_t body = 0; body < bodies_.size(); ++body) {
        for (std::size_t i = 0; i < 6; ++i) {
            changes[8 * body + i + (i < 3 ? 0 : 1)] = changes_[static_cast<Eigen::Index>(6 * body + i)];
        }
    }
}

std::array<double, 6> inverse_effective_mass(const PieceBody& a, const PieceBody& b, const PieceJoint& joint) {
    std::array<double, 6> inverse{};
    for (const auto& [body, lever] : {std::pair(a, joint.lever_a), std::pair(b, joint.lever_b)}) {
        if (!(body.mass > 0)) continue;
        const Mat3 inverse_inertia = body.inertia.inverse();
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 axis = joint.axes.col(static_cast<Eigen::Index>(i));
            const Vec3 arm = lever.cross(axis);
            inverse[i] += 1 / body.mass + arm.dot(inverse_inertia * arm);
            inverse[3 + i] += axis.dot(inverse_inertia * axis);
        }
    }
    return inverse;
}

}  // namespace floes
