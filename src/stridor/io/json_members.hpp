#pragma once

// From one description of a record its JSON object, its units and its type. Private to this folder, as json_parts.hpp
// is.

#include "stridor/base/json.hpp"
#include "stridor/io/described_record.hpp"

#include <string>
#include <string_view>
#include <variant>

namespace stridor::io {

/// A member of a record: what it is, and where its value comes from.
template <typename Record>
struct Member {
    DescribedMember about;
    std::variant<double Record::*, base::Json (*)(const Record&)> value;
};

/// Returns a record as an object, its members in their order.
template <typename Members, typename Record>
base::Json object_of(const Members& members, const Record& record) {
    base::Json object = base::Json::object();
    for (const Member<Record>& member : members) {
        const auto* const number = std::get_if<double Record::*>(&member.value);
        object[std::string(member.about.key)] =
            number != nullptr ? base::Json(record.**number) : std::get<1>(member.value)(record);
    }
    return object;
}

/// Records as a list of objects.
template <typename Members, typename Records>
base::Json objects_of(const Members& members, const Records& records) {
    base::Json array = base::Json::array();
    for (const auto& record : records)
        array.push_back(object_of(members, record));
    return array;
}

/// Puts the units of members that stand at `place` ("outcome.silence."), but `shared`: that was told of all of them.
template <typename Members>
void put_units(base::Json& units, const std::string& place, const Members& members, std::string_view shared = {}) {
    for (const auto& member : members)
        if (const std::string_view unit = member.about.unit; !unit.empty() && unit != shared)
            units[place + std::string(member.about.key)] = unit;
}

/// Returns the description of a record alone.
template <typename Members>
DescribedRecord described(std::string_view name, std::string_view sentence, const Members& members) {
    DescribedRecord record{name, sentence, {}};
    for (const auto& member : members)
        record.members.push_back(member.about);
    return record;
}

}  // namespace stridor::io
