#pragma once

#include "stridor/storage/system_io.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::io {

/// Whether numbers may be missing (NaN). Coordinates may not.
enum class MissingNumbers { no, as_nan };

/// The attributes of a variable.
struct Description {
    std::string_view units;      // empty: none
    std::string_view long_name;  // empty: none
    MissingNumbers missing = MissingNumbers::as_nan;
};

/// The boxes in the file of a variable that comes in parts: each box has this shape [dimension] and is packed without
/// loss. Parts should consist of whole boxes: a part that fills only some of a box has it unpacked and packed again.
using ChunkShape = std::span<const std::size_t>;

/// Names of numbers from 0 on; if `none` is not empty, -1 stands for it, the last of them.
struct FlagNames {
    std::span<const std::string_view> names;
    std::string_view none{};
};

/// The format of a dataset.
enum class DatasetFormat {
    netcdf4,
    zarr,  // a folder of the layout Zarr 2, with dimensions named as xarray does it
};

/// A netCDF-4 file being made, a thin cover of the C library; `name` appears in errors.
///
/// Dimensions are identified by the library's numbers. Variables are written whole, in one call, or in parts.
class NetcdfDataset {
public:
    /// Makes a file in memory.
    explicit NetcdfDataset(std::string name);
    /// Makes a file in `path`, which may exist; for Zarr an absolute path of a folder with a plain name. If a write
    /// fails, HDF5 ends the process (a segmentation fault, there or at the process' end): use it only in a process that
    /// may be lost.
    NetcdfDataset(std::string name, const std::string& path, DatasetFormat format = DatasetFormat::netcdf4);
    NetcdfDataset(const NetcdfDataset&) = delete;
    NetcdfDataset& operator=(const NetcdfDataset&) = delete;
    ~NetcdfDataset();

    /// Adds a dimension of `size` values and returns its number.
    int dimension(const std::string& name, std::size_t size);
    /// Adds an attribute of the file. In netCDF a text of more than 32 KiB becomes a variable of this name instead, of
    /// letters along NAME_length.
    void attribute(const std::string& name, const std::string& text);

    /// Adds a variable of numbers and returns its number.
    int doubles(const std::string& name, std::span<const int> dimensions, std::span<const double> values,
                const Description& description);
    /// Adds a variable of numbers that come in parts, by `put`; until then they are missing. Returns its number.
    int doubles(const std::string& name, std::span<const int> dimensions, ChunkShape chunk,
                const Description& description);
    /// Writes values into the box of a variable that begins at `start` and is `count` wide, each of shape [dimension].
    void put(int variable, std::span<const std::size_t> start, std::span<const std::size_t> count,
             std::span<const double> values);
    /// Writes flags into the box of a variable that begins at `start` and is `count` wide, each of shape [dimension].
    void put(int variable, std::span<const std::size_t> start, std::span<const std::size_t> count,
             std::span<const signed char> values);
    /// Adds a variable of words, one for each place, and returns its number. In Zarr they are numbered flags of these
    /// names, since the library (4.9.0) cannot write words there.
    int words(const std::string& name, std::span<const int> dimensions, const std::vector<std::string>& values,
              const Description& description);
    /// Adds a variable of numbers of names (CF flags) and returns its number. No number is marked as missing: readers
    /// would turn all of them into floating-point numbers.
    int flags(const std::string& name, std::span<const int> dimensions, std::span<const signed char> values,
              const FlagNames& names, const Description& description);
    /// Adds a variable of flags that come in parts, by `put`, and returns its number.
    int flags(const std::string& name, std::span<const int> dimensions, ChunkShape chunk, const FlagNames& names,
              const Description& description);
    /// Adds an attribute of a variable.
    void attribute(int variable, const std::string& name, const std::string& text);

    /// Ends the file; nothing may be added afterwards.
    void finish();
    /// Ends a file in memory and shows its bytes, which are valid during the call.
    void finish(const std::function<void(std::string_view)>& take);

private:
    void check(int code) const;
    int define(const std::string& name, int type, std::span<const int> dimensions, const Description& description);
    int define_flags(const std::string& name, std::span<const int> dimensions, const FlagNames& names,
                     const Description& description);
    int opened_variable(int variable, std::size_t bytes);
    void pack(int variable, ChunkShape chunk, std::size_t value_size);

    std::string name_;
    DatasetFormat format_ = DatasetFormat::netcdf4;
    std::unique_ptr<storage::Descriptor> parent_;  // of a folder, while it is made
    std::string address_;                          // of a folder
    std::vector<std::string> variables_;           // names, by their numbers
    std::size_t held_ = 0;                         // [bytes] put since the folder was opened
    int id_ = -1;
};

/// Texts by their names, in order.
using Attributes = std::vector<std::pair<std::string, std::string>>;

/// Returns the origin of every file of ours: conventions, title, the program, and the schema "stridor.SCHEMA/1".
Attributes origin_attributes(std::string_view schema, const std::string& title);

/// Puts attributes of the whole file.
void put(NetcdfDataset& file, const Attributes& attributes);

}  // namespace stridor::io
