#pragma once
// A file that the target itself wrote, with some bytes changed. The input says which: three bytes of place, one byte of
// length, and so many bytes; the last byte of the input says at how many parts of 256 the file is cut off, 0 for not at
// all. So no file of HDF5 stands in the corpus, and all inputs are of the file's present layout.

#include <fcntl.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <string>

#include "core/bytes.hpp"
#include "fuzz/fuzz.hpp"
#include "records/file_calls.hpp"
#include "support/temporary_folder.hpp"

/// For the sanitizer: HDF5 keeps some memory of files that it refuses.
extern "C" [[gnu::used]] inline const char* __lsan_default_suppressions() {
    return "leak:libhdf5";
}

namespace floes::fuzz {

class EditedFile {
  public:
    explicit EditedFile(const std::filesystem::path& whole) : file_(open_file(path(), O_RDWR | O_CREAT)) {
        const Descriptor opened = open_file(whole, O_RDONLY);
        whole_.resize(file_size(opened, whole));
        require(read_at(opened, whole, 0, whole_), "the file cannot be read");
    }

    std::filesystem::path path() const { return folder_ / "edited.h5"; }

    void edit(std::span<const std::uint8_t> input) {
        Bytes bytes = whole_;
        if (!input.empty()) {
            bytes.resize(bytes.size() - bytes.size() * input.back() / 256);
            input = input.first(input.size() - 1);
        }
        while (input.size() > 4 && !bytes.empty()) {
            const std::size_t at = (input[0] | input[1] << 8 | input[2] << 16) % bytes.size();
            const std::size_t length = std::min<std::size_t>({input[3], input.size() - 4, bytes.size() - at});
            std::memcpy(bytes.data() + at, input.data() + 4, length);
            input = input.subspan(4 + length);
        }
        truncate_file(file_, path(), 0);
        ::lseek(file_.get(), 0, SEEK_SET);
        write_all(file_, path(), bytes);
    }

  private:
    TemporaryFolder folder_;  // not in memory: HDF5 asks for the real path
    Descriptor file_;
    Bytes whole_;
};

}  // namespace floes::fuzz
