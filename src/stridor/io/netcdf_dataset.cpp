#include "stridor/io/netcdf_dataset.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/version.hpp"
#include "stridor/storage/system_io.hpp"

#include <fcntl.h>
#include <netcdf.h>
#include <netcdf_mem.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

namespace stridor::io {

namespace {

constexpr std::size_t first_size = 65536;  // [1] bytes; the library enlarges it as needed
// [1] bytes of a Zarr folder in memory; less opens it oftener
constexpr std::size_t most_held = std::size_t{16} << 20U;
// [1] bytes; HDF5 takes no attribute of 64 KiB
constexpr std::size_t longest_attribute = std::size_t{32} << 10U;

}  // namespace

NetcdfDataset::NetcdfDataset(std::string name) : name_(std::move(name)) {
    check(nc_create_mem("stridor.nc", NC_NETCDF4, first_size, &id_));
}

NetcdfDataset::NetcdfDataset(std::string name, const std::string& path, DatasetFormat format)
    : name_(std::move(name)),
      format_(format) {
    if (format == DatasetFormat::netcdf4) {
        check(nc_create(path.c_str(), NC_NETCDF4 | NC_CLOBBER, &id_));
        return;
    }
    // the library takes an address apart at "#" and "%": the folder above it is named by its number
    const std::filesystem::path folder(path);
    parent_ =
        std::make_unique<storage::Descriptor>(::open(folder.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!parent_->is_open()) throw storage::system_failure("write", "\"" + name_ + "\"", errno);
    address_ = "file:///proc/self/fd/" + std::to_string(parent_->number()) + "/" + folder.filename().string() +
               "#mode=zarr,file";
    check(nc_create(address_.c_str(), NC_NETCDF4 | NC_CLOBBER, &id_));
}

NetcdfDataset::~NetcdfDataset() {
    if (id_ >= 0) nc_abort(id_);
}

void NetcdfDataset::check(int code) const {
    if (code == NC_NOERR) return;
    throw Error(ErrorKind::io, {"cannot make the netCDF file \"" + name_ + "\"", nc_strerror(code), ""});
}

int NetcdfDataset::dimension(const std::string& name, std::size_t size) {
    int number = -1;
    check(nc_def_dim(id_, name.c_str(), size, &number));
    return number;
}

void NetcdfDataset::attribute(int variable, const std::string& name, const std::string& text) {
    check(nc_put_att_text(id_, variable, name.c_str(), text.size(), text.c_str()));
}

void NetcdfDataset::attribute(const std::string& name, const std::string& text) {
    const bool fits = text.size() <= longest_attribute || format_ == DatasetFormat::zarr;  // Zarr's are JSON
    if (fits) return attribute(NC_GLOBAL, name, text);
    const int length = dimension(name + "_length", text.size());
    const int number = define(name, NC_CHAR, std::array{length}, {});
    check(nc_def_var_deflate(id_, number, 0, 1, 1));
    // readers make one text of its letters
    attribute(number, "_Encoding", "utf-8");
    check(nc_put_var_text(id_, number, text.c_str()));
}

int NetcdfDataset::define(const std::string& name, int type, std::span<const int> dimensions,
                          const Description& description) {
    int number = -1;
    check(nc_def_var(id_, name.c_str(), type, static_cast<int>(dimensions.size()), dimensions.data(), &number));
    variables_.push_back(name);
    if (!description.units.empty()) attribute(number, "units", std::string(description.units));
    if (!description.long_name.empty()) attribute(number, "long_name", std::string(description.long_name));
    return number;
}

int NetcdfDataset::doubles(const std::string& name, std::span<const int> dimensions, std::span<const double> values,
                           const Description& description) {
    const int number = define(name, NC_DOUBLE, dimensions, description);
    const double missing = std::numeric_limits<double>::quiet_NaN();
    if (description.missing == MissingNumbers::as_nan) check(nc_def_var_fill(id_, number, NC_FILL, &missing));
    check(nc_put_var_double(id_, number, values.data()));
    return number;
}

int NetcdfDataset::doubles(const std::string& name, std::span<const int> dimensions, ChunkShape chunk,
                           const Description& description) {
    const int number = define(name, NC_DOUBLE, dimensions, description);
    const double missing = std::numeric_limits<double>::quiet_NaN();
    check(nc_def_var_fill(id_, number, NC_FILL, &missing));
    pack(number, chunk, sizeof(double));
    return number;
}

void NetcdfDataset::pack(int variable, ChunkShape chunk, std::size_t value_size) {
    check(nc_def_var_chunking(id_, variable, NC_CHUNKED, chunk.data()));
    // Zarr is packed by plug-ins that Debian's library does not have
    if (format_ == DatasetFormat::netcdf4) check(nc_def_var_deflate(id_, variable, 1, 1, 1));
    // the library's cache for the variable holds one box: it would hold 16 MB, and of thirty variables 500
    const std::size_t bytes = std::accumulate(chunk.begin(), chunk.end(), value_size, std::multiplies<>());
    check(nc_set_var_chunk_cache(id_, variable, bytes, 1, 1.0F));
}

// the library (4.9.0) holds all that was put into a Zarr folder until it is closed, whatever its cache is told; and it
// numbers the variables of one that it opens anew
int NetcdfDataset::opened_variable(int variable, std::size_t bytes) {
    if (format_ == DatasetFormat::netcdf4) return variable;
    if (held_ > 0 && held_ + bytes > most_held) {
        check(nc_close(std::exchange(id_, -1)));
        check(nc_open(address_.c_str(), NC_WRITE, &id_));
        held_ = 0;
    }
    held_ += bytes;
    int number = -1;
    check(nc_inq_varid(id_, variables_[static_cast<std::size_t>(variable)].c_str(), &number));
    return number;
}

void NetcdfDataset::put(int variable, std::span<const std::size_t> start, std::span<const std::size_t> count,
                        std::span<const double> values) {
    const int number = opened_variable(variable, values.size_bytes());
    check(nc_put_vara_double(id_, number, start.data(), count.data(), values.data()));
}

void NetcdfDataset::put(int variable, std::span<const std::size_t> start, std::span<const std::size_t> count,
                        std::span<const signed char> values) {
    const int number = opened_variable(variable, values.size_bytes());
    check(nc_put_vara_schar(id_, number, start.data(), count.data(), values.data()));
}

int NetcdfDataset::words(const std::string& name, std::span<const int> dimensions,
                         const std::vector<std::string>& values, const Description& description) {
    if (format_ == DatasetFormat::zarr) {
        std::vector<signed char> numbers(values.size());
        std::iota(numbers.begin(), numbers.end(), static_cast<signed char>(0));
        const std::vector<std::string_view> names(values.begin(), values.end());
        return flags(name, dimensions, numbers, {names}, description);
    }
    const int number = define(name, NC_STRING, dimensions, description);
    std::vector<const char*> pointers;
    for (const std::string& value : values)
        pointers.push_back(value.c_str());
    check(nc_put_var_string(id_, number, pointers.data()));
    return number;
}

int NetcdfDataset::define_flags(const std::string& name, std::span<const int> dimensions, const FlagNames& names,
                                const Description& description) {
    const int number = define(name, NC_BYTE, dimensions, description);
    // Zarr names a number for what is missing unless it is told that there is none
    if (format_ == DatasetFormat::zarr) check(nc_def_var_fill(id_, number, NC_NOFILL, nullptr));
    std::vector<signed char> flag_values(names.names.size());
    std::iota(flag_values.begin(), flag_values.end(), static_cast<signed char>(0));
    std::string meanings;
    for (const std::string_view meaning : names.names)
        meanings += (meanings.empty() ? "" : " ") + std::string(meaning);
    if (!names.none.empty()) {
        flag_values.push_back(-1);
        meanings += " " + std::string(names.none);
    }
    check(nc_put_att_schar(id_, number, "flag_values", NC_BYTE, flag_values.size(), flag_values.data()));
    attribute(number, "flag_meanings", meanings);
    return number;
}

int NetcdfDataset::flags(const std::string& name, std::span<const int> dimensions, std::span<const signed char> values,
                         const FlagNames& names, const Description& description) {
    const int number = define_flags(name, dimensions, names, description);
    check(nc_put_var_schar(id_, number, values.data()));
    return number;
}

int NetcdfDataset::flags(const std::string& name, std::span<const int> dimensions, ChunkShape chunk,
                         const FlagNames& names, const Description& description) {
    const int number = define_flags(name, dimensions, names, description);
    pack(number, chunk, sizeof(signed char));
    return number;
}

void NetcdfDataset::finish() {
    check(nc_close(std::exchange(id_, -1)));
}

void NetcdfDataset::finish(const std::function<void(std::string_view)>& take) {
    NC_memio memory{};
    check(nc_close_memio(std::exchange(id_, -1), &memory));
    const std::unique_ptr<void, decltype(&std::free)> owner(memory.memory, &std::free);
    take({static_cast<const char*>(memory.memory), memory.size});
}

Attributes origin_attributes(std::string_view schema, const std::string& title) {
    return {{"Conventions", "CF-1.10"},
            {"title", title},
            {"source", "stridor " + std::string(base::version()) + " (" + std::string(base::commit()) + ")"},
            {"schema", "stridor." + std::string(schema) + "/1"}};
}

void put(NetcdfDataset& file, const Attributes& attributes) {
    for (const auto& [name, text] : attributes)
        file.attribute(name, text);
}

}  // namespace stridor::io
