#pragma once

#include "stridor/storage/owner_file.hpp"
#include "stridor/storage/system_io.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

/// The files beside an owner's file with which that is made, and the leftovers of a kill meanwhile.
namespace stridor::storage {

// The text of an owner's file: lines of "key = value".

/// The greatest length of an owner's file.
inline constexpr std::size_t longest_owner_text = 1024;  // [bytes]

/// Returns the text of an owner's file. Its length does not depend on the count.
std::string owner_text(const Owner& owner);

/// Reads the text of an owner's file; a missing value stays empty.
Owner read_owner(std::string_view text);

/// Returns a new mark, different from that of any other owner or draft.
std::string new_mark();

/// Removes a file. A file that cannot be removed stays, and grows old.
void remove_name(const std::filesystem::path& name);

/// What stands at the name of an owner's file.
struct OwnerLook {
    enum class Found {
        nothing,
        owner,
        unreadable,  // a file that cannot be read: another user's, or on a failing disk
        other_thing  // a folder, a link, a pipe: not of this program
    };
    Found found = Found::nothing;
    SeenOwner seen{};       // of an unreadable file only its silence
    std::string state{};    // its inode and time: different after each sign of life
    std::string problem{};  // why it tells nothing: "permission denied", "it is a folder"
};

/// Looks at a name without ever waiting: reads no pipe and follows no link. `now` is the time of the file system [s].
OwnerLook look_at(const std::filesystem::path& name, double now);

/// Returns the owner that a file names, silent since the file was last touched; `std::nullopt` if it cannot be read.
std::optional<SeenOwner> seen_at(const std::filesystem::path& name, double now);

/// A file of this process beside the owner's, "chart.sqlite.owner.0123456789abcdef", removed at its end. Its time is
/// that of the file system, whose clock may differ.
class Draft {
public:
    /// Makes the draft, with a text that names its owner.
    Draft(const std::filesystem::path& owner, std::string_view text, const std::string& shown);
    ~Draft();
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;

    /// Returns the error number (errno) with which making it failed; zero if it was made.
    int failure() const { return code_; }
    /// Returns its path.
    const std::filesystem::path& name() const { return name_; }

    /// Replaces the text by another of equal length. Throws `Error` (io).
    void rewrite(std::string_view text) const;

    /// Returns when it was written [s].
    double time() const;

private:
    std::filesystem::path name_;
    std::string shown_;
    Descriptor file_;
    int code_ = 0;
};

/// Gives a draft a second name. Returns false if the name is taken, or the draft is gone.
bool link_to(const Draft& draft, const std::filesystem::path& name, const std::string& shown);

/// Removes the drafts of an owner's file that kills have left: those of dead processes of this host, and those of other
/// hosts that are an hour old by the time `now` of the file system [s]. A process that stood still for so long and lost
/// its draft makes another.
void remove_left_drafts(const std::filesystem::path& owner, const std::string& host, double now);

}  // namespace stridor::storage
