#include "stridor/base/opened_library.hpp"

#include "stridor/base/error.hpp"

#include <dlfcn.h>

#include <utility>

namespace stridor::base {

OpenedLibrary::OpenedLibrary(std::string file)
    : file_(std::move(file)),
      handle_(::dlopen(file_.c_str(), RTLD_NOW | RTLD_LOCAL)) {
    if (handle_ == nullptr) lack_ = ::dlerror();
}

FoundFunction OpenedLibrary::function(const char* name) {
    if (handle_ == nullptr) return {};
    void* address = ::dlsym(handle_, name);
    if (address == nullptr && lack_.empty()) lack_ = file_ + " has no function " + name;
    return {address};
}

void OpenedLibrary::expect_whole(const std::string& problem) const {
    if (is_whole()) return;
    throw Error(ErrorKind::io,
                {problem, lack_, "Install the library, on Debian with: apt install " + debian_package(file_)});
}

std::string debian_package(const std::string& file) {
    const std::size_t end = file.find(".so.");
    const std::string name = file.substr(0, end);
    if (end == std::string::npos) return name;
    // a hyphen keeps two numbers apart
    const bool ends_in_digit = name.find_last_of("0123456789") == name.size() - 1;
    return name + (ends_in_digit ? "-" : "") + file.substr(end + 4);
}

}  // namespace stridor::base
