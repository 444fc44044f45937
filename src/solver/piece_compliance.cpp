#include "solver/piece_compliance.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <ranges>
#include <utility>

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

namespace {

bool same_pattern(const PlaneFactors::Sparse& a, const PlaneFactors::Sparse& b) {
    return a.nonZeros() == b.nonZeros() && a.cols() == b.cols() &&
           std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols(), b.outerIndexPtr()) &&
           std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

bool same_values(const PlaneFactors::Sparse& a, const PlaneFactors::Sparse& b) {
    return std::equal(a.valuePtr(), a.valuePtr() + a.nonZeros(), b.valuePtr());
}

/// Of two systems one after the other, those of one.
void copy_half(const std::vector<double>& from, std::vector<double>& to, std::size_t part) {
    for (std::size_t k = part; k < from.size(); k += 2) to[k] = from[k];
}

}  // namespace

PlaneFactors::PlaneFactors(std::array<Sparse, 2> matrices, bool kept, const PlaneFactors* like) {
    // Both have entries wherever one may, so that order and pattern are the same.
    FLOES_EXPECTS(same_pattern(matrices[0], matrices[1]));
    const bool alike = like != nullptr && like->analysed_ != nullptr && same_pattern(matrices[0], like->matrices_[0]);
    const auto factor = alike ? like->analysed_ : std::make_shared<Eigen::SimplicialLDLT<Sparse>>();
    if (!alike) factor->analyzePattern(matrices[0]);
    place_.assign(factor->permutationP().indices().begin(), factor->permutationP().indices().end());
    if (alike) {
        start_ = like->start_;
        row_ = like->row_;
    }
    value_.resize(2 * row_.size());
    inverse_.resize(2 * place_.size());
    for (std::size_t part = 0; part < 2; ++part) {
        // Joints that crack soften against what is out of the plane alone.
        if (alike && same_values(matrices[part], like->matrices_[part])) {
            copy_half(like->value_, value_, part);
            copy_half(like->inverse_, inverse_, part);
            continue;
        }
        factor->factorize(matrices[part]);
        const Sparse& lower = factor->matrixL().nestedExpression();
        if (row_.empty()) {
            start_.assign(lower.outerIndexPtr(), lower.outerIndexPtr() + lower.outerSize() + 1);
            row_.assign(lower.innerIndexPtr(), lower.innerIndexPtr() + lower.nonZeros());
            value_.resize(2 * row_.size());
        }
        for (std::size_t k = 0; k < row_.size(); ++k) value_[2 * k + part] = lower.valuePtr()[k];
        const Eigen::VectorXd diagonal = factor->vectorD();
        for (std::size_t i = 0; i < place_.size(); ++i)
            inverse_[2 * i + part] = 1 / diagonal[static_cast<Eigen::Index>(i)];
    }
    if (!kept) return;
    analysed_ = factor;
    matrices_ = std::move(matrices);
}

std::size_t PlaneFactors::next(std::size_t place) const {
    return start_[place] == start_[place + 1] ? size()
                                              : static_cast<std::size_t>(row_[static_cast<std::size_t>(start_[place])]);
}

template <std::size_t sides, class Places, class Slot>
void PlaneFactors::eliminate(const Places& places, double* x, const Slot& slot) const {
    constexpr std::size_t both = 2 * sides;
    std::array<double, both> own;
    for (const std::size_t i : places) {
        std::copy_n(x + slot(i) * both, both, own.begin());
        if (std::ranges::all_of(own, [](double one) { return one == 0; })) continue;
        for (auto k = static_cast<std::size_t>(start_[i]); k < static_cast<std::size_t>(start_[i + 1]); ++k) {
            double* const at = x + slot(static_cast<std::size_t>(row_[k])) * both;
            for (std::size_t c = 0; c < sides; ++c) at[c] -= own[c] * value_[2 * k];
            for (std::size_t c = 0; c < sides; ++c) at[sides + c] -= own[sides + c] * value_[2 * k + 1];
        }
    }
    for (const std::size_t i : places)
        for (std::size_t c = 0; c < both; ++c) x[slot(i) * both + c] *= inverse_[2 * i + c / sides];
}

