#include "stridor/io/case/case_changes.hpp"

#include "stridor/base/escapes.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/parameters/case_key.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/recordings/table/sampled_csv.hpp"

#include <algorithm>
#include <memory>
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

TomlDocument document_of(const Case& c, std::span<const CaseChange> changes) {
    const TomlOptions options{.comments = Comments::none, .heading = ""};
    TomlDocument document = parse_toml({case_toml(without_matrices(c), options), "the case", {}});
    for (const CaseChange& change : changes) {
        document.entries.push_back(entry_of(change));
        const std::string& key = document.entries.back().key;
        if (has_given_structure(c) && key.starts_with("structure.") && parameters::field_of(key) == nullptr)
            throw Error(ErrorKind::input, {key + " cannot be set", "the structure has come from matrices",
                                           "Read a file with other matrices."});
    }
    return document;
}

}  // namespace

bool has_given_structure(const Case& c) {
    return c.own_structure && !c.own_structure->recipe;
}

Case without_matrices(const Case& c) {
    if (!has_given_structure(c)) return c;
    Case written = c;
    auto outline = std::make_shared<parameters::OwnStructure>();
    outline->contacts = c.own_structure->contacts;
    if (!c.own_structure->force.empty()) outline->force = {1.0};
    for (parameters::OwnContact& contact : outline->contacts) {
        contact.normal.clear();
        contact.tangent.clear();
        contact.second_tangent.clear();
        contact.interface.clear();
        contact.position.reset();
    }
    written.own_structure = outline;
    return written;
}

Case changed(const Case& c, std::span<const CaseChange> changes) {
    try {
        const TomlDocument document = document_of(c, changes);
        const bool names_samples = std::any_of(document.entries.begin(), document.entries.end(), [](const auto& entry) {
            return entry.key == "drive.file" && entry.origin == TomlOrigin::override;
        });
        CaseReaders readers;
        if (!names_samples && parameters::is_of_file(c.drive))
            readers.samples = [&](const std::string&) {
                return recordings::SampledMotion{c.drive.times, c.drive.velocities};
            };
        if (has_given_structure(c)) readers.structure = [&](const TomlDocument&) { return c.own_structure; };
        return read_case(document, readers);
    } catch (const Error& error) {
        throw without_places(error);
    }
}

}  // namespace stridor::io
