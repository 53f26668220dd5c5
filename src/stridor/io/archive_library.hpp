#pragma once

// libarchive, opened when the first archive is read: linked to the program, it and the thirteen libraries it needs
// would be loaded at every start. Private to this module.

#include "stridor/base/opened_library.hpp"

#include <archive.h>
#include <archive_entry.h>

namespace stridor::io {

/// The functions that Stridor uses, of the version it was built with.
struct Libarchive {
    base::OpenedLibrary library{STRIDOR_ARCHIVE_LIBRARY};
    decltype(&::archive_entry_filetype) entry_filetype = library.function("archive_entry_filetype");
    decltype(&::archive_entry_hardlink) entry_hardlink = library.function("archive_entry_hardlink");
    decltype(&::archive_entry_pathname) entry_pathname = library.function("archive_entry_pathname");
    decltype(&::archive_entry_size) entry_size = library.function("archive_entry_size");
    decltype(&::archive_errno) error_number = library.function("archive_errno");
    decltype(&::archive_error_string) error_string = library.function("archive_error_string");
    decltype(&::archive_filter_bytes) filter_bytes = library.function("archive_filter_bytes");
    decltype(&::archive_filter_count) filter_count = library.function("archive_filter_count");
    decltype(&::archive_format_name) format_name = library.function("archive_format_name");
    decltype(&::archive_read_data_block) read_data_block = library.function("archive_read_data_block");
    decltype(&::archive_read_free) read_free = library.function("archive_read_free");
    decltype(&::archive_read_new) read_new = library.function("archive_read_new");
    decltype(&::archive_read_next_header) read_next_header = library.function("archive_read_next_header");
    decltype(&::archive_read_open) read_open = library.function("archive_read_open");
    decltype(&::archive_read_open_filename) read_open_filename = library.function("archive_read_open_filename");
    decltype(&::archive_read_open_memory2) read_open_memory = library.function("archive_read_open_memory2");
    decltype(&::archive_read_support_filter_gzip) support_gzip = library.function("archive_read_support_filter_gzip");
    decltype(&::archive_read_support_filter_xz) support_xz = library.function("archive_read_support_filter_xz");
    decltype(&::archive_read_support_filter_zstd) support_zstd = library.function("archive_read_support_filter_zstd");
    decltype(&::archive_read_support_format_raw) support_raw = library.function("archive_read_support_format_raw");
    decltype(&::archive_read_support_format_tar) support_tar = library.function("archive_read_support_format_tar");
    decltype(&::archive_read_support_format_zip_seekable) support_zip =
        library.function("archive_read_support_format_zip_seekable");
};

/// Opens the library. Throws `Error` (io) where it is not on this machine.
const Libarchive& libarchive();

}  // namespace stridor::io
