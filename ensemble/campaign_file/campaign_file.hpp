#pragma once
// What says that an HDF5 file is a campaign file.

#include <cstdint>
#include <filesystem>
#include <memory>

#include "campaign/campaign.hpp"
#include "hdf5/handle.hpp"

namespace floes {

inline constexpr hdf5::FileKind campaign_kind{"floes campaign", {1, 15}, 14, "campaign of floes"};

// A campaign file, open for reading. To open it costs: its digests of pages are read, or without them a process of its
// own tries whether HDF5 survives it. So who reads several things of a file opens it once.

class CampaignFile {
  public:
    /// Also implicitly, for who reads one thing only. Throws InputError when there is no such file, it is no campaign
    /// file, or its major version is not this program's.
    CampaignFile(const std::filesystem::path& path);
    ~CampaignFile();

    const std::filesystem::path& path() const { return path_; }
    /// That the file's own configuration describes.
    const Campaign& campaign() const;
    /// Its identifier in HDF5. For this module only.
    std::int64_t id() const;

  private:
    struct Opened;

    std::filesystem::path path_;
    std::unique_ptr<const Opened> opened_;
};

}  // namespace floes
