#pragma once
// /load_map of a campaign file, with its dimensions. For this room only.

#include "campaign_file/campaign_content.hpp"
#include "hdf5/rows.hpp"

namespace floes {

class LoadMapTables {
  public:
    LoadMapTables(hid_t file, const CampaignScales& scales);

    void write(std::size_t member, const PackedLoadMap& map);
    /// After the last member.
    void finish();

  private:
    hdf5::Scale height_;
    hdf5::Scale angle_;
    hdf5::Scale tow_;
    hdf5::Handle group_;
    hdf5::Rows surge_;
    hdf5::Rows normal_;
    hdf5::Rows along_tow_;
};

}  // namespace floes