template <std::size_t sides, class Places, class Slot>
void PlaneFactors::substitute(const Places& places, double* x, const Slot& slot) const {
    constexpr std::size_t both = 2 * sides;
    std::array<double, both> own;
    for (const std::size_t i : places) {
        std::copy_n(x + slot(i) * both, both, own.begin());
        for (auto k = static_cast<std::size_t>(start_[i]); k < static_cast<std::size_t>(start_[i + 1]); ++k) {
            const double* const at = x + slot(static_cast<std::size_t>(row_[k])) * both;
            for (std::size_t c = 0; c < sides; ++c) own[c] -= value_[2 * k] * at[c];
            for (std::size_t c = 0; c < sides; ++c) own[sides + c] -= value_[2 * k + 1] * at[sides + c];
        }
        std::copy_n(own.begin(), both, x + slot(i) * both);
    }
}

constexpr std::uint32_t no_number = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t no_slot = std::numeric_limits<std::size_t>::max();

PieceCompliance::PieceCompliance(std::vector<PieceBody> bodies, std::vector<PieceJoint> joints,
                                 const PieceCompliance* before)
    : bodies_(std::move(bodies)),
      joints_(std::move(joints)),
      factors_(assembled(bodies_, joints_), !is_small(), before == nullptr ? nullptr : &before->factors_),
      number_(bodies_.size(), no_number),
      slot_(factors_.size(), no_slot),
      columns_(bodies_.size()) {}

bool PieceCompliance::is_of(std::span<const PieceBody> bodies, std::span<const PieceJoint> joints) const {
    const auto same = [](const auto& a, const auto& b) { return equal(a, b); };
    return std::ranges::equal(bodies_, bodies, same) && std::ranges::equal(joints_, joints, same);
}

std::vector<std::uint32_t> PieceCompliance::unknown_of(std::span<const std::uint32_t> bodies) const {
    std::vector<std::uint32_t> unknown;
    if (knows_all()) return unknown;
    if (is_small()) {
        unknown.resize(bodies_.size());
        std::iota(unknown.begin(), unknown.end(), 0U);
    } else {
        std::ranges::copy_if(bodies, std::back_inserter(unknown),
                             [&](std::uint32_t body) { return number_[body] == no_number; });
    }
    return unknown;
}

/// The places that get one, falling.
std::vector<std::size_t> PieceCompliance::give_slots(std::span<const std::uint32_t> bodies) {
    std::vector<std::size_t> fresh;
    for (const std::uint32_t body : bodies) {
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t i = factors_.place(3 * body + k); i < factors_.size() && slot_[i] == no_slot;
                 i = factors_.next(i)) {
                slot_[i] = places_.size() + fresh.size();
                fresh.push_back(i);
            }
        }
    }
    std::ranges::sort(fresh, std::greater());
    const auto known = static_cast<std::ptrdiff_t>(places_.size());
    places_.insert(places_.end(), fresh.begin(), fresh.end());
    std::inplace_merge(places_.begin(), places_.begin() + known, places_.end(), std::greater());
    return fresh;
}

void PieceCompliance::add_sources(std::span<const std::uint32_t> bodies) {
    std::vector<std::uint32_t> moving;
    for (const std::uint32_t body : bodies) {
        if (bodies_[body].mass > 0)
            moving.push_back(body);
        else
            columns_[body] = AlignedArray<double>(bodies_.size() * compliance_block);  // it does not feel impulses
    }
    std::span<const std::uint32_t> left = moving;
    while (!left.empty()) {
        const std::size_t count = left.size() < most_sources ? 1 : most_sources;
        sources_.push_back({{left.begin(), left.begin() + static_cast<std::ptrdiff_t>(count)}, {}});
        left = left.subspan(count);
    }
}

/// Calls task.template operator()<number of its bodies>().
template <class Task>
void PieceCompliance::for_size(const Sources& of, const Task& task) {
    if (of.bodies.size() == most_sources)
        task.template operator()<most_sources>();
    else
        task.template operator()<1>();
}

template <std::size_t sources>
void PieceCompliance::eliminate(Sources& of) const {
    constexpr std::size_t sides = 3 * sources;
    of.solved.assign(places_.size() * 2 * sides, 0.0);
    std::vector<std::size_t> way;
    for (std::size_t j = 0; j < sources; ++j) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t place = factors_.place(3 * of.bodies[j] + k);
            for (std::size_t part = 0; part < 2; ++part) of.solved[(2 * slot_[place] + part) * sides + 3 * j + k] = 1;
            for (std::size_t i = place; i < factors_.size(); i = factors_.next(i)) way.push_back(i);
        }
    }
    std::ranges::sort(way);
    way.erase(std::ranges::unique(way).begin(), way.end());
    factors_.eliminate<sides>(way, of.solved.data(), [&](std::size_t i) { return slot_[i]; });
}

