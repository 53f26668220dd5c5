#pragma once

#include "stridor/io/case/toml_document.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::io {

/// Which numbers a key takes.
enum class Bound { any, not_negative, positive };

/// The keys of one table of a document that are no fields of the field table: "structure.", "structure.contact.2.".
///
/// Each function throws `Error` (input) at the entry for a value of another kind, unit or range.
class TomlSection {
public:
    TomlSection(const TomlDocument& document, std::string prefix) : document_(&document), prefix_(std::move(prefix)) {}

    /// Returns the entry that decides a key; null if there is none.
    const TomlEntry* find(std::string_view name) const { return document_->find(prefix_ + std::string(name)); }
    bool has(std::string_view name) const { return find(name) != nullptr; }
    /// Returns the entry that decides a key. Throws `Error` (input) if there is none.
    const TomlEntry& need(std::string_view name) const;

    /// Returns a number or text with a unit, in `unit`.
    double quantity(std::string_view name, std::string_view unit, Bound bound) const;
    std::optional<double> find_quantity(std::string_view name, std::string_view unit, Bound bound) const;
    /// Returns a count between two.
    int count(std::string_view name, int least, int most) const;
    /// Returns text; a number is taken as text as well: a node may be either.
    std::string text(std::string_view name) const;
    std::string text_or(std::string_view name, std::string fallback) const;
    /// Returns text or a list of texts.
    std::vector<std::string> texts(std::string_view name) const;
    /// Returns a list of numbers; a number of them where `size` is not zero.
    std::vector<double> numbers(std::string_view name, std::size_t size = 0) const;

    /// Returns where the table opens, or the document.
    base::Place place() const;
    /// Returns the path of a file that a key names: beside the document, or from the current folder for an override.
    std::string path(const TomlEntry& entry, const std::string& name) const;

    /// Refuses a value of another kind.
    [[noreturn]] void refuse_kind(const TomlEntry& entry, std::string_view expected) const;

private:
    const TomlDocument* document_;
    std::string prefix_;
};

}  // namespace stridor::io
