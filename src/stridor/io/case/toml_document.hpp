#pragma once

#include "stridor/base/error.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace stridor::io {

/// The text of a case or chart file, and what the command line puts in its place.
struct TomlSource {
    std::string text;
    std::string name;                    // shown in messages; a sampled drive's file is looked for in its folder
    std::vector<std::string> overrides;  // "section.key=value", later ones win over earlier ones and over the file
};

/// Loads a file ("-" for standard input) with its overrides. Throws `Error` (io).
TomlSource load_toml(const std::string& path, std::vector<std::string> overrides = {});

/// A section, and not a value.
struct TomlTable {};

/// A value that no key takes.
struct TomlUnfit {
    std::string_view type;  // "a boolean"
};

/// A list of lists of numbers: a matrix, row by row.
using TomlRows = std::vector<std::vector<double>>;

using TomlValue =
    std::variant<double, std::string, std::vector<std::string>, std::vector<double>, TomlRows, TomlTable, TomlUnfit>;

/// Where an entry was written: in the file, or on the command line.
enum class TomlOrigin { file, override };

/// One key with its value and where both stand.
struct TomlEntry {
    std::string key;  // "contact.preload", "chart.x.from"; a section has an entry of its own
    TomlValue value;
    TomlOrigin origin = TomlOrigin::file;
    base::Place key_place;
    base::Place value_place;
    std::optional<std::size_t> joint{};  // which of several joints it is about; nothing: all, or what they share
};

/// A file taken apart: its entries in the order of its text, then the overrides.
struct TomlDocument {
    std::string name;
    std::vector<TomlEntry> entries;

    /// Returns the entry that decides the value of a key, of several joints for one; nothing if the key is not there.
    const TomlEntry* find(std::string_view key, std::size_t joint = 0) const;
};

/// A document as one of several joints is asked of it; by itself it stands for the first.
struct DocumentView {
    DocumentView(const TomlDocument& of, std::size_t number = 0) : document(of), joint(number) {}
    const TomlEntry* find(std::string_view key) const { return document.find(key, joint); }
    bool has(const TomlEntry& entry) const { return !entry.joint || *entry.joint == joint; }

    const TomlDocument& document;
    std::size_t joint;
};

/// Throws `Error` (input) with the places for text that is not TOML and duplicate keys, or for an override without "=".
TomlDocument parse_toml(const TomlSource& source);

/// Returns one override taken apart; its key may be any spelling of `parameters::field_named`, and is the full one in
/// the entry. Throws `Error` (input) for text without "=" or a key, with control characters, or that is no UTF-8, and
/// for a short name of several keys.
TomlEntry parse_override(const std::string& text);

/// Returns the items of a list that an override writes as "going,coming", or as TOML does.
std::vector<std::string> listed(std::string text);

/// Returns "a number", "text", "a list", "a list of numbers", "a matrix", "a section" or the name of an unfit type.
std::string_view type_name(const TomlValue& value);

/// Returns the error with the place of a key, and with its name if the error does not name it.
Error located(const Error& error, std::string_view key, const base::Place& place);

}  // namespace stridor::io
