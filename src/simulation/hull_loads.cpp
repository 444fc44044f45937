#include "simulation/hull_loads.hpp"

#include <utility>

#include "core/state_archive.hpp"
#include "shapes/overlap.hpp"

namespace floes {

HullLoads::HullLoads(const Shape& shape, std::vector<ConvexSolid> solids, std::size_t steps)
    : solids_(std::move(solids)) {
    if (const std::size_t parts = shape.parts().size(); parts > 1) parts_.resize(parts);
    if (!parts_.empty()) pieces_ = shape.solids();
    if (pieces_ == solids_) pieces_.clear();
    for (PartHistory& part : parts_)
        for (std::vector<double>* one : part.all()) one->reserve(steps);
    for (std::vector<double>* one : {&yaw_, &roll_, &pitch_}) one->reserve(steps);
}

void HullLoads::add(std::span<const ContactForce> contacts, BodyId structure, const StructurePose& pose,
                    const Vec3& moment) {
    const Vec3 own = pose.in_own_axes(moment);
    roll_.push_back(own.x());
    yaw_.push_back(own.y());
    pitch_.push_back(own.z());
    if (parts_.empty()) return;
    for (PartHistory& part : parts_)
        for (std::vector<double>* one : part.all()) one->push_back(0);
    for (const ContactForce& one : contacts) {
        if (one.solid < 0) continue;
        const Vec3 force = pose.in_own_axes((one.a == structure ? 1.0 : -1.0) * (one.normal + one.friction));
        const Vec3 arm = pose.in_own_axes(one.point - pose.position);
        const ConvexSolid& touched = solids_[static_cast<std::size_t>(one.solid)];
        PartHistory& part = parts_[static_cast<std::size_t>(part_at(touched, pieces_, arm))];
        part.surge.back() -= force.x();
        part.sway.back() += force.z();
        part.heave.back() += force.y();
        part.normal.back() += one.normal.norm();
    }
}

std::vector<PartLoad> HullLoads::parts(const Averaging& how) const {
    std::vector<PartLoad> loads;
    for (const PartHistory& part : parts_) loads.push_back(part_load(part, how));
    return loads;
}

void HullLoads::archive(StateArchive& state) {
    auto& [solids, pieces, histories, yaws, rolls, pitches] = *this;
    state(histories, yaws, rolls, pitches);
}

}  // namespace floes
