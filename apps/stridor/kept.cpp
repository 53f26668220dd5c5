#include "kept.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/sha256.hpp"
#include "stridor/base/version.hpp"
#include "terminal.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <system_error>

namespace stridor::app {

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

Kept::Kept(const std::string& command, const std::string& what) {
    // bits of two builds never mix
    const std::string all = fmt::format("{} {}\n{}", base::version(), base::commit(), what);
    const std::filesystem::path folder = cache_folder();
    if (folder.empty()) return;
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    file_ = folder / fmt::format("{}-{}.sqlite", command, base::sha256_text(all).substr(0, 16));
    try {
        results_ = std::make_unique<storage::KeptResults>(file_, all, "cache");
    } catch (const Error& failure) {
        say(fmt::format("nothing is kept of this run, should it be stopped: {}", failure.problem().what));
        return;
    }
    if (results_->found() > 0) say(fmt::format("goes on from {} results of a run that was stopped", results_->found()));
}

void Kept::finish() {
    if (!results_) return;
    results_.reset();
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
}

}  // namespace stridor::app
