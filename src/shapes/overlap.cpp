#include "shapes/overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "shapes/convex_solid.hpp"

namespace floes {
namespace {

constexpr double same_volume = 1e-5;  // of a piece's volume: STL's single precision on a thin piece
constexpr double least_gain = 1e-4;   // likewise: with less a piece is not continued
constexpr double kept_inside = 0.25;  // of a continuation's length, of which only the far end is taken off

const Polyhedron& body_of(const ConvexSolid& piece) {
    return std::get<Polyhedron>(piece.form);
}

/// Above 0: outside.
double height_over(const Polyhedron& body, const Vec3& point) {
    double most = -std::numeric_limits<double>::infinity();
    for (const Plane& plane : body.planes) most = std::max(most, plane.height(point));
    return most;
}

/// The part of the piece's face in a plane; nothing where it has none there.
std::optional<int> part_in(const ConvexSolid& piece, const Plane& plane, double slack) {
    const std::vector<Plane>& planes = body_of(piece).planes;
    const auto same = std::ranges::find_if(planes, [&](const Plane& one) { return same_plane(one, plane, slack); });
    if (same == planes.end()) return std::nullopt;
    return piece.face_parts.empty() ? piece.part : piece.face_parts[static_cast<std::size_t>(same - planes.begin())];
}

class Pieces {
  public:
    explicit Pieces(const std::vector<ConvexSolid>& pieces)
        : pieces_(pieces), slack_(plane_rounding * size_of(pieces)) {}

    bool holds(const Polyhedron& body, const Polyhedron& other) const {
        return std::ranges::all_of(other.corners,
                                   [&](const Vec3& corner) { return height_over(body, corner) <= slack_; });
    }

    /// Whole pieces come first: one that goes on askew into a part of the next ring of pieces no longer fits its own.
    Polyhedron continued(const Polyhedron& piece) const {
        Polyhedron body = with_whole_pieces(piece);
        while (std::optional<Polyhedron> larger = with_a_share(body)) body = std::move(*larger);
        return with_ends_inside(std::move(body));
    }

    std::vector<int> parts_of(const Polyhedron& body, const ConvexSolid& piece) const {
        std::vector<int> parts;
        for (const Plane& plane : body.planes) {
            std::optional<int> part = part_in(piece, plane, slack_);
            for (std::size_t k = 0; k < pieces_.size() && !part; ++k) part = part_in(pieces_[k], plane, slack_);
            parts.push_back(part.value_or(piece.part));
        }
        return parts;
    }

  private:
    /// Planes through the edges of a face, at right angles to it; the face is inside them.
    static std::vector<Plane> rim_of_face(const Polyhedron& body, std::size_t face) {
        const std::vector<int>& corners = body.faces[face];
        std::vector<Plane> rim;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Vec3& a = body.corner(corners, k);
            const Vec3& b = body.corner(corners, k + 1);
            const Vec3 outwards = (b - a).cross(body.planes[face].normal).normalized();
            rim.push_back({outwards, outwards.dot(a)});
        }
        return rim;
    }

    /// Whether the section of a piece in the plane of a face may share more with that face than an edge.
    bool meets_face(const Polyhedron& piece, const Plane& plane, std::span<const Plane> rim) const {
        const auto on_side = [&](double side) {
            return std::ranges::all_of(piece.corners,
                                       [&](const Vec3& one) { return side * plane.height(one) > slack_; });
        };
        if (on_side(1) || on_side(-1)) return false;
        std::vector<Vec3> section;
        for (const std::vector<int>& one : piece.faces) {
            for (std::size_t k = 0; k < one.size(); ++k) {
                const Vec3& a = piece.corner(one, k);
                const Vec3& b = piece.corner(one, k + 1);
                const double low = plane.height(a);
                const double high = plane.height(b);
                if (std::abs(low) <= slack_) section.push_back(a);
                if (low < -slack_ && high > slack_) section.emplace_back(a + (b - a) * (low / (low - high)));
            }
        }
        return std::ranges::none_of(rim, [&](const Plane& edge) {
            return std::ranges::all_of(section, [&](const Vec3& one) { return edge.height(one) >= -slack_; });
        });
    }

    /// Where neighbours alone do not fit, those behind them may: three quarters of a ring are not convex, the whole is.
    Polyhedron with_whole_pieces(Polyhedron body) const {
        for (std::size_t turn = 0; turn < 2 * body.faces.size();) {
            const bool behind = turn >= body.faces.size();
            std::optional<Polyhedron> larger =
                through(body, turn % body.faces.size(), {.whole = true, .behind = behind});
            turn = larger ? 0 : turn + 1;
            if (larger) body = std::move(*larger);
        }
        return body;
    }

    /// Continued through one face into shares of pieces: if there is one, through a face after which whole ones fit.
    std::optional<Polyhedron> with_a_share(const Polyhedron& body) const {
        std::optional<Polyhedron> first;
        const std::size_t before = pieces_in(body);
        for (std::size_t face = 0; face < body.faces.size(); ++face) {
            const std::optional<Polyhedron> larger = through(body, face, {.whole = false, .behind = false});
            if (!larger) continue;
            Polyhedron fuller = with_whole_pieces(*larger);
            if (pieces_in(fuller) > before) return fuller;
            if (!first) first = std::move(fuller);
        }
        return first;
    }

    std::size_t pieces_in(const Polyhedron& body) const {
        return static_cast<std::size_t>(
            std::ranges::count_if(pieces_, [&](const ConvexSolid& one) { return holds(body, body_of(one)); }));
    }

    /// Into what `body` may go on: whole pieces only; and also pieces that do not meet it at the face.
    struct Reach {
        bool whole;
        bool behind;
    };

