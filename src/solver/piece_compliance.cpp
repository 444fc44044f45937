#include "solver/piece_compliance.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "core/error.hpp"
#include "core/state_archive.hpp"

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

/// Of a body's six velocities, those within the plane, and those out of it.
constexpr std::array<std::array<int, 3>, 2> parts{{{0, 2, 4}, {1, 3, 5}}};

using Entries = std::vector<Eigen::Triplet<double>>;

void add_block(std::array<Entries, 2>& to, int row, int column, const Eigen::Matrix<double, 6, 6>& block) {
    const double negligible = 1e-9 * block.cwiseAbs().maxCoeff();
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t part = 0; part < 2; ++part) {
                to[part].emplace_back(3 * row + static_cast<int>(i), 3 * column + static_cast<int>(k),
                                      block(parts[part][i], parts[part][k]));
                if (std::abs(block(parts[part][i], parts[1 - part][k])) > negligible) {
                    throw InputError(
                        "The direct solver cannot be set up: a joint lies outside the plane of its floe, or is turned "
                        "against it.");
                }
            }
        }
    }
}

std::array<Eigen::SparseMatrix<double>, 2> assembled(const std::vector<PieceBody>& bodies,
                                                     const std::vector<PieceJoint>& joints) {
    std::array<Entries, 2> entries;
    for (int i = 0; i < static_cast<int>(bodies.size()); ++i) {
        add_block(entries, i, i, inertia_of(bodies[static_cast<std::size_t>(i)]));
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
    const auto size = static_cast<Eigen::Index>(3 * bodies.size());
    std::array<Eigen::SparseMatrix<double>, 2> matrices{Eigen::SparseMatrix<double>(size, size),
                                                        Eigen::SparseMatrix<double>(size, size)};
    for (std::size_t part = 0; part < 2; ++part) {
        matrices[part].setFromTriplets(entries[part].begin(), entries[part].end());
    }
    return matrices;
}

bool close(double a, double b) {
    return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

/// Tolerance relative to the largest entry, because small ones may be rounding.
template <class Matrix>
bool close(const Matrix& a, const Matrix& b, double size) {
    return (a - b).cwiseAbs().maxCoeff() <= 1e-9 * size;
}

bool equal(const PieceBody& a, const PieceBody& b) {
    return close(a.mass, b.mass) && close(a.inertia, b.inertia, a.inertia.cwiseAbs().maxCoeff()) &&
           close(a.turn, b.turn, 1.0) && a.water == b.water && a.rail == b.rail;
}

bool equal(const PieceJoint& a, const PieceJoint& b) {
    const double size = a.lever_a.norm() + a.lever_b.norm();
    return a.a == b.a && a.b == b.b && close(a.axes, b.axes, 1.0) && close(a.lever_a, b.lever_a, size) &&
           close(a.lever_b, b.lever_b, size) &&
           std::ranges::equal(a.hold, b.hold, [](double x, double y) { return close(x, y); });
}

}  // namespace

PieceBody body_of(const SolverBody& body, const Mat3& turn) {
    if (!(body.inverse_mass > 0)) return {};
    const Vec3 inertia(1 / body.inverse_inertia[0], 1 / body.inverse_inertia[1], 1 / body.inverse_inertia[2]);
    return {1 / body.inverse_mass, turn * inertia.asDiagonal() * turn.transpose(), turn, body.water, body.rail};
}

Eigen::Matrix<double, 6, 6> inertia_of(const PieceBody& body) {
    Eigen::Matrix<double, 6, 6> inertia = Eigen::Matrix<double, 6, 6>::Identity();  // of a fixed body anything
    if (!(body.mass > 0)) return inertia;
    inertia.topLeftCorner<3, 3>() *= body.mass;
    inertia.bottomRightCorner<3, 3>() = body.inertia;
    for (int axis = 0; axis < 3; ++axis)
        if (body.rail >= 0 && axis != body.rail) inertia(axis, axis) *= off_rail;
    const CarriedWater& water = body.water;
    if (water == CarriedWater{}) return inertia;
    Eigen::Matrix<double, 6, 6> added = Eigen::Matrix<double, 6, 6>::Zero();
    added.diagonal() << water.in_plane, water.normal, water.in_plane, water.zz, water.yaw, water.xx;
    added(1, 3) = added(3, 1) = -water.z;
    added(1, 5) = added(5, 1) = water.x;
    added(3, 5) = added(5, 3) = -water.xz;
    Eigen::Matrix<double, 6, 6> turn = Eigen::Matrix<double, 6, 6>::Zero();
    turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = body.turn;
    return inertia + turn * added * turn.transpose();
}

PlaneFactors::PlaneFactors(const std::array<Eigen::SparseMatrix<double>, 2>& matrices) {
    using Factor = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;
    const std::array<Factor, 2> factors{Factor(matrices[0]), Factor(matrices[1])};
    const Eigen::SparseMatrix<double>& first = factors[0].matrixL().nestedExpression();
    const Eigen::SparseMatrix<double>& second = factors[1].matrixL().nestedExpression();
    const Eigen::VectorXi& order = factors[0].permutationP().indices();
    // Both have entries wherever one may, so that order and pattern are the same.
    FLOES_ENSURES(first.nonZeros() == second.nonZeros() && order == factors[1].permutationP().indices());
    place_.assign(order.begin(), order.end());
    start_.assign(first.outerIndexPtr(), first.outerIndexPtr() + first.outerSize() + 1);
    row_.assign(first.innerIndexPtr(), first.innerIndexPtr() + first.nonZeros());
    value_.reserve(2 * row_.size());
    for (Eigen::Index k = 0; k < first.nonZeros(); ++k)
        for (const auto* of : {&first, &second}) value_.push_back(of->valuePtr()[k]);
    const std::array<Eigen::VectorXd, 2> diagonals{factors[0].vectorD(), factors[1].vectorD()};
    for (Eigen::Index i = 0; i < first.outerSize(); ++i)
        for (const Eigen::VectorXd& of : diagonals) inverse_.push_back(1 / of[i]);
}

template <std::size_t sides>
void PlaneFactors::solve(double* x) const {
    constexpr std::size_t both = 2 * sides;
    const std::size_t size = place_.size();
    std::array<double, both> own;
    for (std::size_t i = 0; i < size; ++i) {
        std::copy_n(x + i * both, both, own.begin());
        if (std::ranges::all_of(own, [](double one) { return one == 0; })) continue;
        for (auto k = static_cast<std::size_t>(start_[i]); k < static_cast<std::size_t>(start_[i + 1]); ++k) {
            double* const at = x + static_cast<std::size_t>(row_[k]) * both;
            for (std::size_t c = 0; c < sides; ++c) at[c] -= own[c] * value_[2 * k];
            for (std::size_t c = 0; c < sides; ++c) at[sides + c] -= own[sides + c] * value_[2 * k + 1];
        }
    }
    for (std::size_t i = 0; i < size; ++i)
        for (std::size_t c = 0; c < both; ++c) x[i * both + c] *= inverse_[2 * i + c / sides];
    for (std::size_t i = size; i-- > 0;) {
        std::copy_n(x + i * both, both, own.begin());
        for (auto k = static_cast<std::size_t>(start_[i]); k < static_cast<std::size_t>(start_[i + 1]); ++k) {
            const double* const at = x + static_cast<std::size_t>(row_[k]) * both;
            for (std::size_t c = 0; c < sides; ++c) own[c] -= value_[2 * k] * at[c];
            for (std::size_t c = 0; c < sides; ++c) own[sides + c] -= value_[2 * k + 1] * at[sides + c];
        }
        std::copy_n(own.begin(), both, x + i * both);
    }
}

PieceCompliance::PieceCompliance(std::vector<PieceBody> bodies, std::vector<PieceJoint> joints)
    : bodies_(std::move(bodies)),
      joints_(std::move(joints)),
      factors_(assembled(bodies_, joints_)),
      columns_(bodies_.size()) {}

bool PieceCompliance::is_of(std::span<const PieceBody> bodies, std::span<const PieceJoint> joints) const {
    const auto same = [](const auto& a, const auto& b) { return equal(a, b); };
    return std::ranges::equal(bodies_, bodies, same) && std::ranges::equal(joints_, joints, same);
}

template <std::size_t sources>
void PieceCompliance::make_some(const std::array<std::size_t, sources>& bodies) {
    constexpr std::size_t sides = 3 * sources;
    const std::size_t size = 3 * bodies_.size();
    solved_.assign(2 * sides * size, 0.0);
    for (std::size_t j = 0; j < sources; ++j)
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t part = 0; part < 2; ++part)
                solved_[(2 * factors_.place(3 * bodies[j] + k) + part) * sides + 3 * j + k] = 1;
    factors_.solve<sides>(solved_.data());
    for (std::size_t j = 0; j < sources; ++j) {
        AlignedArray<double>& column = columns_[bodies[j]];
        column = AlignedArray<double>(bodies_.size() * compliance_block);
        for (std::size_t i = 0; i < size; ++i)
            for (std::size_t part = 0; part < 2; ++part)
                for (std::size_t k = 0; k < 3; ++k)
                    column[i / 3 * compliance_block + 8 * k + 4 * part + i % 3] =
                        solved_[(2 * factors_.place(i) + part) * sides + 3 * j + k];
    }
}

