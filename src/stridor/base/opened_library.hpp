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
/// A library that a machine may lack is opened this way. Only its headers are needed to build. Its functions are
/// members of a struct, found when the struct is made:
///
///     struct Matio {
///         base::OpenedLibrary library{"libmatio.so.11"};
///         decltype(&::Mat_Open) open = library.function("Mat_Open");
///     };
class OpenedLibrary {
public:
    /// `file` is the name by which the system's loader finds it. All that it refers to is bound at once: it may be used
    /// where nothing may be opened any more.
    explicit OpenedLibrary(const std::string& file);

    /// A function of it, or of the libraries it needs.
    FoundFunction function(const char* name);

    /// Is it on this machine, with all functions that were asked for?
    bool is_whole() const { return is_whole_; }

private:
    void* handle_;
    bool is_whole_;
};

}  // namespace stridor::base
