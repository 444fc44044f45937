#include "hdf5/read.hpp"

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "hdf5/pages.hpp"
#include "store/file_calls.hpp"

namespace floes::hdf5 {

namespace {

constexpr hsize_t most_from_a_byte = 1032;             // the largest factor of deflate
constexpr hsize_t most_unwritten = hsize_t{1} << 26;   // bytes; rows never written take no space
constexpr hsize_t most_in_a_chunk = hsize_t{1} << 28;  // bytes; a row of ten million steps is smaller

/// Bytes of one chunk, for which HDF5 allocates memory; 0 for a dataset without chunks.
hsize_t chunk_bytes(const Handle& dataset, const StoredShape& shape) {
    const Handle properties(H5Dget_create_plist(dataset.id()), H5Pclose, "H5Dget_create_plist", "a dataset");
    if (H5Pget_layout(properties.id()) != H5D_CHUNKED) return 0;
    std::vector<hsize_t> chunk(shape.sizes.size());
    if (H5Pget_chunk(properties.id(), static_cast<int>(chunk.size()), chunk.data()) < 0) return most_in_a_chunk + 1;
    hsize_t bytes = shape.value_bytes;
    for (const hsize_t size : chunk)
        if (__builtin_mul_overflow(bytes, size, &bytes)) return most_in_a_chunk + 1;
    return bytes;
}

/// Sets the counts; false if they overflow.
bool count(StoredShape& shape) {
    hsize_t bytes = shape.value_bytes;
    for (std::size_t k = 0; k < shape.sizes.size(); ++k) {
        if (k > 0 && __builtin_mul_overflow(shape.row_values, shape.sizes[k], &shape.row_values)) return false;
        if (__builtin_mul_overflow(shape.count, shape.sizes[k], &shape.count)) return false;
        if (__builtin_mul_overflow(bytes, shape.sizes[k], &bytes)) return false;
    }
    return true;
}

/// Whether its rows lie in other files, by sources that have as many values as it.
std::optional<bool> is_covered(const Handle& dataset, const StoredShape& shape) {
    const Handle properties(H5Dget_create_plist(dataset.id()), H5Pclose, "H5Dget_create_plist", "a dataset");
    if (H5Pget_layout(properties.id()) != H5D_VIRTUAL) return std::nullopt;
    std::size_t sources = 0;
    if (H5Pget_virtual_count(properties.id(), &sources) < 0) return false;
    hsize_t covered = 0;
    for (std::size_t k = 0; k < sources; ++k) {
        const hid_t space = H5Pget_virtual_vspace(properties.id(), k);
        if (space < 0) return false;
        const hssize_t points = H5Sget_select_npoints(space);
        H5Sclose(space);
        if (points < 0 || __builtin_add_overflow(covered, static_cast<hsize_t>(points), &covered)) return false;
    }
    return covered == shape.count;
}

bool is_possible(const Handle& dataset, StoredShape& shape, Portion portion) {
    if (shape.value_bytes == 0 || !count(shape)) return false;
    if (const std::optional<bool> covered = is_covered(dataset, shape)) return *covered;
    const hsize_t chunk = chunk_bytes(dataset, shape);
    const hsize_t stored = H5Dget_storage_size(dataset.id());
    const hsize_t bytes = shape.count * shape.value_bytes;
    if (chunk > most_in_a_chunk) return false;
    if (chunk == 0 && stored > 0)
        return shape.is_text ? bytes <= stored : bytes == stored;  // texts are stored elsewhere
    const hsize_t wanted = portion == Portion::whole ? bytes : shape.row_values * shape.value_bytes;
    return wanted <= most_unwritten || wanted / most_from_a_byte <= stored;
}

}  // namespace

Handle open_dataset(hid_t parent, const std::string& name) {
    return Handle(check_read(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), parent, name), H5Dclose, "H5Dopen", name);
}

Handle stored_space(const Handle& dataset, const std::string& name) {
    return Handle(check_read(H5Dget_space(dataset.id()), dataset.id(), name), H5Sclose, "H5Dget_space", name);
}

Handle stored_type(const Handle& dataset, const std::string& name) {
    return Handle(check_read(H5Dget_type(dataset.id()), dataset.id(), name), H5Tclose, "H5Dget_type", name);
}

