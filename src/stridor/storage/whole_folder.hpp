#pragma once

#include <filesystem>

namespace stridor::storage {

/// A folder of files that appears under its name only as a whole; what had the name before goes then. Gone without a
/// trace if it is never committed. One process at a time may make a folder of a name.
class WholeFolder {
public:
    /// Begins an empty one beside the name. Throws `Error` (io).
    explicit WholeFolder(const std::filesystem::path& path);
    ~WholeFolder();
    WholeFolder(const WholeFolder&) = delete;
    WholeFolder& operator=(const WholeFolder&) = delete;

    /// The name it has until then.
    const std::filesystem::path& temporary() const { return temporary_; }

    /// Brings it to the disk and gives it its name. Throws `Error` (io).
    void commit();

private:
    std::filesystem::path path_;
    std::filesystem::path temporary_;
};

}  // namespace stridor::storage
