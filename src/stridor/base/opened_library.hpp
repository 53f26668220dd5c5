#pragma once

#include <string>
#include <type_traits>

namespace stridor::base {

/// Where a function of an opened library is: becomes a pointer of the type that it is put into.
struct FoundFunction {
    void* address = nullptr;  // null: not there

    /// The pointer, null where the library lacks the function. Its type is not checked.
    template <typename Function>
    operator Function*() const {
        static_assert(std::is_function_v<Function>);
        return reinterpret_cast<Function*>(address);
    }
};

/// A shared library that is opened while the program runs, and stays open as long as the process lives.
///
/// A library that few commands need is opened this way: linked, it and all it needs would be loaded at every start.
/// Only its headers are needed to build. Its functions are members of a struct, found when the struct is made:
///
///     struct Netcdf {
///         base::OpenedLibrary library{"libnetcdf.so.19"};
///         decltype(&::nc_create) nc_create = library.function("nc_create");
///     };
class OpenedLibrary {
public:
    /// `file` is the name by which the system's loader finds it. All that it refers to is bound at once: it may be used
    /// where nothing may be opened any more.
    explicit OpenedLibrary(std::string file);

    /// A function of it, or of the libraries it needs.
    FoundFunction function(const char* name);

    /// Is it on this machine, with all functions that were asked for?
    bool is_whole() const { return lack_.empty(); }
    /// Throws `Error` (io) unless it is whole: the problem as given ("netCDF files cannot be made"), what is missing,
    /// and the package to install.
    void expect_whole(const std::string& problem) const;

private:
    std::string file_;
    std::string lack_;  // what is missing first; empty: nothing
    void* handle_;
};

/// Debian's package of a shared library: "libnetcdf19" for "libnetcdf.so.19" (Debian Policy 4.6, 8.1).
std::string debian_package(const std::string& file);

}  // namespace stridor::base
