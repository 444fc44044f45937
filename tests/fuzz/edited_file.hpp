#pragma once
// A file of HDF5 that the target itself wrote, damaged in one of three ways. So no such file stands in the corpus, and
// all inputs are of the file's present layout. The first byte of an input says which way:
//
//     damaged  any bytes are others, but not the mark before the digests of pages: without it HDF5 reads unchecked, in
//              a child process first, and is known to crash there
//     values   numbers and the configuration are others and the digests of pages are right, as in a file that somebody
//              made on purpose; datasets have no digests. So HDF5 is content, and what floes itself checks is reached
//     cut      the file ends at so many of 256 parts, as the second byte says, for 0 before the digests of pages; each
//              is tried once, since that, too, takes a child process
//
// From the third byte on there are changes: three bytes of place, one byte of length, and so many bytes.

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <bitset>
#include <cstring>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/bytes.hpp"
#include "fuzz/fuzz.hpp"
#include "hdf5/dataset.hpp"
#include "hdf5/pages.hpp"
#include "hdf5/read.hpp"
#include "store/file_calls.hpp"
#include "support/file_bytes.hpp"
#include "support/temporary_folder.hpp"

/// For the sanitizer: HDF5 keeps some memory of files that it refuses.
extern "C" [[gnu::used]] inline const char* __lsan_default_suppressions() {
    return "leak:libhdf5";
}

namespace floes::fuzz {

enum class Damage { damaged, values, cut };

/// What an input of a damaged file says.
struct FileInput {
    Damage damage;
    std::uint8_t choice;  ///< where it is cut, or for the target
    std::span<const std::uint8_t> changes;

    /// Of at least two bytes.
    explicit FileInput(std::span<const std::uint8_t> input)
        : damage(static_cast<Damage>(input[0] % 3)), choice(input[1]), changes(input.subspan(2)) {}
};

/// A part of the file that may be changed.
struct Stretch {
    std::size_t begin = 0;
    std::size_t size = 0;
};

/// A file, and what of it may be changed. Only what changes is written: whole files would be flushed to the disk.
class EditedFile {
  public:
    EditedFile(std::filesystem::path path, std::vector<Stretch> stretches)
        : path_(std::move(path)),
          file_(open_file(path_, O_RDWR)),
          whole_(file_bytes(path_)),
          stretches_(std::move(stretches)) {
        for (const Stretch& one : stretches_) size_ += one.size;
    }

    const std::filesystem::path& path() const { return path_; }
    std::span<const std::byte> whole() const { return whole_; }

    /// Takes all changes back, and makes these.
    void edit(std::span<const std::uint8_t> input) {
        for (const Stretch& one : changed_) write(one.begin, std::span(whole_).subspan(one.begin, one.size));
        changed_.clear();
        while (input.size() > 4) {
            const std::size_t place = static_cast<std::size_t>(input[0] | input[1] << 8 | input[2] << 16) % size_;
            const Stretch to = stretch_at(place);
            const std::size_t length = std::min({std::size_t{input[3]}, input.size() - 4, to.size});
            write(to.begin, std::as_bytes(input.subspan(4, length)));
            changed_.push_back({to.begin, length});
            input = input.subspan(4 + length);
        }
    }

    /// Makes the file end there, or have its whole length again.
    void cut(std::size_t size) {
        edit({});
        truncate_file(file_, size);
        if (size == whole_.size()) return;
        changed_.push_back({size, whole_.size() - size});
    }

  private:
    /// From the place in all stretches to the end of the one that it is in.
    Stretch stretch_at(std::size_t place) const {
        auto one = stretches_.begin();
        for (; place >= one->size; ++one) place -= one->size;
        return {one->begin + place, one->size - place};
    }

    void write(std::size_t at, std::span<const std::byte> bytes) {
        const auto written = ::pwrite(file_.get(), bytes.data(), bytes.size(), static_cast<::off_t>(at));
        require(written == static_cast<::ssize_t>(bytes.size()), "the file cannot be written");
    }

