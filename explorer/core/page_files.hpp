#pragma once

#include <string>

/// The files that a visitor chose together with a case: the page has no others.
namespace stridor::storage {

/// Keeps a file by the last part of its name, which is all that a page learns of it.
void keep_file(const std::string& name, std::string bytes);

/// Forgets the files that were kept.
void forget_files();

}  // namespace stridor::storage
