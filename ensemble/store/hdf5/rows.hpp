#pragma once
// Compressed tables whose rows are written one at a time or arrive compressed. Only for sources of rooms with HDF5
// files of their own.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "hdf5/label.hpp"
#include "records/packed_checksum.hpp"

namespace floes::hdf5 {

/// A compressed table of doubles with one chunk per row, written row by row. A row may itself have dimensions; it is
/// then given in row-major order.
class Rows {
  public:
    Rows(hid_t parent, const Label& label, const Scale& rows, const Dimensions& columns);
    /// A row of one dimension may be shorter than the table is wide; the rest is NaN, and so are rows never written.
    void write(std::size_t row, std::span<const double> values);
    /// The same for a compressed row; one of full width is written unchanged.
    void write(std::size_t row, const PackedNumbers& values);
    /// Writes the digest of the table. Call it after the last row.
    void finish();

  private:
    std::string name_;
    std::vector<hsize_t> sizes_;
    hsize_t width_;
    Handle dataset_;
    Handle space_;
    std::vector<std::uint32_t> checksums_;  ///< of each row
};

}  // namespace floes::hdf5
