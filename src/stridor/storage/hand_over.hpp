#pragma once

#include "stridor/storage/database.hpp"

#include <filesystem>
#include <functional>
#include <string>

/// Takes a database over from an owner who may be only standing still.
///
/// A process that stood still within a commit goes on writing pages when it wakes, and no lock stops it if locks end at
/// the machine. It writes into the files that it has open. So the new owner puts copies in their place: the copies get
/// the names by `rename`, and the former owner writes into files that have no name any more.
///
/// The former owner may wake at any moment, also during the copying. SQLite writes the old content of a page into its
/// journal before it changes the page. So the journal is copied first, and the copy undoes the change that was begun.
/// If the journal is unchanged afterwards, it was either finished before, or it told of no change yet; if it has
/// changed, all is copied again. The former owner ends with the change in progress: before each change it asks whether
/// the file is still its own (`OwnerFile`).
///
/// The new owner may stand still, too. Files that are to be renamed have unique names, and the next owner removes them
/// (`remove_unfinished`): the rename of a removed file fails.
namespace stridor::storage {

/// Returns a name beside a file for its replacement: "chart.sqlite.new.0123456789abcdef".
std::filesystem::path unfinished_name(const std::filesystem::path& file, const std::string& mark);

/// Removes unfinished replacements that others left beside a file. Call it once the file is claimed.
void remove_unfinished(const std::filesystem::path& file, const std::string& mark);

/// Says whether a change of the database was begun and has not ended: one is being made, or one was cut off.
bool has_open_change(const std::filesystem::path& file);

/// Copies a database as it was before an unfinished change; its owner may go on meanwhile. Throws `Error` (io).
void copy_database(const std::filesystem::path& file, const std::filesystem::path& copy,
                   const DatabaseOptions& options);

/// Replaces a database by a copy of itself, so that whoever had it open has another file. Does nothing if there is no
/// file.
///
/// `mark` is that of the claim. `expect_own` is called before the copy gets the name, and throws if the claim was lost.
/// A file that is not a database is left alone: opening it reports that.
void hand_over(const std::filesystem::path& file, const std::string& mark, const DatabaseOptions& options,
               const std::function<void()>& expect_own);

}  // namespace stridor::storage
