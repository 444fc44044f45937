#include "world/plane_contacts.hpp"

#include <algorithm>

#include "core/state_archive.hpp"

namespace floes {
namespace {

constexpr std::array<double, 9> upright{1, 0, 0, 0, 1, 0, 0, 0, 1};

constexpr std::array<std::int32_t, 2 * most_corners / 4> away = [] {
    std::array<std::int32_t, 2 * most_corners / 4> places{};
    places.fill(-1);
    return places;
}();

}  // namespace

void PlaneContacts::add_plane(std::uint32_t number, const Triple& origin, const Triple& normal) {
    planes_.push_back({number, origin, normal, std::vector<Places>(number, away)});
}

bool PlaneContacts::is_plane(std::uint32_t body) const {
    return std::ranges::any_of(planes_, [&](const Plane& plane) { return plane.number == body; });
}

void PlaneContacts::add() {
    for (Plane& plane : planes_) plane.places.push_back(away);
    if (!planes_.empty()) touching_.reserve(2 * planes_.front().places.size());
}

void PlaneContacts::move(std::uint32_t element, ContactStore& store) {
    for (Plane& plane : planes_) drop(plane.places[element], store);
    std::erase_if(touching_, [&](const Touching& one) { return one.b == element; });
}

void PlaneContacts::drop(Places& places, ContactStore& store) {
    for (std::int32_t& place : places) {
        if (place >= 0) store.give_back(place);
        place = -1;
    }
}

void PlaneContacts::find(std::span<const LooseElement> bodies, const BodyMotion* motions, ContactStore& store) {
    touching_.clear();
    for (Plane& plane : planes_) {
        for (std::uint32_t i = 0; i < bodies.size(); ++i) {
            const auto& [shape, radius] = bodies[i];
            if (shape == nullptr) continue;
            const double* at = motions[i].position;
            if (dot(plane.normal, Triple{at[0], at[1], at[2]} - plane.origin) > radius + shape->reach())
                drop(plane.places[i], store);
            else
                look(plane, i, *shape, motions[i], store);
        }
    }
}

void PlaneContacts::look(Plane& plane, std::uint32_t element, const IceShape& shape, const BodyMotion& motion,
                         ContactStore& store) {
    const PrismShape& prism = shape.prism();
    const double reach = shape.reach();
    const PrismPlace ground{nullptr, plane.origin.data(), upright.data()};
    const PrismPlace ice{&prism, motion.position, motion.rotation};
    const Triple inwards = Triple{} - plane.normal;
    const std::size_t corners = prism.corners.size();
    for (std::size_t first = 0; first < 2 * corners; first += 4) {
        std::int32_t& place = plane.places[element][first / 4];
        if (place >= 0) store[place].refresh(ground, ice, reach);
        for (std::size_t k = first; k < std::min(first + 4, 2 * corners); ++k) {
            const Corner& corner = prism.corners[k % corners];
            const double half = k < corners ? -prism.half_thickness : prism.half_thickness;
            const Triple at = to_world(ice, {corner.x, half, corner.z});
            const double height = dot(plane.normal, at - plane.origin);
            if (height > reach) continue;
            if (place < 0) place = store.take();
            store[place].add(ground, ice, at, inwards, height, reach);
        }
        if (place >= 0 && store[place].count() == 0) {
            store.give_back(place);
            place = -1;
        }
        if (place >= 0) touching_.push_back({plane.number, element, static_cast<std::int32_t>(first / 4), place});
    }
}

void PlaneContacts::archive(StateArchive& state) {
    auto& [planes, touching] = *this;
    state(touching);
    for (Plane& plane : planes) state(plane.places);
}

}  // namespace floes
