#pragma once

#include "stridor/storage/kept_results.hpp"

#include <filesystem>
#include <memory>
#include <string>

namespace stridor::app {

/// Finished parts of a long command, kept in the user's cache folder ($XDG_CACHE_HOME or ~/.cache, stridor/) until the
/// command ends: the same command goes on from them.
class Kept {
public:
    /// `command` names the file, `what` is all that decides the results. Where nothing can be kept (no such folder,
    /// another process has it) the work is done without, and stderr says so.
    Kept(const std::string& command, const std::string& what);

    /// Nothing where nothing can be kept.
    storage::KeptResults* results() { return results_.get(); }

    /// The command has its result: removes the file.
    void finish();

private:
    std::filesystem::path file_;
    std::unique_ptr<storage::KeptResults> results_;
};

}  // namespace stridor::app
