#include "draw/film.hpp"

#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>
#include <zlib.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/descriptor.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "draw/canvas.hpp"
#include "store/file_calls.hpp"

namespace floes {

namespace {

// Pictures one after another into a film file.

class Encoder {
  public:
    virtual ~Encoder() = default;
    /// All pictures have the same size.
    virtual void add(const Canvas& picture) = 0;
    /// Completes the file. Throws RunError when that fails.
    virtual void finish() = 0;
};

/// What comes in.
struct FilmShape {
    int width = 0;     ///< pixels
    int height = 0;    ///< pixels
    int pictures = 0;  ///< how many
    int rate = 0;      ///< pictures a second
};

/// What ffmpeg is told for each ending. 4:2:0 is what players take.
std::vector<std::string> codec_of(const std::string& ending) {
    if (ending == ".mp4")
        return {"-c:v", "libx264", "-pix_fmt", "yuv420p", "-crf", "23", "-movflags", "+faststart", "-f", "mp4"};
    if (ending == ".webm")
        return {"-c:v", "libvpx-vp9", "-pix_fmt", "yuv420p", "-crf", "34", "-b:v", "0", "-row-mt", "1", "-f", "webm"};
    if (ending == ".webp") return {"-c:v", "libwebp_anim", "-q:v", "40", "-loop", "0", "-f", "webp"};
    if (ending == ".gif")
        return {"-vf", "split[a][b];[a]palettegen=max_colors=128[p];[b][p]paletteuse=dither=none", "-f", "gif"};
    return {};
}

InputError no_ffmpeg(const std::filesystem::path& path, const std::string& why) {
    return InputError(
        fmt::format("{} is made by ffmpeg, which cannot be started ({}); install the package ffmpeg, or give the film "
                    "the ending .apng, which needs nothing else.",
                    path.string(), why));
}

/// Pictures through a socket to ffmpeg.
class Ffmpeg final : public Encoder {
  public:
    Ffmpeg(std::filesystem::path path, const FilmShape& shape, Seconds longest_picture)
        : path_(std::move(path)), longest_picture_(longest_picture), pictures_(shape.pictures) {
        std::array<int, 2> ends{};  // a socket, which tells of a reader that is gone by an error and not by a signal
        if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
            throw RunError(fmt::format("A socket to ffmpeg cannot be made ({}).", std::strerror(errno)));
        Descriptor read_end(ends[0]);
        write_end_ = Descriptor(ends[1]);
        std::vector<std::string> words{"ffmpeg",    "-y",
                                       "-loglevel", "error",
                                       "-f",        "rawvideo",
                                       "-pix_fmt",  "bgr0",
                                       "-s",        fmt::format("{}x{}", shape.width, shape.height),
                                       "-r",        std::to_string(shape.rate),
                                       "-i",        "-"};
        for (std::string& word : codec_of(path_.extension().string())) words.push_back(std::move(word));
        words.push_back("file:" + path_.string());  // a name may begin with "-" or have a colon
        const auto microseconds = std::chrono::duration_cast<std::chrono::microseconds>(longest_picture).count();
        const timeval limit{microseconds / 1'000'000, microseconds % 1'000'000};
        ::setsockopt(write_end_.get(), SOL_SOCKET, SO_SNDTIMEO, &limit, sizeof limit);
        process_.emplace(std::move(words), StartedProgram::Streams{.in = read_end.get(), .errors = STDERR_FILENO});
        if (!process_->fault().empty()) throw no_ffmpeg(path_, process_->fault());
    }

    void add(const Canvas& picture) override {
        std::span<const std::uint8_t> left = picture.pixels();
        while (!left.empty()) {
            const ssize_t written = ::send(write_end_.get(), left.data(), left.size(), MSG_NOSIGNAL);
            if (written < 0 && errno == EINTR) continue;
            if (written < 0 && (errno == EAGAIN || errno == EWOULDBLOCK))
                throw too_slow("took no picture", longest_picture_);
            if (written < 0) fail();
            left = left.subspan(static_cast<std::size_t>(written));
        }
    }

    void finish() override {
        write_end_.close();
        const Seconds longest = longest_picture_ + Seconds(pictures_);  // a .gif is made when its last picture is known
        if (!process_->wait(longest)) throw too_slow("did not end", longest);
        if (process_->status() != 0) fail();
    }

  private:
    [[noreturn]] void fail() const {
        throw RunError(fmt::format("ffmpeg could not write {}; its messages are above.", path_.string()));
    }

    RunError too_slow(const char* what, Seconds longest) const {
        return RunError(fmt::format(
            "ffmpeg, which makes {}, {} within {} and was ended; give the film the ending .apng, which needs "
            "no other program.",
            path_.string(), what, duration_in_figures(longest.count())));
    }

