#pragma once

// An entry of the noise library as JSON. Private to this folder, as json_parts.hpp is.

#include "stridor/io/json_parts.hpp"
#include "stridor/noise_library/field.hpp"

#include <cmath>

namespace stridor::io::json_parts {

/// Returns the known values of an entry, by the names of its fields; documents as they are, figures left out.
inline Json entry_object(const noise_library::Entry& entry) {
    Json object = Json::object();
    if (entry.id != 0) object["id"] = entry.id;
    for (const noise_library::EntryField& field : noise_library::fields()) {
        const std::string name(field.name);
        if (std::holds_alternative<noise_library::EntryQuantity>(field.kind)) {
            const double value = noise_library::quantity_in(entry, field);
            if (!std::isnan(value)) object[name] = value;
        } else if (const std::string& words = noise_library::words_in(entry, field); !words.empty()) {
            object[name] = words;
        }
    }
    return object;
}

}  // namespace stridor::io::json_parts
