#pragma once
// Errors about a file that differs from what was written. Only for sources of rooms with HDF5 files of their own.

#include <string>
#include <string_view>

#include "core/error.hpp"
#include "hdf5/handle.hpp"

namespace floes::hdf5 {

/// "PATH is damaged: FAULT.", and what to do.
class DamagedFile : public RunError {
  public:
    DamagedFile(std::string_view path, std::string_view fault);
    const std::string& fault() const { return fault_; }

  private:
    std::string fault_;
};

/// Throws DamagedFile. `object`: the file or anything in it.
[[noreturn]] void refuse_damaged(hid_t object, std::string_view fault);

/// The same for an object called `name` that HDF5 cannot read, with HDF5's own reason.
[[noreturn]] void refuse_unreadable(hid_t object, const std::string& name);

/// The value of a call that reads `name`, which is in the file of `object`.
template <class Value>
Value check_read(Value value, hid_t object, const std::string& name) {
    if (value < 0) refuse_unreadable(object, name);
    return value;
}

}  // namespace floes::hdf5
