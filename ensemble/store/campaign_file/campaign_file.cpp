#include "campaign_file/campaign_file.hpp"

#include "campaign_file/campaign_kind.hpp"
#include "hdf5/kind.hpp"
#include "hdf5/read.hpp"

namespace floes {

struct CampaignFile::Opened {
    hdf5::Handle file;
};

CampaignFile::CampaignFile(const std::filesystem::path& path) : path_(path) {
    const hdf5::QuietErrors quiet;
    opened_ = std::make_unique<const Opened>(hdf5::open_for_reading(path));
    hdf5::check_kind(opened_->file.id(), campaign_kind, path);
}

CampaignFile::~CampaignFile() = default;

std::int64_t CampaignFile::id() const {
    return opened_->file.id();
}

}  // namespace floes