    /// Whether a piece has nothing beyond a face of `body` and within the others, as far as a single plane tells.
    bool lies_beside(const Polyhedron& piece, const Polyhedron& body, std::size_t face) const {
        for (std::size_t k = 0; k < body.planes.size(); ++k) {
            const double side = k == face ? -1 : 1;
            const auto out = [&](const Vec3& one) { return side * body.planes[k].height(one) >= -slack_; };
            if (std::ranges::all_of(piece.corners, out)) return true;
        }
        return false;
    }

    /// What of a piece lies beyond a face of `body` and within its other faces. `whole` becomes false where those cut
    /// it.
    Polyhedron beyond(const Polyhedron& piece, const Polyhedron& body, std::size_t face, bool& whole) const {
        if (lies_beside(piece, body, face)) return {};
        Polyhedron part = piece.cut(body.planes[face].opposite(), slack_);
        const double before = part.volume();
        for (std::size_t k = 0; k < body.planes.size() && !part.empty(); ++k)
            if (k != face) part = part.cut(body.planes[k], slack_);
        whole = whole && (part.empty() || part.volume() > (1 - same_volume) * before);
        return part;
    }

    /// `body` continued through a face, if others go on there over the whole of it. Not where rounding leaves no body.
    std::optional<Polyhedron> through(const Polyhedron& body, std::size_t face, const Reach& reach) const try {
        const std::vector<Plane> rim = rim_of_face(body, face);
        std::vector<std::size_t> beside;
        for (std::size_t k = 0; k < pieces_.size(); ++k)
            if (meets_face(body_of(pieces_[k]), body.planes[face], rim)) beside.push_back(k);
        if (beside.empty()) return std::nullopt;
        const double before = body.volume();
        double gain = 0;
        bool whole = true;
        std::vector<Vec3> corners = body.corners;
        for (std::size_t k = 0; k < pieces_.size(); ++k) {
            if (!reach.behind && !std::ranges::binary_search(beside, k)) continue;
            const Polyhedron part = beyond(body_of(pieces_[k]), body, face, whole);
            if (part.empty()) continue;
            if (reach.whole && !whole) return std::nullopt;
            gain += part.volume();
            corners.insert(corners.end(), part.corners.begin(), part.corners.end());
        }
        if (gain < least_gain * before) return std::nullopt;
        Polyhedron larger = convex_hull(corners);
        const double after = larger.volume();
        if (std::abs(after - before - gain) > same_volume * after) return std::nullopt;
        return larger;
    } catch (const InputError&) {
        return std::nullopt;
    }

    /// Faces that are of none of the pieces that it holds whole move in by a share of their distance from those.
    Polyhedron with_ends_inside(Polyhedron body) const try {
        std::vector<Vec3> whole;
        for (const ConvexSolid& piece : pieces_)
            if (holds(body, body_of(piece)))
                whole.insert(whole.end(), body_of(piece).corners.begin(), body_of(piece).corners.end());
        const std::vector<Plane> planes = body.planes;
        Polyhedron trimmed = body;
        for (const Plane& plane : planes) {
            double length = std::numeric_limits<double>::infinity();
            for (const Vec3& corner : whole) length = std::min(length, -plane.height(corner));
            if (length > slack_) trimmed = trimmed.cut({plane.normal, plane.offset - kept_inside * length}, slack_);
        }
        return trimmed;
    } catch (const InputError&) {
        return body;
    }

    const std::vector<ConvexSolid>& pieces_;
    double slack_;
};

}  // namespace

std::vector<ConvexSolid> overlapping(const std::vector<ConvexSolid>& pieces) {
    const bool flat_faces = std::ranges::all_of(pieces, [](const ConvexSolid& one) {
        return std::holds_alternative<Polyhedron>(one.form) && one.place.isZero();
    });
    if (pieces.size() < 2 || !flat_faces) return pieces;
    const Pieces body(pieces);
    std::vector<ConvexSolid> found;
    for (const ConvexSolid& piece : pieces) {
        const auto held_by = [&](const ConvexSolid& one) { return body.holds(body_of(one), body_of(piece)); };
        if (std::ranges::any_of(found, held_by)) continue;
        Polyhedron larger = body.continued(body_of(piece));
        std::erase_if(found, [&](const ConvexSolid& one) { return body.holds(larger, body_of(one)); });
        if (larger == body_of(piece)) {
            found.push_back(piece);
            continue;
        }
        std::vector<int> parts = body.parts_of(larger, piece);
        found.emplace_back(std::move(larger), piece.part, std::move(parts));
    }
    return found;
}

int part_at(const ConvexSolid& touched, std::span<const ConvexSolid> pieces, const Vec3& point) {
    if (pieces.size() < 2 || !std::holds_alternative<Polyhedron>(touched.form)) return touched.part_at(point);
    const Polyhedron& body = body_of(touched);
    const Plane& face = *std::ranges::max_element(body.planes, {}, [&](const Plane& one) { return one.height(point); });
    double size = 0;
    for (const Vec3& corner : body.corners) size = std::max(size, (corner - body.corners.front()).norm());
    double nearest = std::numeric_limits<double>::infinity();
    int part = touched.part_at(point);
    for (const ConvexSolid& piece : pieces) {
        if (!std::holds_alternative<Polyhedron>(piece.form)) continue;
        const std::optional<int> own = part_in(piece, face, plane_rounding * size);
        if (!own) continue;
        const double height = height_over(body_of(piece), point);
        if (height >= nearest) continue;
        nearest = height;
        part = *own;
    }
    return part;
}

}  // namespace floes
