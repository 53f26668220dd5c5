#pragma once

#include "stridor/storage/kept_results.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace stridor::storage {

/// Finished parts of a long command, kept in the user's cache folder ($XDG_CACHE_HOME or ~/.cache, stridor/) until the
/// command ends: the same command goes on from them.
class CommandCache {
public:
    /// `command` names the file, `what` is all that decides the results. Where nothing can be kept (no such folder,
    /// another process has it) the work is done without, and `note` is told so, as it is told what was found.
    CommandCache(const std::string& command, const std::string& what,
                 const std::function<void(const std::string&)>& note);

    /// Nothing where nothing can be kept.
    KeptResults* results() { return results_.get(); }

    /// The command has its result: removes the file.
    void finish();

private:
    std::filesystem::path file_;
    std::unique_ptr<KeptResults> results_;
};

}  // namespace stridor::storage
