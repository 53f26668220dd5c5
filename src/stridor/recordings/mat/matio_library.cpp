#include "stridor/recordings/mat/matio_library.hpp"

#include <dlfcn.h>

#include <memory>
#include <type_traits>

namespace stridor::recordings {

namespace {

std::unique_ptr<const Matio> opened_matio() {
    // bound at once: where it works, it may open nothing any more
    void* handle = ::dlopen(STRIDOR_MATIO_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr) return nullptr;
    auto matio = std::make_unique<Matio>();
    const auto find = [&](auto& function, const char* name) {
        function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(::dlsym(handle, name));
        return function != nullptr;
    };
    const bool is_whole = find(matio->Mat_Open, "Mat_Open") &&
                          find(matio->Mat_VarReadNextInfo, "Mat_VarReadNextInfo") &&
                          find(matio->Mat_VarReadDataAll, "Mat_VarReadDataAll");
    if (!is_whole) return nullptr;
    return matio;
}

}  // namespace

const Matio* matio_library() {
    static const std::unique_ptr<const Matio> library = opened_matio();
    return library.get();
}

}  // namespace stridor::recordings
