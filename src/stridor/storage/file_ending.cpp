#include "stridor/storage/file_ending.hpp"

#include "stridor/base/error.hpp"

#include <algorithm>
#include <filesystem>

namespace stridor::storage {

void expect_ending(const std::string& option, const std::string& file,
                   std::initializer_list<std::string_view> endings) {
    const std::string ending = std::filesystem::path(file).extension().string();
    if (ending.empty() || std::find(endings.begin(), endings.end(), ending) != endings.end()) return;
    std::string known;
    for (const std::string_view each : endings)
        known += (known.empty() ? "" : " or ") + std::string(each);
    throw Error(ErrorKind::input,
                {option + " " + file + " has an ending that says nothing", "the ending chooses the format: " + known,
                 "Name it " + std::filesystem::path(file).replace_extension(*endings.begin()).string() + "."});
}

}  // namespace stridor::storage