/// Solves at these places more, and writes the blocks of bodies from the number `first` on.
template <std::size_t sources>
void PieceCompliance::substitute(Sources& of, std::span<const std::size_t> places, std::size_t first) {
    constexpr std::size_t sides = 3 * sources;
    of.solved.resize(places_.size() * 2 * sides);
    factors_.substitute<sides>(places, of.solved.data(), [&](std::size_t i) { return slot_[i]; });
    const std::size_t size = known_.size() * compliance_block;
    for (std::size_t j = 0; j < sources; ++j) {
        AlignedArray<double>& column = columns_[of.bodies[j]];
        if (column.size() < size) {
            AlignedArray<double> longer(knows_all() ? size : size + size / 2);
            std::copy_n(column.data(), first * compliance_block, longer.data());
            column = std::move(longer);
        }
        for (std::size_t n = first; n < known_.size(); ++n)
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t part = 0; part < 2; ++part)
                    for (std::size_t k = 0; k < 3; ++k)
                        column[n * compliance_block + 8 * k + 4 * part + i] =
                            of.solved[(2 * slot_[factors_.place(3 * known_[n] + i)] + part) * sides + 3 * j + k];
    }
}

void PieceCompliance::make_columns(std::span<const std::uint32_t> bodies) {
    const std::vector<std::uint32_t> fresh = unknown_of(bodies);
    if (fresh.empty()) return;
    const std::size_t first = known_.size();
    for (const std::uint32_t body : fresh) {
        number_[body] = static_cast<std::uint32_t>(known_.size());
        known_.push_back(body);
    }
    const std::vector<std::size_t> places = give_slots(fresh);
    for (Sources& of : sources_) for_size(of, [&]<std::size_t sources> { substitute<sources>(of, places, first); });
    const std::size_t old = sources_.size();
    add_sources(fresh);
    for (Sources& of : std::span(sources_).subspan(old)) {
        for_size(of, [&]<std::size_t sources> {
            eliminate<sources>(of);
            substitute<sources>(of, places_, 0);
        });
    }
    if (knows_all()) sources_ = {};
}

void PieceCompliance::velocity_changes(const double* impulses, std::span<const std::uint32_t> of, double* changes) {
    const std::size_t size = factors_.size();
    const auto at = [&](std::size_t i, std::size_t part) { return i / 3 * 8 + 4 * part + i % 3; };
    solved_.resize(2 * size);
    for (std::size_t i = 0; i < size; ++i)
        for (std::size_t part = 0; part < 2; ++part)
            solved_[2 * factors_.place(i) + part] = bodies_[i / 3].mass > 0 ? impulses[at(i, part)] : 0;
    const auto all = std::views::iota(std::size_t{0}, size);
    factors_.eliminate<1>(all, solved_.data(), std::identity());
    if (of.size() == bodies_.size())
        factors_.substitute<1>(all | std::views::reverse, solved_.data(), std::identity());
    else
        factors_.substitute<1>(places_, solved_.data(), std::identity());
    for (const std::size_t body : of)
        for (std::size_t i = 3 * body; i < 3 * body + 3; ++i)
            for (std::size_t part = 0; part < 2; ++part) changes[at(i, part)] = solved_[2 * factors_.place(i) + part];
}

std::array<double, 6> inverse_effective_mass(const PieceBody& a, const PieceBody& b, const PieceJoint& joint) {
    std::array<double, 6> inverse{};
    using End = std::pair<const PieceBody&, const Vec3&>;
    for (const auto& [body, lever] : {End(a, joint.lever_a), End(b, joint.lever_b)}) {
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
        auto& [of_bodies, of_joints, factors, numbered, number, places, slot, sources, columns, solved] =
            *known;  // the others follow from these
        bodies = of_bodies;
        joints = of_joints;
    }
    state(bodies, joints);
    if (state.sets()) known = std::make_shared<PieceCompliance>(std::move(bodies), std::move(joints));
}

}  // namespace floes
