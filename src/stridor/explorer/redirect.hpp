#pragma once

#include <filesystem>
#include <string>

namespace stridor::explorer {

/// A file that leads a browser on to a link, in a folder that only its owner can look into; both go with the object.
///
/// Everybody on the machine sees how a browser was started. They see the name of this file, and no secret.
class Redirect {
public:
    /// Throws `Error` (io) where it cannot be written.
    explicit Redirect(const std::string& link);
    ~Redirect();
    Redirect(const Redirect&) = delete;
    Redirect& operator=(const Redirect&) = delete;

    /// The file that a browser is to open.
    std::filesystem::path file() const { return folder_ / "open.html"; }

private:
    std::filesystem::path folder_;
};

}  // namespace stridor::explorer
