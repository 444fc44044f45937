#include "fmu/fmu_file.hpp"

#include <zlib.h>

#include <cstdint>
#include <initializer_list>
#include <limits>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

namespace floes {

namespace {

struct ZipField {
    std::uint64_t value;
    int bytes;
};

/// Little endian.
std::string bytes_of(std::initializer_list<ZipField> fields) {
    std::string text;
    for (const auto& [value, bytes] : fields)
        for (int k = 0; k < bytes; ++k) text += static_cast<char>(value >> (8 * k) & 0xff);
    return text;
}

/// As zip wants it: without a header of its own.
std::string deflated(const std::string& bytes) {
    z_stream stream{};
    if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY) != Z_OK)
        throw RunError("There is no memory to compress a file of the FMU.");
    std::string made(deflateBound(&stream, bytes.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(made.data());
    stream.avail_out = static_cast<uInt>(made.size());
    const int end = deflate(&stream, Z_FINISH);
    made.resize(stream.total_out);
    deflateEnd(&stream);
    if (end != Z_STREAM_END) throw RunError("A file of the FMU could not be compressed.");
    return made;
}

/// For people who open the archive.
std::string index_page(const FmuDescription& of) {
    std::string rows;
    for (const FmuVariable& one : fmu_variables(of.mover)) {
        rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", one.name,
                            fmu_role_words.at(static_cast<std::size_t>(one.role)), one.unit, markup_escaped(one.words));
    }
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title></head><body>\n"
        "<h1>{0}</h1>\n<p>The load of ice floes on a hull that is moved {1} this FMU, made by {2}. Axes: X along the "
        "channel as the tow goes, Y to port, Z up, from where the tow has the hull; forces on the hull, at its axis at "
        "the height of the calm water.</p>\n<table>\n{3}</table>\n</body></html>\n",
        markup_escaped(of.model_name), hull_mover_words.at(static_cast<std::size_t>(of.mover)), of.program, rows);
}

}  // namespace

std::string zip_archive(const std::vector<ArchivedFile>& files) {
    constexpr std::uint32_t local_mark = 0x04034b50;
    constexpr std::uint32_t central_mark = 0x02014b50;
    constexpr std::uint32_t end_mark = 0x06054b50;
    constexpr std::uint32_t version = 20;        // 2.0, for deflate
    constexpr std::uint32_t date = 0x0021;       // 1 January 1980, the first that there is
    constexpr std::uint32_t unix_made = 3 << 8;  // so that the permissions below count
    constexpr std::uint32_t permissions = 0100755U << 16;
    std::string archive;
    std::string central;
    for (const auto& [name, bytes] : files) {
        FLOES_EXPECTS(!name.empty() && name.front() != '/');
        if (bytes.size() > std::numeric_limits<std::int32_t>::max())
            throw RunError(fmt::format("{} has {} bytes, more than an FMU can hold.", name, bytes.size()));
        const std::string packed = deflated(bytes);
        const auto crc = crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size()));
        const std::string facts = bytes_of({{version, 2},
                                            {0, 2},           // flags
                                            {Z_DEFLATED, 2},  // which zip counts as zlib does
                                            {0, 2},           // time
                                            {date, 2},
                                            {crc, 4},
                                            {packed.size(), 4},
                                            {bytes.size(), 4},
                                            {name.size(), 2},
                                            {0, 2}});  // extra field
        // Behind the facts: no comment, the first disk, a binary, and where the file is.
        central += bytes_of({{central_mark, 4}, {unix_made | version, 2}}) + facts +
                   bytes_of({{0, 2}, {0, 2}, {0, 2}, {permissions, 4}, {archive.size(), 4}}) + name;
        archive += bytes_of({{local_mark, 4}}) + facts + name + packed;
    }
    // The first of one disk, how many files, where the list of them is, and no comment.
    const std::string end = bytes_of({{end_mark, 4},
                                      {0, 4},
                                      {files.size(), 2},
                                      {files.size(), 2},
                                      {central.size(), 4},
                                      {archive.size(), 4},
                                      {0, 2}});
    return archive + central + end;
}

std::string fmu_file(FmuParts parts, FmiVersion version) {
    FmuDescription& of = parts.description;
    const std::string mover(hull_mover_words.at(static_cast<std::size_t>(of.mover)));
    of.token = digest_hex(fmt::format("{}\n{}\n{}\n{}", mover, of.program, parts.configuration, parts.library));
    const std::string binaries = version == FmiVersion::two ? "binaries/linux64/" : "binaries/x86_64-linux/";
    std::vector<ArchivedFile> files{{"modelDescription.xml", fmu_description(of, version)},
                                    {fmt::format("resources/{}", fmu_start),
                                     fmt::format("{}\n{}\n{}\n{}\n", mover, of.token, of.case_name, of.arrangement)},
                                    {fmt::format("resources/{}", fmu_configuration), parts.configuration},
                                    {fmt::format("{}{}.so", binaries, fmu_identifier), std::move(parts.library)},
                                    {"documentation/index.html", index_page(of)}};
    for (auto& [name, bytes] : parts.libraries) files.emplace_back(binaries + name, std::move(bytes));
    for (auto& [name, text] : parts.licences) files.emplace_back("documentation/licenses/" + name, std::move(text));
    return zip_archive(files);
}

}  // namespace floes
