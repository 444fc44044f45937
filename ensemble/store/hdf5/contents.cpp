#include "hdf5/contents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "hdf5/attributes.hpp"
#include "hdf5/damage.hpp"
#include "hdf5/names.hpp"

namespace floes::hdf5 {
namespace {

constexpr const char* provenance_group = "/provenance";
constexpr int most_deep = 8;  // floes has groups at the root only; links of a damaged file may form a ring
constexpr std::size_t most_objects = 10000;

/// Attributes of the root that are left out: who wrote the file, and the digest itself.
constexpr std::array not_contents{"software", "softwareVersion", contents_attribute};

Handle open_object(hid_t file, const std::string& path) {
    return Handle(check_read(H5Oopen(file, path.c_str(), H5P_DEFAULT), file, path), H5Oclose, "H5Oopen", path);
}

std::vector<std::string> link_names(hid_t group, const std::string& path) {
    return names_in_order<H5L_info_t>([&](auto* visit, void* names) {
        check_read(H5Literate(group, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, visit, names), group, path);
    });
}

void visit_readable(hid_t file, const std::string& path, int depth, Paths& found);

void visit(hid_t file, const std::string& path, int depth, Paths& found) {
    try {
        visit_readable(file, path, depth, found);
    } catch (const DamagedFile&) {
        found.unreadable.push_back(path);
    }
}

void visit_readable(hid_t file, const std::string& path, int depth, Paths& found) {
    if (depth > most_deep || found.groups.size() + found.datasets.size() > most_objects)
        refuse_damaged(file, fmt::format("{} has more in it than floes writes", path));
    const Handle object = open_object(file, path);
    if (H5Iget_type(object.id()) == H5I_DATASET) return found.datasets.push_back(path);
    if (H5Iget_type(object.id()) != H5I_GROUP) return;
    found.groups.push_back(path);
    for (const std::string& name : link_names(object.id(), path))
        visit(file, path == "/" ? path + name : path + "/" + name, depth + 1, found);
}

void add_attribute(hid_t object, const std::string& name, StreamingDigest& digest) {
    const Handle attribute(check_read(H5Aopen(object, name.c_str(), H5P_DEFAULT), object, name), H5Aclose, "H5Aopen",
                           name);
    const Handle type(check_read(H5Aget_type(attribute.id()), object, name), H5Tclose, "H5Aget_type", name);
    const H5T_class_t of = H5Tget_class(type.id());
    if (of == H5T_STRING && H5Tis_variable_str(type.id()) > 0) {
        digest.add_text(name);
        digest.add_text(read_text_attribute(object, name));
    } else if (of == H5T_STRING || of == H5T_INTEGER || of == H5T_FLOAT) {
        std::vector<std::byte> values(H5Aget_storage_size(attribute.id()));
        check_read(H5Aread(attribute.id(), type.id(), values.data()), object, name);
        digest.add_text(name);
        digest.add_text({reinterpret_cast<const char*>(values.data()), values.size()});
    }  // the others are references between datasets and their scales
}

bool is_provenance(const std::string& path) {
    return path == provenance_group || path.starts_with(fmt::format("{}/", provenance_group));
}

}  // namespace

Paths paths_of(hid_t file) {
    Paths found;
    visit(file, "/", 0, found);
    return found;
}

ContentsDigests contents_digests(hid_t file) {
    const Paths paths = paths_of(file);
    if (!paths.unreadable.empty()) refuse_damaged(file, fmt::format("{} cannot be read", paths.unreadable.front()));
    StreamingDigest contents;
    StreamingDigest provenance;
    for (const std::vector<std::string>* all : {&paths.groups, &paths.datasets}) {
        for (const std::string& path : *all) {
            StreamingDigest& digest = is_provenance(path) ? provenance : contents;
            digest.add_text(path);
            const Handle object = open_object(file, path);
            for (const std::string& name : attribute_names(object.id())) {
                const bool of_root = path == "/" && std::ranges::find(not_contents, name) != not_contents.end();
                const bool itself = path == provenance_group && name == digest_attribute;
                if (!of_root && !itself) add_attribute(object.id(), name, digest);
            }
        }
    }
    const bool has_provenance = std::ranges::any_of(paths.groups, is_provenance);
    return {contents.hex(), has_provenance ? provenance.hex() : ""};
}

void write_contents_digests(hid_t file) {
    const ContentsDigests digests = contents_digests(file);
    if (!digests.provenance.empty())
        write_attribute(open_object(file, provenance_group).id(), digest_attribute, digests.provenance);
    write_attribute(open_object(file, "/").id(), contents_attribute, digests.contents);
}

ContentsDigests read_contents_digests(hid_t file) {
    const auto text = [&](const char* path, const char* name) -> std::string {
        if (path != std::string("/") && check_read(H5Lexists(file, path, H5P_DEFAULT), file, path) == 0) return "";
        const Handle object = open_object(file, path);
        return has_attribute(object.id(), name) ? read_text_attribute(object.id(), name) : "";
    };
    return {text("/", contents_attribute), text(provenance_group, digest_attribute)};
}

}  // namespace floes::hdf5