StoredShape shape_of(const Handle& dataset, const std::string& name, Portion portion) {
    const hid_t id = dataset.id();
    const Handle space = stored_space(dataset, name);
    const Handle type = stored_type(dataset, name);
    StoredShape shape;
    shape.sizes.resize(static_cast<std::size_t>(check_read(H5Sget_simple_extent_ndims(space.id()), id, name)));
    check_read(H5Sget_simple_extent_dims(space.id(), shape.sizes.data(), nullptr), id, name);
    shape.is_text = H5Tget_class(type.id()) == H5T_STRING;
    shape.value_bytes = H5Tget_size(type.id());
    if (!is_possible(dataset, shape, portion))
        refuse_damaged(id, fmt::format("{} is said to be larger than what is stored of it", name));
    return shape;
}

std::vector<std::string> texts_of(const Handle& dataset, const std::string& name) {
    const hid_t id = dataset.id();
    const Handle space = stored_space(dataset, name);
    const Handle type = text_type();
    std::vector<char*> pointers(shape_of(dataset, name, Portion::whole).count, nullptr);
    check_read(H5Dread(id, type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()), id, name);
    std::vector<std::string> texts;
    for (const char* text : pointers) texts.emplace_back(text != nullptr ? text : "");
    H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, pointers.data());
    return texts;
}

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

