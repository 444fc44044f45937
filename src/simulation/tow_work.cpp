#include "simulation/tow_work.hpp"

#include "core/state_archive.hpp"

namespace floes {
namespace {

/// 0.5 (v·p + ω·l) of the ice and the water that it carries.
double kinetic_energy(const BodyState& state, double mass, const Vec3& inertia, const CarriedWater& water) {
    const Vec3 v = state.rotation.transpose() * state.velocity;
    const Vec3 w = state.rotation.transpose() * state.angular_velocity;
    const double ice = mass * v.squaredNorm() + w.dot(inertia.cwiseProduct(w));
    const double along = water.in_plane * (v.x() * v.x() + v.z() * v.z()) + water.yaw * w.y() * w.y();
    const double normal = water.normal * v.y() * v.y() + water.zz * w.x() * w.x() + water.xx * w.z() * w.z() +
                          2 * (v.y() * (water.x * w.z() - water.z * w.x()) - water.xz * w.x() * w.z());
    return 0.5 * (ice + along + normal);
}

}  // namespace

TowWork::TowWork(const Scenario& scenario, const FloeSet& floes, const IceField& ice, BodyId structure)
    : first_step_(scenario.first_window_step()),
      time_step_(scenario.general.time_step),
      gravity_(scenario.general.gravity),
      structure_(structure),
      carried_(1 + scenario.water.isotropic_mass()),
      speed_(scenario.structure.speed),
      paced_(scenario.path.any()) {
    measure(floes, ice);
}

void TowWork::measure(const FloeSet& floes, const IceField& ice) {
    mass_.clear();
    weight_.clear();
    inertia_.clear();
    for (const IceElement& element : ice.elements()) {
        const auto floe = static_cast<std::size_t>(element.floe);
        const FloeShape& shape = floes.shape(floe);
        const CutElement& cut = ice.cut_element(element);
        const double ice_mass = shape.element_mass(floes.material(floe).ice, cut);
        mass_.push_back(ice_mass * carried_);
        weight_.push_back(ice_mass * gravity_);
        const double thin = shape.thickness * shape.thickness;
        const Vec3 over_area(cut.zz, cut.xx + cut.zz, cut.xx);
        inertia_.push_back(mass_.back() * (over_area / cut.area + Vec3(thin, 0, thin) / 12));
    }
    const std::size_t count = ice.elements().size();
    for (std::vector<Wrench>& term : terms_) term.resize(count);
    for (std::vector<Vec3>* vectors : {&velocity_, &angular_velocity_, &position_}) vectors->resize(count);
    contacts_.reserve(8 * count);
}

void TowWork::split_water(WaterLanes& water, double structure_x) {
    std::size_t last = 0;  // of those that act
    for (std::size_t k = 0; k < terms_.size(); ++k)
        if (water.acts(k)) last = k;
    for (std::size_t k = 0; k <= last; ++k) {
        if (!water.acts(k)) continue;
        water.compute(structure_x, k + 1);
        for (std::size_t i = 0; i < terms_[k].size(); ++i) terms_[k][i] = water.is_set(i) ? water.wrench(i) : Wrench{};
    }
    for (std::size_t k = last; k > 0; --k) {
        if (!water.acts(k)) continue;
        std::size_t before = k - 1;
        while (before > 0 && !water.acts(before)) --before;
        for (std::size_t i = 0; i < terms_[k].size(); ++i) {
            terms_[k][i].force -= terms_[before][i].force;
            terms_[k][i].moment -= terms_[before][i].moment;
        }
    }
}

void TowWork::add(const World& world, const IceField& ice, const Sheets& sheets, const PieceWater& water,
                  const StructureMotion& motion, std::span<const BodyState> before, std::span<const BodyState> after) {
    for (std::size_t i = 0; i < before.size(); ++i) {
        velocity_[i] = 0.5 * (before[i].velocity + after[i].velocity);
        angular_velocity_[i] = 0.5 * (before[i].angular_velocity + after[i].angular_velocity);
        position_[i] = before[i].position;
    }
    const double before_step = together(sum_);
    const Vec3 force = world.contact_force(structure_);
    const Vec3 moment = add_contacts(world, ice, sheets, motion);
    const double load = -force.dot(motion.towed()) - moment.dot(motion.towed_turning());
    sum_.giving_way +=
        force.dot(motion.velocity() - motion.towed()) + moment.dot(motion.angular_velocity() - motion.towed_turning());
    add_water();
    add_motion(water, before, after);
    sum_.joints -= ice.joint_power(world, before, velocity_, angular_velocity_);
    sum_.rest += load - (together(sum_) - before_step);
    way_ += motion.pace();
    ++steps_;
}

/// Gives the moment of the ice about the structure's reference point, N m.
Vec3 TowWork::add_contacts(const World& world, const IceField& ice, const Sheets& sheets,
                           const StructureMotion& motion) {
    world.read_contacts(contacts_);
    Vec3 moment = Vec3::Zero();
    for (const ContactForce& contact : contacts_) {
        bool hull = false;
        const Vec3 on_a = contact.normal + contact.friction;
        const auto velocity = [&](BodyId body) -> Vec3 {
            if (body == structure_) {
                hull = true;
                const Vec3 arm = contact.point - motion.after().position;
                moment += arm.cross(body == contact.a ? on_a : Vec3(-on_a));
                return motion.velocity() + motion.angular_velocity().cross(arm);
            }
            const std::optional<std::size_t> element = ice.element_of(body);
            if (!element) {  // an ice sheet
                const Vec3 sheet = sheets.velocity(body);
                sum_.driving += (body == contact.a ? on_a : Vec3(-on_a)).dot(sheet);
                return sheet;
            }
            const std::size_t i = *element;
            return velocity_[i] + angular_velocity_[i].cross(contact.point - position_[i]);
        };
        const Vec3 sliding = velocity(contact.a) - velocity(contact.b);
        (hull ? sum_.hull_friction : sum_.ice_friction) -= contact.friction.dot(sliding);
        (hull ? sum_.hull_crushing : sum_.ice_crushing) -= contact.normal.dot(sliding);
    }
    return moment;
}

void TowWork::add_water() {
    for (std::size_t k = 0; k < terms_.size(); ++k) {
        double& share = sum_.*water_terms[k].work;
        for (std::size_t i = 0; i < velocity_.size(); ++i) {
            const double against_weight = k == 0 ? weight_[i] * velocity_[i].y() : 0;  // which buoyancy lifts
            const auto& [force, moment] = terms_[k][i];
            share -= (force.dot(velocity_[i]) + moment.dot(angular_velocity_[i])) - against_weight;
        }
    }
}

void TowWork::add_motion(const PieceWater& water, std::span<const BodyState> before, std::span<const BodyState> after) {
    for (std::size_t i = 0; i < before.size(); ++i) {
        const CarriedWater& carried = water.carried(i);
        sum_.motion += (kinetic_energy(after[i], mass_[i], inertia_[i], carried) -
                        kinetic_energy(before[i], mass_[i], inertia_[i], carried)) /
                       time_step_;
    }
}

WorkShares TowWork::shares() const {
    WorkShares mean = sum_;
    const double way = paced_ ? way_ : steps_ * speed_;
    const double per = way > 0 ? 1 / way : 0;
    for (const auto share : all_work_shares) mean.*share *= per;
    return mean;
}

void TowWork::archive(StateArchive& state) {
    auto& [first_step, time_step, gravity, structure, carried, speed, way, paced, mass, weight, inertia, terms,
           velocity, angular_velocity, position, contacts, sum, steps] = *this;
    state(way, sum, steps);
}

}  // namespace floes
