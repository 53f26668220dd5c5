#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace stridor::explorer {

/// Says whether there is a screen for a browser.
bool has_screen();

/// Opens a file in the user's browser, without waiting; messages of the opener are ignored.
void open_browser(const std::string& file);

/// Says whether a text is a link to a page of the explorer, or its part from "#" on, and not the name of a file.
bool is_link(std::string_view text);

/// Returns the part behind the "#" of a link that *Share* made: the page's whole state, which only the page reads.
///
/// Throws `Error` (input) for a text that no page writes: no "#", no case, a case that needs another machine's file, a
/// character that an address does not hold, or more than 8000 of them.
std::string fragment_of(std::string_view link);

/// A file that leads a browser to a link, in a folder that only its owner can look into; both are removed with the
/// object.
///
/// Everybody on the machine can see how a browser was started: they see the name of this file, but no secret.
class Redirect {
public:
    /// Writes the file. Throws `Error` (io) if it cannot be written.
    explicit Redirect(const std::string& link);
    ~Redirect();
    Redirect(const Redirect&) = delete;
    Redirect& operator=(const Redirect&) = delete;

    /// Returns the file for the browser.
    std::filesystem::path file() const { return folder_ / "open.html"; }

private:
    std::filesystem::path folder_;
};

}  // namespace stridor::explorer