H5L_info_t link_of(hid_t file, const std::string& path) {
    H5L_info_t link{};
    check_read(H5Lget_info(file, path.c_str(), &link, H5P_DEFAULT), file, path);
    return link;
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
    if (path != "/" && link_of(file, path).type != H5L_TYPE_HARD) return found.links.push_back(path);
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

namespace {

/// Attributes that floes may write behind the one that ends an object's, so that the order does not tell.
constexpr std::array written_late{"CLASS",       "NAME",          "DIMENSION_LIST", "REFERENCE_LIST",
                                  "flag_values", "flag_meanings", "element_side",   "thickness"};

/// The attribute that is written when all of an object is.
const char* last_attribute(const std::string& path) {
    return path == "/" ? contents_attribute : digest_attribute;
}

/// Where in the order of their creation an attribute of the object is; none where that is not kept.
std::optional<std::int64_t> place_of(hid_t object, const std::string& name) {
    H5A_info_t about{};
    check_read(H5Aget_info_by_name(object, ".", name.c_str(), &about, H5P_DEFAULT), object, name);
    return about.corder_valid ? std::optional<std::int64_t>(about.corder) : std::nullopt;
}

void add_attributes(hid_t file, const std::string& path, Additions& found) {
    const Handle object = open_object(file, path);
    const bool ended = has_attribute(object.id(), last_attribute(path));
    const auto end = ended ? place_of(object.id(), last_attribute(path)) : std::nullopt;
    for (const std::string& name : attribute_names(object.id()))
        if (std::ranges::find(written_late, name) == written_late.end() &&
            (!ended || place_of(object.id(), name) > end))
            found.attributes.emplace(path, name);
}

std::string parent_of(const std::string& path) {
    return path.substr(0, path.rfind('/') + 1);
}

/// What has no digest, or came after all that has one.
Additions additions_to(hid_t file, const Paths& paths) {
    Additions found;
    found.objects.insert(paths.links.begin(), paths.links.end());
    std::vector<std::string> written;
    for (const std::string& path : paths.datasets) {
        if (has_attribute(open_object(file, path).id(), digest_attribute))
            written.push_back(path);
        else
            found.objects.insert(path);
    }
    const auto holds_written = [&](const std::string& group) {
        return std::ranges::any_of(written, [&](const std::string& one) { return one.starts_with(group + "/"); });
    };
    std::map<std::string, std::int64_t> last;  // of what is written, by its folder
    const auto note_written = [&](const std::string& path) {
        std::int64_t& place = last.try_emplace(parent_of(path), -1).first->second;
        place = std::max<std::int64_t>(place, link_of(file, path).corder);
    };
    std::ranges::for_each(written, note_written);
    for (const std::string& path : paths.groups)
        if (path != "/" && holds_written(path)) note_written(path);
    for (const std::string& path : paths.groups) {
        if (path == "/" || path == provenance_group || holds_written(path)) continue;
        const auto before = last.find(parent_of(path));
        if (before == last.end() || link_of(file, path).corder > before->second) found.objects.insert(path);
    }
    for (const std::vector<std::string>* all : {&paths.groups, &paths.datasets})
        for (const std::string& path : *all)
            if (!found.objects.contains(path)) add_attributes(file, path, found);
    return found;
}

}  // namespace

std::vector<std::string> Additions::words() const {
    std::vector<std::string> made(objects.begin(), objects.end());
    for (const auto& [path, name] : attributes) made.push_back(fmt::format("the attribute {} of {}", name, path));
    return made;
}

ContentsDigests contents_digests(hid_t file, const Additions& without) {
    const Paths paths = paths_of(file);
    if (!paths.unreadable.empty()) refuse_damaged(file, fmt::format("{} cannot be read", paths.unreadable.front()));
    StreamingDigest contents;
    StreamingDigest provenance;
    for (const std::vector<std::string>* all : {&paths.groups, &paths.datasets}) {
        for (const std::string& path : *all) {
            if (without.objects.contains(path)) continue;
            StreamingDigest& digest = is_provenance(path) ? provenance : contents;
            digest.add_text(path);
            const Handle object = open_object(file, path);
            for (const std::string& name : attribute_names(object.id())) {
                const bool of_root = path == "/" && std::ranges::find(not_contents, name) != not_contents.end();
                const bool itself = path == provenance_group && name == digest_attribute;
                if (!of_root && !itself && !without.attributes.contains({path, name}))
                    add_attribute(object.id(), name, digest);
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

namespace {

constexpr std::size_t most_values_at_once = std::size_t{1} << 26;  // half a gigabyte of doubles

/// Whether the layout of the file gives every dataset a digest.
bool has_digests(hid_t parent) {
    const Handle root(check_read(H5Oopen(parent, "/", H5P_DEFAULT), parent, "its root"), H5Oclose, "H5Oopen", "/");
    return has_attribute(root.id(), contents_attribute);
}

/// The digest of a dataset; files of older layouts have none. Read it before values from damaged pages are passed on:
/// the digest is a text in a heap, and HDF5 crashes if that is damaged.
std::optional<StoredDigest> stored_digest(hid_t parent, const Handle& dataset, const std::string& name) {
    std::optional<StoredDigest> stored = read_digest(dataset.id());
    if (!stored && has_digests(parent)) refuse_damaged(parent, fmt::format("{} has lost its digest", name));
    return stored;
}

/// Compares the stored digest with that of the values that `add` adds.
template <class Add>
void compare(const Handle& dataset, const std::string& name, const std::optional<StoredDigest>& stored,
             const Add& add) {
    if (!stored) return;
    DatasetDigest digest(stored->kind);
    add(digest);
    check_digest(dataset.id(), name, *stored, digest.finish(dataset.id()));
}

}  // namespace

OpenElsewhere::OpenElsewhere(const std::filesystem::path& path)
    : InputError(fmt::format(
          "{} is open for writing in another program, as h5py opens it with \"r+\" or \"a\": close it there, and try "
          "again. If nothing has it open, the program was killed before it closed the file: h5clear -s {} frees it.",
          path.string(), shell_word(path.string()))) {}

namespace {

/// Whether the file says that some program has it open for writing: HDF5 marks its beginning while one does. What HDF5
/// says counts, since it has compared the checksum; the mark alone may be a damaged byte.
void refuse_open_elsewhere(const std::filesystem::path& path) {
    constexpr std::size_t marks_at = 11;  // in a superblock of version 2 or 3
    constexpr unsigned writers = 5;       // one, or one that lets others read
    Bytes begin(marks_at + 1);
    if (!read_at(open_file(path, O_RDONLY), 0, begin)) return;
    if ((std::to_integer<unsigned>(begin[marks_at]) & writers) == 0) return;
    const Handle access = access_without_locks();
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id());
    if (file < 0 && last_reason().find("already open for") != std::string::npos) throw OpenElsewhere(path);
    if (file >= 0) H5Fclose(file);
}

}  // namespace

Handle open_for_reading(const std::filesystem::path& path) {
    if (!std::filesystem::exists(path)) throw InputError(fmt::format("there is no file {}.", path.string()));
    if (H5Fis_hdf5(path.c_str()) <= 0)
        throw InputError(fmt::format("{} is not an HDF5 file; give the .h5 that floes run wrote.", path.string()));
    refuse_open_elsewhere(path);
    const Handle access = access_without_locks();
    std::optional<CheckedPages> pages = CheckedPages::open(path);
    if (pages) {
        read_by_pages(access, pages);
    } else {
        try_out(path);
    }
    // Behind a link: there lies what a virtual dataset refers to.
    const hid_t file = H5Fopen(target_of(path).c_str(), H5F_ACC_RDONLY, access.id());
    if (file < 0) throw DamagedFile(path.string(), fmt::format("HDF5 cannot open it ({})", last_reason()));
    return Handle(file, H5Fclose, "H5Fopen", path.string());
}

bool exists(hid_t parent, const std::string& name) {
    for (std::size_t end = 0; end != std::string::npos;) {  // HDF5 wants each group on the path to exist
        end = name.find('/', end + 1);
        if (check_read(H5Lexists(parent, name.substr(0, end).c_str(), H5P_DEFAULT), parent, name) == 0) return false;
    }
    return true;
}

template <class Value>
std::vector<Value> read_values(hid_t parent, const std::string& name) {
    const Handle dataset = open_dataset(parent, name);
    const StoredShape shape = shape_of(dataset, name, Portion::whole);
    std::vector<Value> values(shape.count);
    if (shape.is_text) refuse_damaged(parent, fmt::format("{} has texts where numbers belong", name));
    const std::optional<StoredDigest> stored = stored_digest(parent, dataset, name);
    const PassedValues until_compared(dataset.id());
    check_read(H5Dread(dataset.id(), native_type<Value>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), parent, name);
    compare(dataset, name, stored, [&](DatasetDigest& digest) {
        if (H5Tequal(stored_type(dataset, name).id(), stored_type<Value>()) <= 0)
            refuse_damaged(parent, fmt::format("{} has another type", name));
        digest.add<Value>(values, shape.row_values);
    });
    return values;
}
template std::vector<double> read_values<double>(hid_t, const std::string&);
template std::vector<std::int32_t> read_values<std::int32_t>(hid_t, const std::string&);
template std::vector<std::int8_t> read_values<std::int8_t>(hid_t, const std::string&);

template <class Value>
RowReader<Value>::RowReader(hid_t parent, const std::string& name)
    : name_(name), dataset_(open_dataset(parent, name)), space_(stored_space(dataset_, name)) {
    const StoredShape shape = shape_of(dataset_, name, Portion::row);
    if (shape.sizes.empty()) refuse_damaged(parent, fmt::format("{} has no rows", name));
    sizes_ = shape.sizes;
    width_ = shape.row_values;
}

template <class Value>
std::span<const Value> RowReader<Value>::read(std::size_t row, std::size_t rows) {
    if (row > sizes_[0] || rows > sizes_[0] - row)
        refuse_damaged(dataset_.id(), fmt::format("{} ends before row {}", name_, row + rows));
    const hsize_t length = rows * width_;
    if (length > most_values_at_once)
        refuse_damaged(dataset_.id(), fmt::format("{} rows of {} are too many", rows, name_));
    values_.resize(length);
    if (length == 0) return values_;
    const Handle memory = select_rows(space_, sizes_, row, rows, name_);
    check_read(H5Dread(dataset_.id(), native_type<Value>(), memory.id(), space_.id(), H5P_DEFAULT, values_.data()),
               dataset_.id(), fmt::format("row {} of {}", row, name_));
    return values_;
}
template class RowReader<double>;
template class RowReader<float>;
template class RowReader<std::int32_t>;

std::vector<std::string> read_texts(hid_t parent, const std::string& name) {
    const Handle dataset = open_dataset(parent, name);
    std::vector<std::string> texts = texts_of(dataset, name);
    compare(dataset, name, stored_digest(parent, dataset, name),
            [&](DatasetDigest& digest) { digest.add(std::span<const std::string>(texts)); });
    for (const std::string& text : texts)
        if (!is_utf8(text)) refuse_damaged(parent, fmt::format("a text of {} is not UTF-8", name));
    return texts;
}

namespace {

std::vector<std::size_t> unreadable_rows(hid_t file, const std::string& path) {
    std::vector<std::size_t> found;
    RowReader<double> reader(file, path);
    for (std::size_t row = 0; row < reader.rows(); ++row) {
        try {
            reader.read(row);
        } catch (const DamagedFile&) {
            found.push_back(row);
        }
    }
    return found;
}

void check_dataset(hid_t file, const std::string& path, FileCheck& check) {
    DamagedDataset one{path, "", false, {}};
    try {
        const Handle dataset = open_dataset(file, path);
        const std::optional<StoredDigest> stored = read_digest(dataset.id());
        one.by_rows = stored && stored->kind == DigestKind::rows;
        if (!stored && check.has_digests) one.fault = fmt::format("{} has no digest", path);
        const StoredDigest found = digest_of(dataset, stored.value_or(StoredDigest{}).kind);
        if (stored) check_digest(dataset.id(), path, *stored, found);
    } catch (const DamagedFile& damage) {
        const std::string& fault = damage.fault();
        one.fault = fault.find(path) == std::string::npos ? fmt::format("{}: {}", path, fault) : fault;
        if (one.by_rows) one.rows = unreadable_rows(file, path);
    } catch (const RunError& error) {  // an error of the disk
        one.fault = error.what();
    }
    if (!one.fault.empty()) check.damaged.push_back(std::move(one));
}

/// What was added to a file that is otherwise as it was written; none where it is not.
std::optional<Additions> additions_of(hid_t file, const Paths& paths, const ContentsDigests& stored) {
    const auto try_with = [&](const std::function<Additions()>& made) -> std::optional<Additions> {
        try {
            Additions added = made();
            if (stored == contents_digests(file, added)) return added;
        } catch (const DamagedFile&) {  // or something that floes does not write; the search for damage says where
        }
        return std::nullopt;
    };
    const std::optional<Additions> none = try_with([&] {
        return Additions{{paths.links.begin(), paths.links.end()}, {}};
    });
    return none ? none : try_with([&] { return additions_to(file, paths); });
}

void check_contents(hid_t file, std::span<const std::string_view> filetypes, FileCheck& check) {
    if (has_attribute(file, "filetype")) check.filetype = read_text_attribute(file, "filetype");
    if (has_attribute(file, "version"))
        check.version = fmt::format("{}", fmt::join(read_int_attribute(file, "version"), "."));
    const ContentsDigests stored = read_contents_digests(file);
    check.contents = stored.contents;
    check.has_digests = !stored.contents.empty();
    if (!check.has_digests && std::ranges::find(filetypes, check.filetype) == filetypes.end()) return;
    const Paths paths = paths_of(file);
    for (const std::string& path : paths.unreadable)
        check.damaged.push_back({path, fmt::format("{} cannot be read", path), false, {}});
    const std::optional<Additions> added = check.has_digests ? additions_of(file, paths, stored) : std::nullopt;
    check.added = added.value_or(Additions{});
    for (const std::string& path : paths.datasets) {
        if (check.added.objects.contains(path)) continue;
        ++check.datasets;
        check_dataset(file, path, check);
    }
    if (check.has_digests && check.damaged.empty() && !added)
        check.fault = "its attributes, or the names of its datasets, are not those that were written";
}

}  // namespace

FileCheck check_file(const std::filesystem::path& path, std::span<const std::string_view> filetypes) {
    const QuietErrors quiet;
    FileCheck check;
    try {
        const Handle file = open_for_reading(path);
        check_contents(file.id(), filetypes, check);
        // HDF5 does not read every byte, for example not those between its objects.
        if (check.good()) check.between = first_page_fault(file.id());
    } catch (const DamagedFile& damage) {
        check.fault = damage.fault();
    } catch (const RunError& error) {
        check.fault = error.what();
    }
    return check;
}

}  // namespace floes::hdf5
