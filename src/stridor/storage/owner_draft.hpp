#pragma once

#include "stridor/storage/owner_file.hpp"
#include "stridor/storage/system_io.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

/// The files beside an owner's with which it is made, and what a kill in the midst of that leaves.
namespace stridor::storage {

/// Unlike that of any other owner or draft.
std::string new_mark();

/// Removes a file; what cannot be removed stays, and grows old.
void remove_name(const std::filesystem::path& name);

/// What an owner's file says, silent since it was last touched; nothing where there is none. `now` is the time of the
/// file system [s].
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

    /// When it was made [s].
    double time() const;

private:
    std::filesystem::path name_;
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
