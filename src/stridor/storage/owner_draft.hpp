#pragma once

#include "stridor/storage/owner_file.hpp"
#include "stridor/storage/system_io.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

/// The files beside an owner's with which it is made, and what a kill in the midst of that leaves.
namespace stridor::storage {

// The text of an owner's file: lines of "key = value".

/// No owner's file is longer.
inline constexpr std::size_t longest_owner_text = 1024;  // [bytes]

/// Of the same length whatever the count.
std::string owner_text(const Owner& owner);

/// Reads it; what is not there stays empty.
Owner read_owner(std::string_view text);

/// Unlike that of any other owner or draft.
std::string new_mark();

/// Removes a file; what cannot be removed stays, and grows old.
void remove_name(const std::filesystem::path& name);

/// What stands where an owner's file may be.
struct OwnerLook {
    enum class Found {
        nothing,
        owner,
        unreadable,  // a file that does not let itself be read: another user's, or on a disk that fails
        other_thing  // a folder, a link, a pipe: none of this program's
    };
    Found found = Found::nothing;
    SeenOwner seen{};       // of an unreadable file only its silence
    std::string state{};    // which file it is and when it was touched: another with each sign of life
    std::string problem{};  // why it says nothing: "permission denied", "it is a folder"
};

/// Looks at a name, and never waits: no pipe is read and no link followed. `now` is the time of the file system [s].
OwnerLook look_at(const std::filesystem::path& name, double now);

/// Reads what an owner's file says, silent since it was last touched; `std::nullopt` where none can be read.
std::optional<SeenOwner> seen_at(const std::filesystem::path& name, double now);

/// A file of its own beside the owner's, "chart.sqlite.owner.0123456789abcdef", gone with this: its time is that of the
/// file system, whose clock may be another.
class Draft {
public:
    /// Makes it, with a text that says whose it is.
    Draft(const std::filesystem::path& owner, std::string_view text, const std::string& shown);
    ~Draft();
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;

    /// The number of what kept it from being made; zero if it was.
    int failure() const { return code_; }
    /// Where it stands.
    const std::filesystem::path& name() const { return name_; }

    /// Says something else, of the same length. Throws `Error` (io).
    void rewrite(std::string_view text) const;

    /// When it was written [s].
    double time() const;

private:
    std::filesystem::path name_;
    std::string shown_;
    Descriptor file_;
    int code_ = 0;
};

/// Gives a draft a second name; false if the name is taken, or the draft is gone.
bool link_to(const Draft& draft, const std::filesystem::path& name, const std::string& shown);

/// Removes the drafts of an owner's file that kills have left: those of processes of this host that are no more, and
/// those of other hosts that are an hour old by the time `now` of the file system [s]. Who stood still for so long and
/// lost his makes another.
void remove_left_drafts(const std::filesystem::path& owner, const std::string& host, double now);

}  // namespace stridor::storage
