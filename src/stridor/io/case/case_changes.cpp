#include "stridor/io/case/case_changes.hpp"

#include "stridor/base/escapes.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/case/case_document.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/recordings/table/sampled_csv.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace stridor::io {

namespace {

using parameters::Case;

TomlEntry entry_of(const CaseChange& change) {
    if (change.name.find('=') != std::string::npos)
        base::refuse("\"" + base::visible(change.name) + "\" is no key of a case", "", "");
    const auto* text = std::get_if<std::string>(&change.value);
    // looks for letters that no value may have, and for what the name means
    TomlEntry entry =
        parse_override(change.name + "=" + (text != nullptr ? *text : base::shortest(std::get<double>(change.value))));
    // not as it reads back: quotes around a title are its own, and a number keeps its bits
    if (text != nullptr)
        entry.value = *text;
    else
        entry.value = std::get<double>(change.value);
    return entry;
}

// nobody wrote a file here
Error without_places(const Error& error) {
    std::vector<base::Complaint> complaints = error.complaints();
    for (base::Complaint& complaint : complaints)
        complaint.place.reset();
    return Error::of(error.kind(), std::move(complaints));
}

TomlDocument changed_document(const Case& c, std::span<const CaseChange> changes) {
    TomlDocument document = document_of(c);
    for (const CaseChange& change : changes) {
        document.entries.push_back(entry_of(change));
        const std::string& key = document.entries.back().key;
        if (parameters::has_given_structure(c) && key.starts_with("structure.") && parameters::field_of(key) == nullptr)
            throw Error(ErrorKind::input, {key + " cannot be set", "the structure has come from matrices",
                                           "Read a file with other matrices."});
    }
    return document;
}

}  // namespace

Case changed(const Case& c, std::span<const CaseChange> changes) {
    try {
        const TomlDocument document = changed_document(c, changes);
        const bool names_samples = std::any_of(document.entries.begin(), document.entries.end(), [](const auto& entry) {
            return entry.key == "drive.file" && entry.origin == TomlOrigin::override;
        });
        CaseReaders readers;
        if (!names_samples && parameters::is_of_file(c.drive))
            readers.samples = [&](const std::string&) {
                return recordings::SampledMotion{c.drive.times, c.drive.velocities};
            };
        if (parameters::has_given_structure(c))
            readers.structure = [&](const TomlDocument&) { return c.own_structure; };
        return read_case(document, readers);
    } catch (const Error& error) {
        throw without_places(error);
    }
}

}  // namespace stridor::io
