#pragma once
// Reads HDF5 files, which may be damaged: datasets, attributes and digests, and the check of a whole file. Only for
// sources of modules with HDF5 files of their own.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hdf5/dataset.hpp"
#include "hdf5/digest.hpp"
#include "hdf5/handle.hpp"

namespace floes::hdf5 {

/// Opens a dataset for reading; `name` may be a path. Throws RunError if it does not exist.
Handle open_dataset(hid_t parent, const std::string& name);

/// Its dataspace and its type in the file. Throw RunError if they cannot be read.
Handle stored_space(const Handle& dataset, const std::string& name);
Handle stored_type(const Handle& dataset, const std::string& name);

struct StoredShape {
    std::vector<hsize_t> sizes;
    hsize_t count = 1;       ///< of the values
    hsize_t row_values = 1;  ///< values of one row
    std::size_t value_bytes = 0;
    bool is_text = false;

    hsize_t rows() const { return sizes.empty() ? 1 : sizes.front(); }
};

/// How much of a dataset will be in memory at once.
enum class Portion { whole, row };

/// Throws RunError if the sizes are larger than the file can hold, so that no memory is allocated for a damaged size.
StoredShape shape_of(const Handle& dataset, const std::string& name, Portion portion);

/// All texts of a dataset. Throws RunError if they cannot be read.
std::vector<std::string> texts_of(const Handle& dataset, const std::string& name);

// The contents of a whole file: the paths of all datasets, and one digest over them.

/// Paths of all groups, or of all datasets, from the root on ("/members/status"), each group's in alphabetical order.
struct Paths {
    std::vector<std::string> groups;  ///< the root "/" is the first
    std::vector<std::string> datasets;
    std::vector<std::string> unreadable;  ///< of both kinds; only a search for damage continues with these
    std::vector<std::string> links;       ///< soft and external ones, which floes makes none of; not followed
};
Paths paths_of(hid_t file);

/// What other programs may have put into a file of floes: all that it is whole without is that.
struct Additions {
    std::set<std::string> objects;                             ///< paths of groups, datasets and links
    std::set<std::pair<std::string, std::string>> attributes;  ///< path of the object, and name

    /// "/mine", "the attribute note of /members/status".
    std::vector<std::string> words() const;
};

/// The digest over everything except how the file was made: for each group and dataset outside /provenance the path and
/// all attributes that are text or numbers, which include the digest of the dataset. Two files of the same members have
/// the same. `provenance`: the digest over /provenance; empty if there is none. `without`: left out.
struct ContentsDigests {
    std::string contents;
    std::string provenance;
    friend bool operator==(const ContentsDigests&, const ContentsDigests&) = default;
};
ContentsDigests contents_digests(hid_t file, const Additions& without = {});

/// Writes both digests, as attributes of the root and of /provenance. Call it last.
void write_contents_digests(hid_t file);

/// The digests that the file has; empty if there are none.
ContentsDigests read_contents_digests(hid_t file);

// Reading named datasets and attributes of an HDF5 file.

/// A file that another program has open for writing, or did when it was killed.
class OpenElsewhere : public InputError {
  public:
    explicit OpenElsewhere(const std::filesystem::path& path);
};

/// Opens an HDF5 file for reading. Throws InputError if the file does not exist or is not an HDF5 file, and
/// OpenElsewhere.
Handle open_for_reading(const std::filesystem::path& path);

/// Whether an object of that name exists; `name` may be a path.
bool exists(hid_t parent, const std::string& name);

/// All values of a dataset, row-major; `name` may be a path. Throws RunError if it does not exist or does not match its
/// digest.
template <class Value>
std::vector<Value> read_values(hid_t parent, const std::string& name);
extern template std::vector<double> read_values<double>(hid_t, const std::string&);
extern template std::vector<std::int32_t> read_values<std::int32_t>(hid_t, const std::string&);
extern template std::vector<std::int8_t> read_values<std::int8_t>(hid_t, const std::string&);

/// A dataset that is read a few rows at a time. Value: double, float or int32. HDF5 verifies the checksum of each
/// chunk; the digest covers all rows and is not compared.
template <class Value>
class RowReader {
  public:
    /// `name` may be a path. Throws RunError if there is no such dataset.
    RowReader(hid_t parent, const std::string& name);
    /// Values of one row.
    std::size_t width() const { return width_; }
    std::size_t rows() const { return static_cast<std::size_t>(sizes_.at(0)); }
    /// The values of `count` rows from `row` on, row-major; valid until the next call. Throws RunError past the end.
    std::span<const Value> read(std::size_t row, std::size_t count = 1);

  private:
    std::string name_;
    Handle dataset_;
    Handle space_;
    std::vector<hsize_t> sizes_;
    std::size_t width_;
    std::vector<Value> values_;
};
extern template class RowReader<double>;
extern template class RowReader<float>;
extern template class RowReader<std::int32_t>;

/// The same for texts, which are UTF-8.
std::vector<std::string> read_texts(hid_t parent, const std::string& name);

// Checks a file dataset by dataset against its digests.

struct DamagedDataset {
    std::string path;
    std::string fault;              ///< "/members/status does not fit its digest"
    bool by_rows = false;           ///< its rows are stored one by one and can be used without the others
    std::vector<std::size_t> rows;  ///< rows that cannot be read; empty for a damaged dataset if they are unknown
};

struct FileCheck {
    std::string filetype;      ///< attribute of the root; empty where there is none
    std::string version;       ///< of the layout, "1.8"
    std::size_t datasets = 0;  ///< of floes that could be listed
    bool has_digests = false;  ///< layouts before 1.8, and of records before 1.1, have none
    std::string contents;      ///< the digest over all outside /provenance, as written
    std::string fault;         ///< of the file as a whole; empty if there is none
    std::vector<DamagedDataset> damaged;
    std::string between;  ///< fault of bytes that belong to no dataset, if all datasets are good
    Additions added;      ///< by other programs, to a file that is as it was written without them

    bool good() const { return fault.empty() && damaged.empty() && between.empty(); }
};

/// Reads the whole file; if it has no digests and none of the `filetypes`, only the attributes that show this. Damage
/// is part of the result; throws InputError only if the file does not exist, is not an HDF5 file, or is open elsewhere.
FileCheck check_file(const std::filesystem::path& path, std::span<const std::string_view> filetypes);

}  // namespace floes::hdf5