void PieceCompliance::make_columns(std::span<const std::uint32_t> sources) {
    constexpr std::size_t most = 4;
    std::array<std::size_t, most> some{};
    std::size_t count = 0;
    for (const std::uint32_t source : sources) {
        if (columns_[source].size() > 0 || !(bodies_[source].mass > 0)) continue;
        some[count++] = source;
        if (count < most) continue;
        make_some(some);
        count = 0;
    }
    for (std::size_t i = 0; i < count; ++i) make_some(std::array{some[i]});
}

const double* PieceCompliance::column(std::size_t source) {
    AlignedArray<double>& column = columns_[source];
    if (column.size() > 0) return column.data();
    if (bodies_[source].mass > 0)
        make_some(std::array{source});
    else
        column = AlignedArray<double>(bodies_.size() * compliance_block);  // it does not feel impulses
    return column.data();
}

void PieceCompliance::velocity_changes(const double* impulses, double* changes) {
    const std::size_t size = 3 * bodies_.size();
    const auto at = [&](std::size_t i, std::size_t part) { return i / 3 * 8 + 4 * part + i % 3; };
    solved_.resize(2 * size);
    for (std::size_t i = 0; i < size; ++i)
        for (std::size_t part = 0; part < 2; ++part)
            solved_[2 * factors_.place(i) + part] = bodies_[i / 3].mass > 0 ? impulses[at(i, part)] : 0;
    factors_.solve<1>(solved_.data());
    for (std::size_t i = 0; i < size; ++i)
        for (std::size_t part = 0; part < 2; ++part) changes[at(i, part)] = solved_[2 * factors_.place(i) + part];
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

void PieceCompliance::archive(StateArchive& state, std::shared_ptr<PieceCompliance>& known) {
    std::vector<PieceBody> bodies;
    std::vector<PieceJoint> joints;
    if (known) {
        auto& [of_bodies, of_joints, factors, columns, solved] = *known;  // the others follow from these
        bodies = of_bodies;
        joints = of_joints;
    }
    state(bodies, joints);
    if (state.sets()) known = std::make_shared<PieceCompliance>(std::move(bodies), std::move(joints));
}

}  // namespace floes
