#pragma once
// The page of a replay, one self-contained HTML file, and what it plays: frames as few bytes, and thinned histories.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <span>
#include <vector>

#include "core/bytes.hpp"
#include "core/vector.hpp"
#include "draw/page_parts.hpp"
#include "replay/recording.hpp"
#include "simulation/record.hpp"

namespace floes {

// Frames of a replay as few bytes: numbers in whole quanta, each frame as its difference from the one before, and
// compressed. A whole member of the paper's tank (1701 elements, 1351 frames) takes 4 MB.
//
// Six streams, little endian; e elements, in the order of IceField::elements():
//   low, high    a frame: lower and upper bytes of 7 e int16 differences; x of all elements, then y, z, and the
//                w, x, y, z of their unit quaternions, whose signs are such that neighbouring frames are near each
//                other. An element that is not there has four zeros in place of them, and else what it had before
//   utilisation  a frame: e bytes of differences, %
//   numbers      a frame: 5 float32: time (s), load x, y, z (N), number of its contacts
//   contacts     a contact: 10 int16: point, normal force and friction on the ice, and 1 if it is one of the structure;
//                those among the ice only where their force is not too small to be seen
//   pieces       a change: 3 int32: frame, element, the piece that it then belongs to; frame 0 sets all

/// What a whole number stands for.
struct Quanta {
    Vec3 middle = Vec3::Zero();       ///< where positions are 0, m
    double length = 1;                ///< m
    double force = 1;                 ///< N
    double orientation = 1.0 / 4096;  ///< of a quaternion's part
    double least_force = 0;           ///< N: smaller ones among the ice are left out
};

/// Such that every position and every force fits into an int16. Reads all frames.
Quanta quanta_of(const Recording& recording);

enum class FrameStream : std::uint8_t { low, high, utilisation, numbers, contacts, pieces };
inline constexpr std::array<const char*, 6> stream_names{"low", "high", "utilisation", "numbers", "contacts", "pieces"};

struct PackedFrames {
    int frames = 0;
    std::array<Bytes, stream_names.size()> streams = {};
    std::vector<FloeCounts> floes = {};  ///< of each frame, where they come and go

    const Bytes& of(FrameStream stream) const { return streams.at(static_cast<std::size_t>(stream)); }
};

class FramePacker {
  public:
    FramePacker(const Quanta& quanta, int elements);

    /// Frames in order of time; all of them with the packer's number of elements.
    void add(const Frame& frame);
    int frames() const { return frames_; }
    /// Bytes so far, less what zlib still holds back.
    std::size_t size() const;
    /// The last call.
    PackedFrames finish();

  private:
    Deflater& packed(FrameStream stream) { return packed_.at(static_cast<std::size_t>(stream)); }
    void add_states(const Frame& frame);
    void add_utilisation(const Frame& frame);
    void add_contacts(const Frame& frame);
    void add_pieces(const Frame& frame);
    std::int16_t part_of_position(double value, int axis) const;

    Quanta quanta_;
    std::size_t elements_;
    std::vector<int> at_;  // of each element: where the frame has it, or -1
    int frames_ = 0;
    std::vector<std::int16_t> states_;  // of the frame before
    std::vector<std::uint8_t> percent_;
    std::vector<int> pieces_;
    Bytes low_, high_;  // of the frame; they keep their memory
    std::array<Deflater, stream_names.size()> packed_;
};

// A load history for the eye: few enough points to draw, with every peak.

/// values[k] is that of step steps[k].
struct ThinnedHistory {
    std::vector<int> steps;     ///< rising; index of the value in the whole history
    std::vector<float> values;  ///< N
};

/// The least and the largest value of each of at most `most / 2` equal parts of the steps [begin, end), in the order in
/// which they come; all values if they are not more than `most`.
ThinnedHistory thinned(std::span<const double> history, int begin, int end, int most);

// What the page of a replay knows besides its frames: what was run, the shapes, the cameras, joints that failed and the
// load history. For this module only.

// The page of a replay: one self-contained HTML file that plays a recording in any browser, opened from disk. It asks
// nothing of the network; three.js is part of it.

struct PageOptions {
    /// The page is at most this large. Where all frames would take more, only every second, third, ... is in it; the
    /// page moves the ice smoothly from one to the next and says how far apart they are.
    std::size_t most_bytes = 15'000'000;
    std::optional<double> start = {};  ///< s, that the page opens at; not given: its first frame
};

/// Frames are read one at a time, twice or oftener; what is kept of them is compressed, so memory is bounded by the
/// size of the page. Throws InputError when even its first and last frame are larger than that.
void write_replay_page(std::ostream& page, const Recording& recording, const PageOptions& options = {});

/// The same to a file. Throws RunError when it cannot be written.
void write_replay_page(const std::filesystem::path& path, const Recording& recording, const PageOptions& options = {});

}  // namespace floes
