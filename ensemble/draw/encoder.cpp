#include "draw/encoder.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "core/descriptor.hpp"
#include "core/error.hpp"

namespace floes {
namespace {

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

/// Pictures through a socket to ffmpeg.
class Ffmpeg final : public Encoder {
  public:
    Ffmpeg(std::filesystem::path path, const FilmShape& shape) : path_(std::move(path)) {
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
        words.push_back(path_.string());
        std::vector<char*> arguments;
        for (std::string& word : words) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        ::posix_spawn_file_actions_init(&actions);
        ::posix_spawn_file_actions_adddup2(&actions, read_end.get(), STDIN_FILENO);
        const int error = ::posix_spawnp(&process_, "ffmpeg", &actions, nullptr, arguments.data(), environ);
        ::posix_spawn_file_actions_destroy(&actions);
        if (error != 0)
            throw InputError(fmt::format(
                "{} is made by ffmpeg, which cannot be started ({}); install the package ffmpeg, or give the film the "
                "ending .apng, which needs nothing else.",
                path_.string(), std::strerror(error)));
    }
    ~Ffmpeg() override {
        write_end_.close();
        if (process_ > 0) ::waitpid(process_, nullptr, 0);
    }

    void add(const Canvas& picture) override {
        std::span<const std::uint8_t> left = picture.pixels();
        while (!left.empty()) {
            const ssize_t written = ::send(write_end_.get(), left.data(), left.size(), MSG_NOSIGNAL);
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) fail();
            left = left.subspan(static_cast<std::size_t>(written));
        }
    }

    void finish() override {
        write_end_.close();
        int status = 0;
        ::waitpid(std::exchange(process_, -1), &status, 0);
        if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) fail();
    }

  private:
    [[noreturn]] void fail() const {
        throw RunError(fmt::format("ffmpeg could not write {}; its messages are above.", path_.string()));
    }

    std::filesystem::path path_;
    Descriptor write_end_;
    pid_t process_ = -1;
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
        if (!file_)
            throw RunError(fmt::format("{} cannot be written ({}); does the folder exist, and has it free space?",
                                       path_.string(), std::strerror(errno)));
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

}  // namespace

std::unique_ptr<Encoder> make_encoder(const std::filesystem::path& path, const FilmShape& shape) {
    const std::string ending = path.extension().string();
    if (ending == ".apng") return std::make_unique<AnimatedPng>(path, shape);
    if (codec_of(ending).empty())
        throw InputError(
            fmt::format("{} has no ending of a film; give .mp4, .webm, .webp, .gif or .apng.", path.string()));
    return std::make_unique<Ffmpeg>(path, shape);
}

}  // namespace floes
