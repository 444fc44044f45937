#include "campaign_file/campaign_file.hpp"

#include "campaign/read.hpp"
#include "campaign_file/campaign_file.hpp"
#include "hdf5/columns.hpp"
#include "hdf5/handle.hpp"

namespace floes {

struct CampaignFile::Opened {
    hdf5::Handle file;
    Campaign campaign;
};

namespace {

hdf5::Handle open_campaign(const std::filesystem::path& path) {
    hdf5::Handle file = hdf5::open_for_reading(path);
    hdf5::check_kind(file.id(), campaign_kind, path);
    return file;
}

Campaign read_configured(hid_t file, const std::filesystem::path& path) {
    return read_campaign({hdf5::read_text(file, "provenance/configuration"), path.stem().string() + ".toml", {}},
                         nullptr);
}

}  // namespace

CampaignFile::CampaignFile(const std::filesystem::path& path) : path_(path) {
    const hdf5::QuietErrors quiet;
    hdf5::Handle file = open_campaign(path);
    Campaign campaign = read_configured(file.id(), path);
    opened_ = std::make_unique<const Opened>(std::move(file), std::move(campaign));
}

CampaignFile::~CampaignFile() = default;

const Campaign& CampaignFile::campaign() const {
    return opened_->campaign;
}

std::int64_t CampaignFile::id() const {
    return opened_->file.id();
}

}  // namespace floes
