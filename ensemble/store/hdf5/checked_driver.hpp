#pragma once
// Lets HDF5 read through CheckedPages, so that a damaged byte is an error before HDF5 interprets it. For this room
// only.

#include <optional>
#include <string>

#include "hdf5/handle.hpp"
#include "hdf5/pages.hpp"

namespace floes::hdf5 {

/// Makes `access` read the file of these `pages`. The file takes ownership of them when it is opened.
void read_by_pages(const Handle& access, std::optional<CheckedPages>& pages);

/// Reads all pages of an open file: CheckedPages::first_fault(); empty, too, where the file has no digests of them.
std::string first_page_fault(hid_t file);

/// While it exists, numbers from damaged pages of the file of `object` are passed on instead of refused. A page holds
/// parts of several datasets, so only the digest of a dataset shows whether it is this one. Not for texts, because HDF5
/// would follow damaged references to them.
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