    std::filesystem::path path_;
    Seconds longest_picture_;
    int pictures_;
    Descriptor write_end_;
    std::optional<StartedProgram> process_;  // the last: it is ended before its socket is closed
};

constexpr std::size_t length_and_type = 8;
constexpr std::size_t signature_bytes = 8;
constexpr std::size_t crc_bytes = 4;

std::string big_endian(std::uint32_t value, int bytes = 4) {
    std::string text;
    for (int k = bytes - 1; k >= 0; --k) text.push_back(static_cast<char>(value >> (8 * k) & 0xff));
    return text;
}

/// An animated PNG: the chunks of one picture after another, numbered (PNG specification, third edition, 11.3).
class AnimatedPng final : public Encoder {
  public:
    AnimatedPng(std::filesystem::path path, const FilmShape& shape)
        : path_(std::move(path)), file_(path_, std::ios::binary), shape_(shape) {}

    void add(const Canvas& picture) override {
        const std::string png = picture.png();
        const bool first = next_ == 0;
        std::string data;
        for (std::size_t at = signature_bytes; at + length_and_type + crc_bytes <= png.size();) {
            std::uint32_t length = 0;
            for (std::size_t k = 0; k < 4; ++k) length = length << 8 | static_cast<unsigned char>(png[at + k]);
            const std::string type = png.substr(at + 4, 4);
            const std::string payload = png.substr(at + length_and_type, length);
            if (type == "IHDR" && first) {
                file_ << png.substr(0, signature_bytes);
                chunk(type, payload);
                chunk("acTL", big_endian(static_cast<std::uint32_t>(shape_.pictures)) + big_endian(0));
            }
            if (type == "IDAT") data += payload;
            at += length_and_type + length + crc_bytes;
        }
        chunk("fcTL", big_endian(next_++) + big_endian(static_cast<std::uint32_t>(picture.width())) +
                          big_endian(static_cast<std::uint32_t>(picture.height())) + big_endian(0) + big_endian(0) +
                          big_endian(1, 2) + big_endian(static_cast<std::uint32_t>(shape_.rate), 2) +
                          std::string(2, '\0'));
        if (first) {
            chunk("IDAT", data);
        } else {
            chunk("fdAT", big_endian(next_++) + data);
        }
    }

    void finish() override {
        chunk("IEND", {});
        file_.close();
        if (!file_) throw not_written(path_, std::strerror(errno));
    }

  private:
    void chunk(const std::string& type, const std::string& payload) {
        const std::string body = type + payload;
        const auto* bytes = reinterpret_cast<const unsigned char*>(body.data());
        file_ << big_endian(static_cast<std::uint32_t>(payload.size())) << body
              << big_endian(static_cast<std::uint32_t>(::crc32_z(0, bytes, body.size())));
    }

    std::filesystem::path path_;
    std::ofstream file_;
    FilmShape shape_;
    std::uint32_t next_ = 0;  ///< number of the next chunk of a frame
};

/// By the ending of `path`, as write_film().
std::unique_ptr<Encoder> make_encoder(const std::filesystem::path& path, const FilmShape& shape,
                                      Seconds longest_picture) {
    const std::string ending = path.extension().string();
    if (ending == ".apng") return std::make_unique<AnimatedPng>(path, shape);
    if (codec_of(ending).empty())
        throw InputError(
            fmt::format("{} has no ending of a film; give .mp4, .webm, .webp, .gif or .apng.", path.string()));
    return std::make_unique<Ffmpeg>(path, shape, longest_picture);
}

}  // namespace

void expect_encoder(const std::filesystem::path& path) {
    if (!codec_of(path.extension().string()).empty() && !is_program("ffmpeg"))
        throw no_ffmpeg(path, "it is not in the PATH");
}

void write_film(const std::filesystem::path& path, const Recording& recording, const PictureStyle& style, int rate,
                const std::function<void(double)>& progress, Seconds longest_picture) {
    const Stage stage(recording.subject(), recording.outcome());
    const int height = picture_height(style, recording.subject());
    const std::unique_ptr<Encoder> film =
        make_encoder(path, {style.width, height, recording.frames(), rate}, longest_picture);
    Canvas picture(style.width, height);
    Frame frame;
    for (int k = 0; k < recording.frames(); ++k) {
        recording.read(k, frame);
        draw_picture(picture, stage, frame, style);
        film->add(picture);
        progress(static_cast<double>(k + 1) / recording.frames());
    }
    film->finish();
}

}  // namespace floes
