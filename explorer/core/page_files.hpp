#pragma once

#include <string>

/// The files that a visitor chose together with a case: the page has no others.
namespace stridor::storage {

/// Keeps a file by its name; a page learns of no folders. A file of an archive has the archive's name before it:
/// "k.npz/data.npy".
void keep_file(const std::string& name, std::string bytes);

/// Forgets the files that were kept.
void forget_files();

}  // namespace stridor::storage
