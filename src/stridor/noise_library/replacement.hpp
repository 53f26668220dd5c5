#pragma once

#include "stridor/noise_library/entry.hpp"
#include "stridor/storage/database.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace stridor::noise_library {

/// A library's database written anew beside it ("library.sqlite.new"), which takes its name once it is whole. Gone if
/// it is never kept; what a killed process left of one is removed by the next. Whoever calls keeps others from writing
/// the
/// library.
class Replacement {
public:
    /// Throws `Error` (io) where there is no room for it.
    explicit Replacement(const std::filesystem::path& library);
    ~Replacement();
    Replacement(const Replacement&) = delete;
    Replacement& operator=(const Replacement&) = delete;

    /// Adds an entry under its id, or under a new one if it has none; returns its id.
    std::int64_t write(const Entry& entry);

    /// No id up to this one is given again.
    void reserve(std::int64_t last_id);

    /// Brings it to the disk and gives it the library's name and permissions; nothing is written afterwards.
    void keep();

private:
    std::filesystem::path library_;
    std::filesystem::path file_;
    std::optional<storage::Database> database_;
    std::optional<storage::Transaction> transaction_;
};

}  // namespace stridor::noise_library
