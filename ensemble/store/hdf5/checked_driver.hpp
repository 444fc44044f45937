#pragma once
// HDF5's reading through CheckedPages: a damaged byte is an error before HDF5 makes anything of it. For this room only.

#include <optional>
#include <string>

#include "hdf5/handle.hpp"
#include "hdf5/pages.hpp"

namespace floes::hdf5 {

/// Makes `access` read the file of these `pages`, which the file takes when it is opened.
void read_by_pages(const Handle& access, std::optional<CheckedPages>& pages);

/// Reads all pages of an open file: CheckedPages::first_fault(); empty, too, where the file has no digests of them.
std::string first_page_fault(hid_t file);

/// While it lives, numbers from damaged pages of the file of `object` are passed on and not refused. A page has several
/// datasets in it; so whoever compares the digest of a dataset can say whether it is this one. Not for texts: what HDF5
/// reads of them are places to read on from.
class PassedValues {
  public:
    explicit PassedValues(hid_t object);
    ~PassedValues();
    PassedValues(const PassedValues&) = delete;
    PassedValues& operator=(const PassedValues&) = delete;

  private:
    bool* passes_;
};

}  // namespace floes::hdf5
