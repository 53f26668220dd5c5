#pragma once

#include "stridor/storage/database.hpp"

#include <filesystem>
#include <functional>
#include <string>

/// Taking a database over from one who may only be standing still.
///
/// A process that stands still within a commit goes on writing pages when it wakes, and no lock keeps it away where
/// locks end at the machine. What it writes goes into the files that it has open. So whoever takes over puts copies in
/// their place: they get the names by `rename`, and the former owner writes into files that have none any more.
///
/// It wakes at any moment, also while they are copied. SQLite writes into its journal what the pages were before it
/// changes any: the journal is copied first, and the copy undoes what was begun. A journal that is the same afterwards
/// was either finished before, or told of no change yet; if it is another by then all is copied again. The former owner
/// ends with the change that he was at: before each one he asks whether the file is his still (`OwnerFile`).
///
/// Who takes over may stand still, too. Files that are to be renamed have names that tell them from all others, and
/// whoever comes next removes them (`remove_unfinished`): a rename of what is gone fails.
namespace stridor::storage {

/// A name beside a file for what is to take its place: "chart.sqlite.new.0123456789abcdef".
std::filesystem::path unfinished_name(const std::filesystem::path& file, const std::string& mark);

/// Removes what others were about to put in the place of a file. To be called once it is claimed.
void remove_unfinished(const std::filesystem::path& file, const std::string& mark);

/// Was a change of the database begun that has not ended? So it is while one is made, and after one that was cut off.
bool has_open_change(const std::filesystem::path& file);

/// Copies a database as it was before a change that has not ended; whoever fills it may go on meanwhile. Throws `Error`
/// (io).
void copy_database(const std::filesystem::path& file, const std::filesystem::path& copy,
                   const DatabaseOptions& options);

/// Puts a copy of a database in its place, so that whoever had it open has another file. Nothing where there is none.
///
/// `mark` is that of the claim. `expect_own` is called before the copy gets the name, and throws if the claim was lost.
/// A file that is no database is left alone: whoever opens it says so.
void hand_over(const std::filesystem::path& file, const std::string& mark, const DatabaseOptions& options,
               const std::function<void()>& expect_own);

}  // namespace stridor::storage
