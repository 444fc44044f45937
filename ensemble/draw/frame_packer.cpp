#include "draw/frame_packer.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <type_traits>

#include <zlib.h>

#include "core/error.hpp"

namespace floes {

class Deflater::Stream {
  public:
    Stream() {
        if (deflateInit(&state_, Z_DEFAULT_COMPRESSION) != Z_OK) throw RunError("zlib has no memory to compress with");
    }
    ~Stream() { deflateEnd(&state_); }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;

    void feed(std::span<const std::byte> bytes, int flush) {
        // zlib's interface takes a pointer to what it only reads.
        state_.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes.data()));
        state_.avail_in = static_cast<uInt>(bytes.size());
        std::array<std::byte, 1 << 16> room;
        do {
            state_.next_out = reinterpret_cast<Bytef*>(room.data());
            state_.avail_out = static_cast<uInt>(room.size());
            deflate(&state_, flush);
            packed_.insert(packed_.end(), room.begin(), room.end() - state_.avail_out);
        } while (state_.avail_out == 0);
    }

    Bytes& packed() { return packed_; }

  private:
    z_stream state_{};
    Bytes packed_;
};

Deflater::Deflater() : stream_(std::make_unique<Stream>()) {}
Deflater::~Deflater() = default;
Deflater::Deflater(Deflater&&) noexcept = default;

void Deflater::add(std::span<const std::byte> bytes) {
    stream_->feed(bytes, Z_NO_FLUSH);
}

std::size_t Deflater::size() const {
    return stream_->packed().size();
}

Bytes Deflater::finish() {
    stream_->feed({}, Z_FINISH);
    return std::move(stream_->packed());
}

namespace {

constexpr double most = 32767;
constexpr std::size_t parts = 7;  // of an element's state

template <typename Number>
void put(Bytes& bytes, Number value) {
    using Bits = std::conditional_t<sizeof(Number) == 2, std::uint16_t, std::uint32_t>;
    const auto bits = std::bit_cast<Bits>(value);
    for (std::size_t k = 0; k < sizeof(Number); ++k) bytes.push_back(static_cast<std::byte>(bits >> (8 * k)));
}

std::int16_t rounded(double quanta) {
    return static_cast<std::int16_t>(std::lround(std::clamp(quanta, -most, most)));
}

bool of_structure(const FrameContact& contact) {
    return contact.other == touches_structure;
}

/// Forces among the ice below this share of the largest load would be arrows of a few pixels, and are most of them.
constexpr double least_share = 0.002;

}  // namespace

Quanta quanta_of(const Recording& recording) {
    Eigen::AlignedBox3d box;
    double force = 0;
    double load = 0;
    Frame frame;
    for (int i = 0; i < recording.frames(); ++i) {
        recording.read(i, frame);
        for (const BodyState& one : frame.elements) box.extend(one.position);
        load = std::max(load, frame.load.norm());
        for (const FrameContact& contact : frame.contacts) {
            box.extend(contact.point);
            force = std::max({force, contact.normal.cwiseAbs().maxCoeff(), contact.friction.cwiseAbs().maxCoeff()});
        }
    }
    Quanta quanta;
    if (box.isEmpty()) return quanta;
    quanta.middle = box.center();
    quanta.length = std::max(0.5 * box.sizes().maxCoeff(), 1e-6) / most;
    quanta.force = std::max(force, 1e-6) / most;
    quanta.least_force = least_share * load;
    return quanta;
}

FramePacker::FramePacker(const Quanta& quanta, int elements)
    : quanta_(quanta),
      elements_(static_cast<std::size_t>(elements)),
      states_(parts * elements_),
      percent_(elements_),
      pieces_(elements_, -1) {}

void FramePacker::add(const Frame& frame) {
    at_.assign(elements_, -1);
    for (std::size_t k = 0; k < frame.elements.size(); ++k) at_[frame.id(k)] = static_cast<int>(k);
    add_states(frame);
    add_utilisation(frame);
    add_contacts(frame);
    add_pieces(frame);
    ++frames_;
}

std::int16_t FramePacker::part_of_position(double value, int axis) const {
    return rounded((value - quanta_.middle[axis]) / quanta_.length);
}

