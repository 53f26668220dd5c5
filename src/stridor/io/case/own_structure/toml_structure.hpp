#pragma once

#include "stridor/io/case/complaints.hpp"
#include "stridor/io/case/own_structure/structure_matrices.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/parameters/own_structure.hpp"

#include <memory>
#include <span>
#include <string_view>

namespace stridor::io {

/// Kinds of keys of [structure], by what they take.
enum class StructureKeys {
    matrices,    // mass = [[...]], or the name of a file
    numbers,     // damping_ratio
    lists,       // load: a number for each row
    texts,       // file, or a list of them
    of_contact,  // keys of [[structure.contact]]
    of_output,   // keys of [[structure.output]]
    of_spring,   // keys of [[structure.spring]]
};
std::span<const std::string_view> structure_keys(StructureKeys kind);

/// Says whether a file has a structure of its own, as [structure].
bool has_own_structure(const TomlDocument& document);

/// Returns the document as a case reads it: without what only [structure] says. Complains of [joint], [plate],
/// [temperature].
TomlDocument without_structure(const TomlDocument& document, Complaints& complaints);

/// Reads [structure]: matrices in the file itself, of files, or of a builder, its dampings, its load and its contacts.
/// Opens the files that it names, beside the document; so it is for documents of the program's own user only.
///
/// Throws `Error` (input) for unknown keys, matrices that do not fit or are no structure (`reduction::expect_sound`,
/// and a mass that is not positive definite), and what `contacts_at` and `share_preload` refuse.
std::shared_ptr<const parameters::OwnStructure> read_own_structure(const TomlDocument& document);

/// Reads the finite-element part that [structure] of a document names, with the labels and places of its nodes. Throws
/// `Error` (input) where a case has none.
NamedPart part_of_case(const TomlDocument& document);

/// Reads the structure of a document whose user may name no files. Throws `Error` (input) as above, and for a file that
/// it would open.
std::shared_ptr<const parameters::OwnStructure> read_enclosed_structure(const TomlDocument& document);

}  // namespace stridor::io
