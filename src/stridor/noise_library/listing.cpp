#include "stridor/noise_library/listing.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/field_table.hpp"

#include <algorithm>
#include <sstream>
#include <variant>

namespace stridor::noise_library {

namespace {

std::vector<std::string> words_of(Library& library, const std::string& field) {
    if (field != "id") return library.words(field);
    std::vector<std::string> ids;
    for (const Entry& entry : library.find({}))
        ids.push_back(std::to_string(entry.id));
    return ids;
}

std::vector<std::string> usual_words(const std::string& name) {
    const EntryField* field = find_field(name);
    if (field == nullptr) return {};
    if (const auto* text = std::get_if<EntryText>(&field->kind))
        return {text->suggestions.begin(), text->suggestions.end()};
    if (const auto* choice = std::get_if<EntryChoice>(&field->kind))
        return {choice->names.begin(), choice->names.end()};
    return {};
}

}  // namespace

std::vector<std::string> parse_columns(const std::string& text) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, ',');)
        parts.push_back(part);
    return parts;
}

EntryExtent extent_for(std::span<const std::string> columns) {
    EntryExtent extent = EntryExtent::summary;
    for (const std::string& name : columns) {
        const EntryField* field = find_field(name);
        if (field != nullptr && is_document(*field)) return EntryExtent::whole;
        if (field == nullptr && name != "id") extent = EntryExtent::figures;
    }
    return extent;
}

const EntryField& field_named(const std::string& name) {
    if (const EntryField* field = find_field(name)) return *field;
    throw Error(ErrorKind::input, {"\"" + name + "\" is no field", "",
                                   base::did_you_mean(name, field_names([](const EntryField&) { return true; }),
                                                      "`stridor library fields` lists them.")});
}

std::vector<std::string> words_to_choose(const std::filesystem::path& file, const std::string& field) {
    std::vector<std::string> found = usual_words(field);
    try {
        Library library = open_library(file, Access::read);
        for (const std::string& word : words_of(library, field))
            if (std::find(found.begin(), found.end(), word) == found.end()) found.push_back(word);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::io) throw;
    }
    return found;
}

std::vector<FigureKind> figures_in(const std::filesystem::path& file) {
    try {
        return open_library(file, Access::read).figures();
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::io) throw;
        return {};
    }
}

}  // namespace stridor::noise_library