void FramePacker::add_states(const Frame& frame) {
    low_.resize(states_.size());
    high_.resize(states_.size());
    for (std::size_t e = 0; e < elements_; ++e) {
        const auto before = [&](std::size_t part) -> std::int16_t& { return states_[part * elements_ + e]; };
        const bool there = at_[e] >= 0;
        const BodyState state = there ? frame.elements[static_cast<std::size_t>(at_[e])] : BodyState{};
        const Quat q(state.rotation);
        const std::array<double, 4> turn =
            there ? std::array<double, 4>{q.w(), q.x(), q.y(), q.z()} : std::array<double, 4>{};
        double along = frames_ == 0 ? turn[0] : 0;
        for (std::size_t k = 0; k < 4; ++k) along += turn[k] * before(3 + k);
        const double sign = along < 0 ? -1 : 1;
        std::array<std::int16_t, parts> now{};
        for (std::size_t k = 0; k < 3; ++k)
            now[k] = there ? part_of_position(state.position[static_cast<int>(k)], static_cast<int>(k)) : before(k);
        for (std::size_t k = 0; k < 4; ++k) now[3 + k] = rounded(sign * turn[k] / quanta_.orientation);
        for (std::size_t part = 0; part < parts; ++part) {
            const auto difference = static_cast<std::uint16_t>(now[part] - before(part));
            low_[part * elements_ + e] = static_cast<std::byte>(difference);
            high_[part * elements_ + e] = static_cast<std::byte>(difference >> 8);
            before(part) = now[part];
        }
    }
    packed_low_.add(low_);
    packed_high_.add(high_);
}

void FramePacker::add_utilisation(const Frame& frame) {
    Bytes differences(elements_);
    for (std::size_t e = 0; e < elements_; ++e) {
        const double used = at_[e] < 0 ? 0.0 : frame.utilisation[static_cast<std::size_t>(at_[e])];
        const auto now = static_cast<std::uint8_t>(std::lround(100 * std::clamp(used, 0.0, 2.0)));
        differences[e] = static_cast<std::byte>(now - percent_[e]);
        percent_[e] = now;
    }
    packed_utilisation_.add(differences);
}

void FramePacker::add_contacts(const Frame& frame) {
    Bytes bytes;
    float count = 0;
    for (const FrameContact& contact : frame.contacts) {
        if (!of_structure(contact) && (contact.normal + contact.friction).norm() < quanta_.least_force) continue;
        ++count;
        for (int axis = 0; axis < 3; ++axis) put(bytes, part_of_position(contact.point[axis], axis));
        for (const Vec3& force : {contact.normal, contact.friction})
            for (int axis = 0; axis < 3; ++axis) put(bytes, rounded(force[axis] / quanta_.force));
        put(bytes, static_cast<std::int16_t>(of_structure(contact) ? 1 : 0));
    }
    packed_contacts_.add(bytes);
    Bytes numbers;
    put(numbers, static_cast<float>(frame.time));
    for (int axis = 0; axis < 3; ++axis) put(numbers, static_cast<float>(frame.load[axis]));
    put(numbers, count);
    packed_numbers_.add(numbers);
}

void FramePacker::add_pieces(const Frame& frame) {
    Bytes changes;
    for (std::size_t e = 0; e < elements_; ++e) {
        if (at_[e] < 0) continue;
        const int piece = frame.pieces[static_cast<std::size_t>(at_[e])];
        if (piece == pieces_[e]) continue;
        pieces_[e] = piece;
        put(changes, frames_);
        put(changes, static_cast<std::int32_t>(e));
        put(changes, pieces_[e]);
    }
    packed_pieces_.add(changes);
}

std::size_t FramePacker::size() const {
    return packed_low_.size() + packed_high_.size() + packed_utilisation_.size() + packed_numbers_.size() +
           packed_contacts_.size() + packed_pieces_.size();
}

PackedFrames FramePacker::finish() {
    return {frames_,
            packed_low_.finish(),
            packed_high_.finish(),
            packed_utilisation_.finish(),
            packed_numbers_.finish(),
            packed_contacts_.finish(),
            packed_pieces_.finish()};
}

}  // namespace floes