    std::filesystem::path path_;
    OpenFile file_;
    Bytes whole_;
    std::vector<Stretch> stretches_;
    std::size_t size_ = 0;
    std::vector<Stretch> changed_;
};

/// All but the mark of the digests of pages, which begins the last 28 bytes.
inline std::vector<Stretch> all_but_the_mark(const std::filesystem::path& path) {
    constexpr std::size_t foot = 28;
    constexpr std::size_t mark = 8;
    const std::size_t before = std::filesystem::file_size(path) - foot;
    return {{0, before}, {before + mark, foot - mark}};
}

/// Puts a dataset of the same numbers in the place of one: without chunks, checksums and attributes. Gives where in the
/// file its numbers are.
inline Stretch stored_plainly(const hdf5::Handle& file, const std::string& name) {
    const hdf5::Handle packed(H5Dopen2(file.id(), name.c_str(), H5P_DEFAULT), H5Dclose, "H5Dopen", name);
    const hdf5::Handle type(H5Dget_type(packed.id()), H5Tclose, "H5Dget_type", name);
    if (H5Tget_class(type.id()) == H5T_STRING) return {};
    const hdf5::Handle sizes(H5Dget_space(packed.id()), H5Sclose, "H5Dget_space", name);
    std::vector<hsize_t> of(static_cast<std::size_t>(H5Sget_simple_extent_ndims(sizes.id())));
    H5Sget_simple_extent_dims(sizes.id(), of.data(), nullptr);
    const hdf5::Handle space(H5Screate_simple(static_cast<int>(of.size()), of.data(), nullptr), H5Sclose,
                             "H5Screate_simple", name);
    Bytes values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id())) * H5Tget_size(type.id()));
    H5Dread(packed.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Ldelete(file.id(), name.c_str(), H5P_DEFAULT);
    const hdf5::Handle plain(
        H5Dcreate2(file.id(), name.c_str(), type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose,
        "H5Dcreate", name);
    H5Dwrite(plain.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    const haddr_t at = H5Dget_offset(plain.id());
    return at == HADDR_UNDEF ? Stretch{} : Stretch{at, values.size()};
}

/// Takes the digests of datasets out of the file, and gives the places of its numbers and of the text `configuration`.
inline std::vector<Stretch> without_digests(const std::filesystem::path& path, const std::string& configuration) {
    std::filesystem::resize_file(path, hdf5::CheckedPages::open(path)->size());
    std::vector<Stretch> stretches;
    {
        const hdf5::Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose, "H5Fopen", path.string());
        require(H5Adelete(file.id(), hdf5::contents_attribute) >= 0, "a file has no digest");
        for (const std::string& name : hdf5::paths_of(file.id()).datasets) {
            const Stretch numbers = stored_plainly(file, name);
            if (numbers.size > 0) stretches.push_back(numbers);
            const hdf5::Handle dataset(H5Dopen2(file.id(), name.c_str(), H5P_DEFAULT), H5Dclose, "H5Dopen", name);
            if (hdf5::has_attribute(dataset.id(), hdf5::digest_attribute))
                H5Adelete(dataset.id(), hdf5::digest_attribute);
        }
    }
    const Bytes bytes = file_bytes(path);
    const auto text = std::ranges::search(bytes, std::as_bytes(std::span(configuration)));
    require(!text.empty() && !stretches.empty(), "a file has no numbers, or no configuration");
    stretches.push_back({static_cast<std::size_t>(text.begin() - bytes.begin()), configuration.size()});
    hdf5::append_page_digests(path);
    return stretches;
}

/// The two forms of a file in which it is damaged.
class DamagedFiles {
  public:
    /// `write(path)` writes the whole file, which has the text `configuration` in it.
    template <class Write>
    DamagedFiles(const Write& write, const std::string& configuration)
        : folder_(),
          damaged_{written(folder_ / "a.h5", write), all_but_the_mark(folder_ / "a.h5")},
          values_{written(folder_ / "b.h5", write), without_digests(folder_ / "b.h5", configuration)},
          pages_(hdf5::CheckedPages::open(values_.path())->size()) {
        // HDF5 keeps the memory it has taken: it is not instrumented, and a file takes a fifth less time.
        constexpr int no_limit = -1;
        H5set_free_list_limits(no_limit, no_limit, no_limit, no_limit, no_limit, no_limit);
    }

    /// The whole file.
    const std::filesystem::path& whole() {
        damaged_.cut(damaged_.whole().size());
        return damaged_.path();
    }

    /// The damaged file; empty for a cut that was tried before.
    std::filesystem::path damaged(const FileInput& input) {
        if (input.damage == Damage::values) {
            values_.edit(input.changes);
            std::filesystem::resize_file(values_.path(), pages_);
            hdf5::append_page_digests(values_.path());
            return values_.path();
        }
        if (input.damage == Damage::damaged) {
            damaged_.edit(input.changes);
            return damaged_.path();
        }
        if (cuts_.test(input.choice)) return {};
        cuts_.set(input.choice);
        const std::size_t without_digests = hdf5::CheckedPages::open(whole())->size();
        damaged_.cut(input.choice == 0 ? without_digests : damaged_.whole().size() * input.choice / cuts_.size());
        return damaged_.path();
    }

  private:
    template <class Write>
    static std::filesystem::path written(const std::filesystem::path& path, const Write& write) {
        write(path);
        return path;
    }

    TemporaryFolder folder_;  // not in memory: HDF5 asks for the real path
    EditedFile damaged_;
    EditedFile values_;
    std::uint64_t pages_;  ///< bytes of values_ before the digests of its pages
    std::bitset<256> cuts_;
};

}  // namespace floes::fuzz
