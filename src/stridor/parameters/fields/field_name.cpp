#include "stridor/parameters/fields/field_name.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"

#include <algorithm>

namespace stridor::parameters {

namespace {

std::string quoted(std::string_view text) {
    return "\"" + std::string(text) + "\"";
}

std::string_view last_part(std::string_view name) {
    const std::size_t point = name.rfind('.');
    return point == std::string_view::npos ? name : name.substr(point + 1);
}

Error ambiguous(std::string_view name, const std::vector<const Field*>& called) {
    std::string keys;
    for (const Field* field : called)
        keys += (keys.empty() ? "" : " or ") + key_of(*field);
    return {ErrorKind::input,
            {quoted(name) + " has several meanings", "a short name has to be the only one of its kind",
             "Write " + keys + "."}};
}

Error unknown(std::string_view name) {
    const std::string near = similar_key(name);
    return {ErrorKind::input,
            {quoted(name) + " is no key of a case", "",
             near.empty() ? "`stridor check FILE` lists the keys of a case." : "Did you mean " + near + "?"}};
}

// keys of the same section that end in the name's last part: "joint.stiffness" is the axial or the flexural one
std::string ending_alike(std::string_view name) {
    const std::string_view last = last_part(name);
    std::string keys;
    for (const Field& field : fields())
        if (key_of(field) == std::string(name.substr(0, name.size() - last.size())) + std::string(field.name) &&
            field.name.ends_with("_" + std::string(last)))
            keys += (keys.empty() ? "" : " or ") + key_of(field);
    return keys;
}

}  // namespace

std::string_view short_name(const Field& field) {
    return field.name == "value" ? field.section : field.name;
}

std::vector<const Field*> fields_called(std::string_view name) {
    if (const Field* field = find_field(name)) return {field};
    std::vector<const Field*> called;
    for (const Field& field : fields())
        if (!name.empty() && (short_name(field) == name || field.symbol == name)) called.push_back(&field);
    // who writes "mass" means no builder's, unless nothing else is called so
    const auto is_builders = [](const Field* field) { return is_of_builder(*field); };
    if (!std::all_of(called.begin(), called.end(), is_builders)) std::erase_if(called, is_builders);
    return called;
}

const Field& field_named(std::string_view name) {
    const std::vector<const Field*> called = fields_called(name);
    if (called.empty()) throw unknown(name);
    if (called.size() > 1) throw ambiguous(name, called);
    return *called.front();
}

const Field& quantity_named(std::string_view name) {
    const Field& field = field_named(name);
    if (std::holds_alternative<Quantity>(field.kind)) return field;
    throw Error(ErrorKind::input, {quoted(name) + " is no quantity", "it has names or text instead of numbers", ""});
}

std::string similar_key(std::string_view name) {
    if (std::string within = ending_alike(name); !within.empty()) return within;
    const std::vector<const Field*> called = fields_called(last_part(name));
    if (called.size() == 1) return key_of(*called.front());
    if (std::string near = nearest_key(name); !near.empty()) return near;
    std::vector<std::string_view> names;
    for (const Field& field : fields())
        names.push_back(short_name(field));
    const std::vector<const Field*> near = fields_called(base::nearest_name(last_part(name), names));
    return near.size() == 1 ? key_of(*near.front()) : std::string();
}

}  // namespace stridor::parameters
