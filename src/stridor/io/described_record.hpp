#pragma once

#include <string_view>
#include <vector>

namespace stridor::io {

/// What one member of a record is in documents.
struct DescribedMember {
    std::string_view key;
    std::string_view unit{};           // "s"; "1" for a share; empty for words, counts and flags
    std::string_view sentence{};       // what it is, for who reads a document by a program
    std::string_view type = "number";  // in TypeScript
};

/// A record of documents with its members in their order: the page's type of it is made from this.
struct DescribedRecord {
    std::string_view name;      // "Silence"
    std::string_view sentence;  // what it tells
    std::vector<DescribedMember> members;
};

}  // namespace stridor::io
