#include "stridor/base/opened_library.hpp"

#include <dlfcn.h>

namespace stridor::base {

OpenedLibrary::OpenedLibrary(const std::string& file)
    : handle_(::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)),
      is_whole_(handle_ != nullptr) {}

FoundFunction OpenedLibrary::function(const char* name) {
    if (handle_ == nullptr) return {};
    void* address = ::dlsym(handle_, name);
    is_whole_ = is_whole_ && address != nullptr;
    return {address};
}

}  // namespace stridor::base
