#include "player/replay_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>
#include <ostream>

#include "core/base64.hpp"
#include "core/error.hpp"
#include "player/assets.hpp"
#include "player/frame_packer.hpp"
#include "player/page_header.hpp"
#include "tables/table.hpp"

namespace floes {
namespace {

/// Every `stride`-th frame and the last; nothing once they take more than `most` bytes, with an estimate of the whole.
struct Attempt {
    std::optional<PackedFrames> frames;
    double expected = 0;  // bytes
};

Attempt pack(const Recording& recording, const Quanta& quanta, int stride, std::size_t most) {
    FramePacker packer(quanta, static_cast<int>(recording.layout().elements.size()));
    Frame frame;
    const int last = recording.frames() - 1;
    for (int i = 0; i <= last; i = i == last ? last + 1 : std::min(i + stride, last)) {
        recording.read(i, frame);
        packer.add(frame);
        if (packer.size() > most) return {std::nullopt, static_cast<double>(packer.size()) * (last + 1) / (i + 1)};
    }
    PackedFrames frames = packer.finish();
    std::size_t size = 0;
    for (const auto& [name, stream] : streams_of(frames)) size += stream->size();
    if (size > most) return {std::nullopt, static_cast<double>(size)};
    return {std::move(frames), static_cast<double>(size)};
}

PackedFrames pack_within(const Recording& recording, const Quanta& quanta, std::size_t most) {
    for (int stride = 1;;) {
        Attempt attempt = pack(recording, quanta, stride, most);
        if (attempt.frames) return std::move(*attempt.frames);
        if (stride >= recording.frames())
            throw InputError(
                fmt::format("A page of this replay does not fit into the bytes it may take; its first and "
                            "last frames alone take {:.0f} kB. Allow a larger page.",
                            attempt.expected / 1e3));
        // Frames farther apart differ more, so fewer of them take more bytes each.
        stride = std::max(stride + 1, static_cast<int>(stride * attempt.expected / static_cast<double>(most)));
    }
}

/// JSON that may stand in a script element.
std::string in_a_script(std::string json) {
    for (std::size_t at = 0; (at = json.find("</", at)) != std::string::npos;) json.replace(at, 2, "<\\/");
    return json;
}

void write_frames(std::ostream& page, const PackedFrames& frames) {
    for (const auto& [name, stream] : streams_of(frames)) {
        page << fmt::format("<script type=\"application/octet-stream\" id=\"{}\">", name);
        write_base64(page, *stream);
        page << "</script>\n";
    }
}

/// Calls `text` for each part of a template and `name` for each {{name}} in it.
template <typename Text, typename Name>
void expand(std::string_view pattern, const Text& text, const Name& name) {
    for (std::size_t at = 0;;) {
        const std::size_t open = pattern.find("{{", at);
        text(pattern.substr(at, open - at));
        if (open == std::string_view::npos) return;
        const std::size_t close = pattern.find("}}", open);
        name(pattern.substr(open + 2, close - open - 2));
        at = close + 2;
    }
}

std::string_view pattern() {
    return asset("replay.html").value();
}

std::size_t size_without_frames() {
    std::size_t size = 0;
    expand(
        pattern(), [&](std::string_view text) { size += text.size(); },
        [&](std::string_view name) { size += asset(name).value_or("").size(); });
    return size;
}

}  // namespace

void write_replay_page(std::ostream& page, const Recording& recording, const PageOptions& options) {
    const Quanta quanta = quanta_of(recording);
    const std::size_t header_size = page_header(recording, quanta, {}, options.start).size();
    const std::size_t fixed = size_without_frames() + header_size + 1000;
    const std::size_t most = options.most_bytes > fixed ? (options.most_bytes - fixed) / 4 * 3 : 0;
    const PackedFrames frames = pack_within(recording, quanta, most);
    const RecordingSubject& subject = recording.subject();
    expand(
        pattern(), [&](std::string_view text) { page << text; },
        [&](std::string_view name) {
            if (name == "title")
                page << html_escaped(
                    fmt::format("{}: case {}, member {}", subject.campaign, subject.case_name, subject.member));
            else if (name == "header")
                page << in_a_script(page_header(recording, quanta, frames, options.start));
            else if (name == "frames")
                write_frames(page, frames);
            else
                page << asset(name).value();
        });
}

void write_replay_page(const std::filesystem::path& path, const Recording& recording, const PageOptions& options) {
    std::ofstream file(path, std::ios::binary);
    if (file) write_replay_page(file, recording, options);
    file.close();
    if (!file)
        throw RunError(fmt::format("{} cannot be written ({}); does the folder exist, and has it free space?",
                                   path.string(), std::strerror(errno)));
}

}  // namespace floes
