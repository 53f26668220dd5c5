#pragma once

#include <string>
#include <type_traits>

namespace stridor::base {

/// The address of a function in an opened library. It converts to a pointer of whatever function type it is assigned
/// to.
struct FoundFunction {
    void* address = nullptr;  // null: not there

    /// Returns the pointer, null if the library lacks the function. The type is not checked.
    template <typename Function>
    operator Function*() const {
        static_assert(std::is_function_v<Function>);
        return reinterpret_cast<Function*>(address);
    }
};

/// A shared library that is opened while the program runs, and stays open as long as the process lives.
///
/// A library that a machine may lack is opened this way. Only its headers are needed to build. Its functions are
/// members of a struct, found when the struct is made:
///
///     struct Matio {
///         base::OpenedLibrary library{"libmatio.so.11"};
///         decltype(&::Mat_Open) open = library.function("Mat_Open");
///     };
class OpenedLibrary {
public:
    /// Opens the library. `file` is the name by which the system's loader finds it. All symbols are bound at once, so
    /// that the library works where no further file may be opened.
    explicit OpenedLibrary(const std::string& file);

    /// Returns a function of the library, or of the libraries that it needs.
    FoundFunction function(const char* name);

    /// Says whether this machine has the library with all functions that were asked for.
    bool is_whole() const { return is_whole_; }

private:
    void* handle_;
    bool is_whole_;
};

}  // namespace stridor::base
