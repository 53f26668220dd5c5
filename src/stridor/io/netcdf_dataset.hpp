#pragma once

#include "stridor/storage/system_io.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::io {

/// May numbers be missing (NaN)? Coordinates may not.
enum class MissingNumbers { no, as_nan };

/// What a variable is, for its attributes.
struct Description {
    std::string_view units;      // empty: none
    std::string_view long_name;  // empty: none
    MissingNumbers missing = MissingNumbers::as_nan;
};

/// How a variable that comes in parts lies in the file: in boxes of this shape [dimension], each packed without loss.
/// Parts should be made of whole boxes: what fills one but partly has it unpacked and packed again.
using ChunkShape = std::span<const std::size_t>;

/// Names of numbers from 0 on; -1 stands for `none`, the last of them, where `none` is not empty.
struct FlagNames {
    std::span<const std::string_view> names;
    std::string_view none{};
};

/// What a dataset becomes.
enum class DatasetFormat {
    netcdf4,
    zarr,  // a folder of the layout Zarr 2, with dimensions named as xarray does it
};

/// A netCDF-4 file being made, a thin cover over the C library; `name` appears in errors.
///
/// Dimensions are known by the numbers the library gives them. Variables are written whole, in one call, or in parts.
class NetcdfDataset {
public:
    /// In memory.
    explicit NetcdfDataset(std::string name);
    /// In `path`, which may be there; for Zarr an absolute one, of a folder with a plain name. HDF5 takes a write that
    /// fails for the end of the process (a segmentation fault, there or at the process' end): only in a process that
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

    /// Each returns the variable's number.
    int doubles(const std::string& name, std::span<const int> dimensions, std::span<const double> values,
                const Description& description);
    /// Numbers that come in parts, by `put`; until then they are missing.
    int doubles(const std::string& name, std::span<const int> dimensions, ChunkShape chunk,
                const Description& description);
    /// Puts values into the box of a variable that begins at `start` and is `count` wide, each of shape [dimension].
    void put(int variable, std::span<const std::size_t> start, std::span<const std::size_t> count,
             std::span<const double> values);
    /// Likewise, of flags.
    void put(int variable, std::span<const std::size_t> start, std::span<const std::size_t> count,
             std::span<const signed char> values);
    /// Words, one of each place: in Zarr numbered flags of these names, for the library (4.9.0) cannot write words
    /// there.
    int words(const std::string& name, std::span<const int> dimensions, const std::vector<std::string>& values,
              const Description& description);
    /// Numbers of names (CF flags). No number is called missing: readers would make floating-point numbers of all of
    /// them.
    int flags(const std::string& name, std::span<const int> dimensions, std::span<const signed char> values,
              const FlagNames& names, const Description& description);
    /// Likewise, in parts.
    int flags(const std::string& name, std::span<const int> dimensions, ChunkShape chunk, const FlagNames& names,
              const Description& description);
    /// Adds an attribute of a variable.
    void attribute(int variable, const std::string& name, const std::string& text);

    /// Ends the file; nothing may be added after it.
    void finish();
    /// Ends a file in memory and shows its bytes, which go with the call.
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

/// What every file of ours says of itself: conventions, title, the program, and the schema "stridor.SCHEMA/1".
void put_origin(NetcdfDataset& file, std::string_view schema, const std::string& title);

}  // namespace stridor::io
