#include "stridor/io/case/own_structure/built_structure.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/field_table.hpp"
#include "stridor/model/built/built_structure.hpp"
#include "stridor/parameters/fields/field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace stridor::io {

namespace {

using parameters::Recipe;
using Holds = BuilderKey::Holds;
using Need = BuilderKey::Need;

constexpr int most_blocks = 100;
constexpr int most_modes = 1000;
constexpr std::array<std::string_view, 2> string_starts{"rest", "helmholtz"};

constexpr BuilderKey required(std::string_view name) {
    return {.name = name};
}
constexpr BuilderKey optional(std::string_view name) {
    return {.name = name, .need = Need::optional};
}
constexpr BuilderKey count(std::string_view name, int most, std::string_view sentence) {
    return {.name = name, .holds = Holds::count, .most = most, .sentence = sentence};
}

constexpr std::array chain_keys{count("blocks", most_blocks, "number of blocks in a row"), required("mass"),
                                required("stiffness"), optional("damping"), optional("coupling")};
constexpr std::array string_keys{required("frequency"),
                                 required("impedance"),
                                 optional("length"),
                                 required("damping_ratio"),
                                 optional("bridge_resistance"),
                                 required("position"),
                                 count("modes", most_modes, "number of modes"),
                                 BuilderKey{.name = "start",
                                            .holds = Holds::word,
                                            .need = Need::optional,
                                            .words = string_starts,
                                            .sentence = "\"rest\", or \"helmholtz\": in the motion of a bowed string"}};
constexpr std::array beam_keys{required("length"),
                               required("mass_per_length"),
                               required("bending_stiffness"),
                               required("axial_stiffness"),
                               required("damping_ratio"),
                               required("incidence_angle"),
                               count("modes", most_modes, "number of bending modes; an axial one comes besides")};
constexpr std::array<StructureBuilder, 3> all_builders{{{"chain", chain_keys, model::built_chain},
                                                        {"string", string_keys, model::built_string},
                                                        {"beam", beam_keys, model::built_beam}}};

const parameters::Field& field_of(const BuilderKey& key) {
    const parameters::Field* field = parameters::find_field("structure." + std::string(key.name));
    STRIDOR_EXPECT(field != nullptr);
    return *field;
}

double quantity_in(const TomlSection& section, const BuilderKey& key) {
    const parameters::Field& field = field_of(key);
    const double value = section.quantity(key.name, parameters::unit_of(field), Bound::any);
    try {
        parameters::expect_in_range(parameters::Case{}, field, value);
    } catch (const Error& error) {
        const TomlEntry& entry = section.need(key.name);
        throw located(error, entry.key, entry.value_place);
    }
    return value;
}

std::string word_in(const TomlSection& section, const BuilderKey& key) {
    const std::string word = section.text(key.name);
    if (std::find(key.words.begin(), key.words.end(), word) != key.words.end()) return word;
    section.refuse_kind(section.need(key.name), fmt::format("\"{}\"", fmt::join(key.words, "\" or \"")));
}

}  // namespace

std::span<const StructureBuilder> structure_builders() {
    return all_builders;
}

std::string_view sentence_of(const BuilderKey& key) {
    return key.holds == Holds::quantity ? field_of(key).sentence : key.sentence;
}

parameters::OwnStructure built_structure(const StructureBuilder& builder, const TomlSection& section) {
    Recipe recipe{.builder = std::string(builder.name), .build = builder.build};
    for (const BuilderKey& key : builder.keys) {
        if (key.need == Need::optional && !section.has(key.name)) continue;
        const std::string name(key.name);
        if (key.holds == Holds::word) recipe.words[name] = word_in(section, key);
        if (key.holds == Holds::count) recipe.numbers[name] = section.count(key.name, 1, key.most);
        if (key.holds == Holds::quantity) recipe.numbers[name] = quantity_in(section, key);
    }
    return builder.build(recipe);
}

std::span<const BuilderKey> builder_keys(std::string_view builder) {
    const auto found =
        std::find_if(all_builders.begin(), all_builders.end(), [&](const auto& each) { return each.name == builder; });
    STRIDOR_EXPECT(found != all_builders.end());
    return found->keys;
}

}  // namespace stridor::io
