#include "stridor/storage/command_cache.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/sha256.hpp"
#include "stridor/base/version.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <system_error>

namespace stridor::storage {

namespace {

// empty where there is none
std::filesystem::path cache_folder() {
    const char* cache = std::getenv("XDG_CACHE_HOME");
    if (cache != nullptr && *cache == '/') return std::filesystem::path(cache) / "stridor";
    const char* home = std::getenv("HOME");
    if (home != nullptr && *home == '/') return std::filesystem::path(home) / ".cache" / "stridor";
    return {};
}

}  // namespace

CommandCache::CommandCache(const std::string& command, const std::string& what,
                           const std::function<void(const std::string&)>& note) {
    // bits of two builds never mix
    const std::string all = fmt::format("{} {}\n{}", base::version(), base::commit(), what);
    const std::filesystem::path folder = cache_folder();
    if (folder.empty()) return;
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    file_ = folder / fmt::format("{}-{}.sqlite", command, base::sha256_text(all).substr(0, 16));
    try {
        results_ = std::make_unique<KeptResults>(file_, all, "cache");
    } catch (const Error& failure) {
        note(fmt::format("nothing is kept of this run, should it be stopped: {}", failure.problem().what));
        return;
    }
    if (results_->found() > 0)
        note(fmt::format("goes on from {} results of a run that was stopped", results_->found()));
}

void CommandCache::finish() {
    if (!results_) return;
    results_.reset();
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
}

}  // namespace stridor::storage
