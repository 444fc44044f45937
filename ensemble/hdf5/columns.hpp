#pragma once
// Datasets row by row: written with at most one chunk in memory, packed or as they grow, and read with checks. Only for
// sources of modules with HDF5 files of their own. Where the scale of their rows has sources, columns, text columns and
// rows are only declared: nothing is added to them and they are not finished.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "hdf5/dataset.hpp"
#include "hdf5/digest.hpp"
#include "hdf5/handle.hpp"
#include "hdf5/read.hpp"
#include "store/packed_arrays.hpp"

namespace floes::hdf5 {

/// A dataset of numbers like those of write_values(). Value: double, int32 or int8.
template <class Value>
class Column {
  public:
    /// The first of the dimensions is that of the rows. `missing`: the number that stands for a missing value.
    Column(hid_t parent, const Label& label, const Dimensions& dimensions, std::optional<Value> missing = {});
    /// The same for an enumeration.
    Column(hid_t parent, const Label& label, const Dimensions& dimensions, const Flags& flags);

    /// Adds whole rows, in row-major order.
    void add(std::span<const Value> values);
    void add(const Value& value) { add(std::span(&value, 1)); }
    /// Call it after the last row: writes the remaining rows and the digest. Throws ContractError if rows are
    /// missing.
    void finish();

  private:
    void write();

    std::string name_;
    std::vector<hsize_t> sizes_;
    hsize_t width_;  ///< values in a row
    hsize_t rows_at_once_;
    hsize_t written_ = 0;  ///< rows
    Handle dataset_;
    Handle space_;
    std::vector<Value> waiting_;  ///< rows of a chunk that is not full yet
    DatasetDigest digest_;
};

extern template class Column<double>;
extern template class Column<std::int32_t>;
extern template class Column<std::int8_t>;

/// A dataset with one text per row.
class TextColumn {
  public:
    TextColumn(hid_t parent, const Label& label, const Dimensions& dimensions);
    void add(const std::string& text);
    /// As above.
    void finish();

  private:
    void write();

    std::string name_;
    hsize_t rows_;
    hsize_t written_ = 0;
    Handle type_;
    Handle dataset_;
    Handle space_;
    std::vector<std::string> waiting_;
    DatasetDigest digest_;
};

// Reading datasets and checking that they are complete. Those of files with digests are; older files may be damaged
// without a trace.

inline void check_count(hid_t file, const std::string& name, std::size_t found, std::size_t wanted) {
    if (found != wanted) refuse_damaged(file, fmt::format("{} has {} values where {} belong", name, found, wanted));
}

/// Throws RunError unless there are `count` values.
template <class Value>
std::vector<Value> read_column(hid_t file, const std::string& name, std::size_t count) {
    std::vector<Value> values = read_values<Value>(file, name);
    check_count(file, name, values.size(), count);
    return values;
}

/// Throws RunError unless each value is from `least` to `most`.
template <class Value>
std::vector<Value> read_numbers(hid_t file, const std::string& name, std::size_t count, Value least, Value most) {
    std::vector<Value> values = read_column<Value>(file, name, count);
    for (const Value value : values)
        if (value < least || value > most)
            refuse_damaged(file, fmt::format("{} has the value {}, which there is not", name, value));
    return values;
}

/// The same of texts.
inline std::vector<std::string> read_texts(hid_t file, const std::string& name, std::size_t count) {
    std::vector<std::string> texts = read_texts(file, name);
    check_count(file, name, texts.size(), count);
    return texts;
}

/// The value of a dataset with one text.
inline std::string read_text(hid_t file, const std::string& name) {
    return read_texts(file, name, 1).front();
}

/// Values of `rows` rows of equal width; none if there are no rows.
template <class Value>
std::vector<Value> read_table(hid_t file, const std::string& name, std::size_t rows, std::size_t& width) {
    std::vector<Value> values = read_values<Value>(file, name);
    width = rows == 0 ? 0 : values.size() / rows;
    check_count(file, name, values.size(), rows * width);
    return values;
}

// Compressed tables whose rows are written one at a time or arrive compressed.

/// A compressed table of doubles with one chunk per row, the first of its dimensions, written row by row. A row may
/// itself have dimensions; it is then given in row-major order.
class Rows {
  public:
    Rows(hid_t parent, const Label& label, const Dimensions& dimensions);
    /// A row of one dimension may be shorter than the table is wide; the rest is NaN, and so are rows never written.
    void write(std::size_t row, std::span<const double> values);
    /// The same for a compressed row; one of full width is written unchanged.
    void write(std::size_t row, const PackedNumbers& values);
    /// Writes the digest of the table. Call it after the last row.
    void finish();
    /// The checksum() of each row, of which the digest is made.
    const std::vector<std::uint32_t>& checksums() const { return checksums_; }

  private:
    std::string name_;
    std::vector<hsize_t> sizes_;
    hsize_t width_;
    Handle dataset_;
    Handle space_;
    std::vector<std::uint32_t> checksums_;  ///< of each row
};

// Datasets that grow during a run.

/// A compressed dataset with checksums whose first dimension grows by whole rows. Value: float, double, int32 or int8.
template <class Value>
class Series {
  public:
    /// row: the dimensions of one row, none for one number a row. chunk_rows: rows that are compressed together.
    Series(hid_t parent, const Label& label, const Dimensions& row, hsize_t chunk_rows);

    /// Adds values.size() / (values of a row) rows.
    void append(std::span<const Value> values);
    void append(const Value& value) { append(std::span(&value, 1)); }

    /// Writes the digest of the dataset. Call it after the last row.
    void finish();

    hsize_t rows() const { return rows_; }

    /// Makes it a dimension scale with its own name.
    void become_scale();
    /// The first dimension of `dataset` is along this scale.
    void scales(hid_t dataset) const;
    hid_t id() const { return dataset_.id(); }

  private:
    std::string name_;
    std::vector<hsize_t> row_;
    hsize_t rows_ = 0;
    Handle dataset_;
    DatasetDigest digest_;
};

extern template class Series<float>;
extern template class Series<double>;
extern template class Series<std::int32_t>;
extern template class Series<std::int8_t>;

}  // namespace floes::hdf5
