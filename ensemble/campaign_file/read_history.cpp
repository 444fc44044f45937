#include "campaign_file/read_history.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "campaign_file/campaign_table.hpp"
#include "hdf5/read.hpp"

namespace floes {
namespace {

/// Seconds from value to value of the histories of each case.
std::vector<double> value_steps(hid_t file) {
    auto steps = hdf5::read_values<double>(file, "cases/time_step");
    if (!hdf5::exists(file, "cases/history_stride")) return steps;  // before layout 1.3
    const auto strides = hdf5::read_values<std::int32_t>(file, "cases/history_stride");
    for (std::size_t k = 0; k < steps.size(); ++k) steps[k] *= strides.at(k);
    return steps;
}

/// Of the members that `wanted` takes.
void for_histories(const std::filesystem::path& path, const std::function<bool(int member)>& wanted,
                   const std::function<void(const SurgeHistory&)>& use) {
    const hdf5::QuietErrors quiet;
    const hdf5::Handle file = hdf5::open_for_reading(path);
    const char* name = "history/surge_load";
    if (!hdf5::exists(file.id(), name)) return;
    const std::vector<double> steps = value_steps(file.id());
    const auto cases = hdf5::read_values<std::int32_t>(file.id(), "members/case");
    const auto status = hdf5::read_values<std::int8_t>(file.id(), "members/status");
    const hdf5::Handle dataset(H5Dopen2(file.id(), name, H5P_DEFAULT), H5Dclose, "H5Dopen", name);
    const hdf5::Handle space(H5Dget_space(dataset.id()), H5Sclose, "H5Dget_space", name);
    std::array<hsize_t, 2> size{};
    hdf5::check(H5Sget_simple_extent_dims(space.id(), size.data(), nullptr), "H5Sget_simple_extent_dims", name);
    const hdf5::Handle row_space(H5Screate_simple(1, &size[1], nullptr), H5Sclose, "H5Screate_simple", name);
    std::vector<double> row(size[1]);
    for (std::size_t member = 0; member < status.size(); ++member) {
        if (static_cast<RowStatus>(status[member]) != RowStatus::done || !wanted(static_cast<int>(member))) continue;
        const std::array<hsize_t, 2> start{member, 0};
        const std::array<hsize_t, 2> count{1, size[1]};
        hdf5::check(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
                    "H5Sselect_hyperslab", name);
        hdf5::check(
            H5Dread(dataset.id(), hdf5::native_type<double>(), row_space.id(), space.id(), H5P_DEFAULT, row.data()),
            "H5Dread", name);
        std::size_t length = row.size();
        while (length > 0 && std::isnan(row[length - 1])) --length;  // rows are as long as the longest case
        const auto of_case = static_cast<std::size_t>(cases[member]);
        if (length > 0) use({static_cast<int>(member), steps.at(of_case), std::span(row).first(length)});
    }
}

}  // namespace

void for_each_history(const std::filesystem::path& path, const std::function<void(const SurgeHistory&)>& use) {
    for_histories(path, [](int) { return true; }, use);
}

void with_history(const std::filesystem::path& path, int member, const std::function<void(const SurgeHistory&)>& use) {
    for_histories(path, [member](int one) { return one == member; }, use);
}

}  // namespace floes
