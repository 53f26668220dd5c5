#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace stridor::explorer {

/// Is there a screen that a browser could show something on?
bool has_screen();

/// Opens a file in the user's browser, without waiting for it; what the opener says is of no interest.
void open_browser(const std::string& file);

/// Is this a link to a page of the explorer, or its part from "#" on, and not the name of a file?
bool is_link(std::string_view text);

/// What stands behind the "#" of a link that *Share* made: the page's whole state, which the page alone reads.
///
/// Throws `Error` (input) for what no page writes: no "#", no case, one that leans on another machine's file, a
/// character that an address does not hold, or more than 8000 of them.
std::string fragment_of(std::string_view link);

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
