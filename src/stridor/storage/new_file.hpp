#pragma once

#include "stridor/storage/system_io.hpp"
#include "stridor/storage/temporary.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace stridor::storage {

/// A file that is written in pieces and has its name only once it is whole and on the disk.
///
/// It stands under a temporary name first, and is removed unless `keep` gave it its own. What fails throws `Error` (io)
/// with the name the user knows and the reason.
class NewFile {
public:
    /// Begins a file under a temporary name that does not exist yet; `shown` is what errors call it.
    NewFile(std::filesystem::path temporary, std::string shown);
    /// Goes on with one that is locked.
    NewFile(Temporary begun, std::string shown);
    ~NewFile();
    NewFile(NewFile&& other) noexcept;
    NewFile& operator=(NewFile&&) = delete;

    /// Adds bytes at the end.
    void write(std::string_view bytes);

    /// The descriptor, for what writes by itself.
    int number() const { return descriptor_.number(); }
    /// The name it stands under until `keep`.
    const std::filesystem::path& temporary() const { return temporary_; }

    /// Brings everything to the disk and closes the file; nothing may be written afterwards.
    void finish();

    /// Renames the finished file, over another one if need be, and brings the folder to the disk.
    void keep(const std::filesystem::path& name);

    /// What was written so far.
    std::uint64_t size() const { return size_; }  // [bytes]

private:
    std::filesystem::path temporary_;  // empty once it is renamed
    std::string shown_;
    Descriptor descriptor_;
    Descriptor lock_{-1};
    std::uint64_t size_ = 0;
};

}  // namespace stridor::storage
