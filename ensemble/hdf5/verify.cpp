#include "hdf5/verify.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.hpp"
#include "hdf5/dataset.hpp"
#include "hdf5/digest.hpp"
#include "hdf5/handle.hpp"
#include "hdf5/pages.hpp"
#include "hdf5/read.hpp"

namespace floes::hdf5 {
namespace {

std::vector<std::size_t> unreadable_rows(hid_t file, const std::string& path) {
    std::vector<std::size_t> found;
    RowReader<double> reader(file, path);
    for (std::size_t row = 0; row < reader.rows(); ++row) {
        try {
            reader.read(row);
        } catch (const DamagedFile&) {
            found.push_back(row);
        }
    }
    return found;
}

void check_dataset(hid_t file, const std::string& path, FileCheck& check) {
    DamagedDataset one{path, "", false, {}};
    try {
        const Handle dataset = open_dataset(file, path);
        const std::optional<StoredDigest> stored = read_digest(dataset.id());
        one.by_rows = stored && stored->kind == DigestKind::rows;
        if (!stored && check.has_digests) one.fault = fmt::format("{} has no digest", path);
        const StoredDigest found = digest_of(dataset, stored.value_or(StoredDigest{}).kind);
        if (stored) check_digest(dataset.id(), path, *stored, found);
    } catch (const DamagedFile& damage) {
        const std::string& fault = damage.fault();
        one.fault = fault.find(path) == std::string::npos ? fmt::format("{}: {}", path, fault) : fault;
        if (one.by_rows) one.rows = unreadable_rows(file, path);
    } catch (const RunError& error) {  // an error of the disk
        one.fault = error.what();
    }
    if (!one.fault.empty()) check.damaged.push_back(std::move(one));
}

void check_contents(hid_t file, std::span<const std::string_view> filetypes, FileCheck& check) {
    if (has_attribute(file, "filetype")) check.filetype = read_text_attribute(file, "filetype");
    if (has_attribute(file, "version"))
        check.version = fmt::format("{}", fmt::join(read_int_attribute(file, "version"), "."));
    const ContentsDigests stored = read_contents_digests(file);
    check.contents = stored.contents;
    check.has_digests = !stored.contents.empty();
    if (!check.has_digests && std::ranges::find(filetypes, check.filetype) == filetypes.end()) return;
    const Paths paths = paths_of(file);
    check.datasets = paths.datasets.size();
    for (const std::string& path : paths.unreadable)
        check.damaged.push_back({path, fmt::format("{} cannot be read", path), false, {}});
    for (const std::string& path : paths.datasets) check_dataset(file, path, check);
    if (check.has_digests && check.damaged.empty() && stored != contents_digests(file))
        check.fault = "its attributes, or the names of its datasets, are not those that were written";
}

}  // namespace

FileCheck check_file(const std::filesystem::path& path, std::span<const std::string_view> filetypes) {
    const QuietErrors quiet;
    FileCheck check;
    try {
        const Handle file = open_for_reading(path);
        check_contents(file.id(), filetypes, check);
        // HDF5 does not read every byte, for example not those between its objects.
        if (check.good()) check.between = first_page_fault(file.id());
    } catch (const DamagedFile& damage) {
        check.fault = damage.fault();
    } catch (const RunError& error) {
        check.fault = error.what();
    }
    return check;
}

}  // namespace floes::hdf5
