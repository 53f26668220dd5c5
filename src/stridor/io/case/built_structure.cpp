#include "stridor/io/case/built_structure.hpp"

#include "stridor/base/field_table.hpp"
#include "stridor/model/bowed_string.hpp"
#include "stridor/model/cantilever.hpp"
#include "stridor/model/chain_on_belt.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace stridor::io {

namespace {

using parameters::OwnStructure;

std::vector<double> row_numbers(const Eigen::MatrixXd& matrix) {
    return {matrix.data(), matrix.data() + matrix.size()};
}

// what a builder of the model makes; contact forces at rest and laws are the case's
OwnStructure own_of(const model::Structure& built, std::string origin, std::vector<std::string> rows,
                    const std::vector<std::string>& contacts) {
    OwnStructure structure{.origin = std::move(origin),
                           .row = std::move(rows),
                           .mass = row_numbers(built.mass),
                           .stiffness = row_numbers(built.stiffness),
                           .damping = row_numbers(built.damping)};
    for (std::size_t k = 0; k < built.contacts.size(); ++k)
        structure.contacts.push_back({.name = contacts[k],
                                      .normal = row_numbers(built.contacts[k].normal),
                                      .tangent = row_numbers(built.contacts[k].tangent),
                                      .preload_share = 1.0});
    return structure;
}

constexpr int most_blocks = 100;
constexpr int most_modes = 1000;

std::vector<std::string> mode_names(int modes, std::string last) {
    std::vector<std::string> names;
    for (int k = 1; k <= modes; ++k)
        names.push_back("mode" + std::to_string(k));
    names.push_back(std::move(last));
    return names;
}

OwnStructure chain_of(const TomlSection& section) {
    const int count = section.count("blocks", 1, most_blocks);
    const model::ChainBlock block{
        .mass = section.quantity("mass", "kg", Bound::positive),
        .stiffness = section.quantity("stiffness", "N/m", Bound::positive),
        .damping = section.find_quantity("damping", "N*s/m", Bound::not_negative).value_or(0.0)};
    const double coupling = section.find_quantity("coupling", "N/m", Bound::not_negative).value_or(0.0);
    std::vector<std::string> rows, contacts;
    for (int k = 1; k <= count; ++k) {
        rows.push_back("x" + std::to_string(k));
        rows.push_back("y" + std::to_string(k));
        contacts.push_back("block" + std::to_string(k));
    }
    return own_of(model::chain_on_belt(std::vector(static_cast<std::size_t>(count), block), coupling),
                  fmt::format("chain of {} blocks on a belt", count), std::move(rows), contacts);
}

OwnStructure string_of(const TomlSection& section) {
    model::BowedString string;
    string.frequency = section.quantity("frequency", "Hz", Bound::positive);
    string.impedance = section.quantity("impedance", "kg/s", Bound::positive);
    string.length = section.find_quantity("length", "m", Bound::positive).value_or(string.length);
    string.damping_ratio = section.quantity("damping_ratio", "1", Bound::not_negative);
    string.bow_position = section.quantity("position", "1", Bound::positive);
    if (!(string.bow_position < 1.0))
        throw Error(ErrorKind::input, {"structure.position is not on the string", "it is a share of its length", ""},
                    section.need("position").value_place);
    const int modes = section.count("modes", 1, most_modes);
    OwnStructure structure = own_of(model::bowed_string(string, modes), fmt::format("string of {} modes", modes),
                                    mode_names(modes, "bow"), {"bow"});
    const std::string start = section.text_or("start", "rest");
    if (start == "helmholtz")
        structure.initial_velocity = row_numbers(model::helmholtz_motion(string, modes, 1.0));
    else if (start != "rest")
        section.refuse_kind(section.need("start"), "\"rest\" or \"helmholtz\"");
    return structure;
}

OwnStructure beam_of(const TomlSection& section) {
    const model::Cantilever cantilever{
        .length = section.quantity("length", "m", Bound::positive),
        .mass_per_length = section.quantity("mass_per_length", "kg/m", Bound::positive),
        .bending_stiffness = section.quantity("bending_stiffness", "N*m^2", Bound::positive),
        .axial_stiffness = section.quantity("axial_stiffness", "N", Bound::positive),
        .damping_ratio = section.quantity("damping_ratio", "1", Bound::not_negative),
        .incidence_angle = section.quantity("incidence_angle", "deg", Bound::any)};
    const int modes = section.count("modes", 1, most_modes);
    return own_of(model::cantilever(cantilever, modes), fmt::format("beam of {} bending modes", modes),
                  mode_names(modes, "axial"), {"tip"});
}

constexpr std::array<BuilderKey, 5> chain_keys{
    {{"blocks", "1", "number of blocks in a row"},
     {"mass", "kg", "of each block"},
     {"stiffness", "N/m", "of the spring that ties a block to the ground, along the belt and across it"},
     {"damping", "N*s/m", "beside that spring"},
     {"coupling", "N/m", "stiffness of the springs between neighbours"}}};
constexpr std::array<BuilderKey, 7> string_keys{
    {{"frequency", "Hz", "of the string's first mode"},
     {"impedance", "kg/s", "of waves on it"},
     {"length", "m", "of the string"},
     {"damping_ratio", "1", "share of critical damping of each mode"},
     {"position", "1", "of the bow, as a share of the length from the near end"},
     {"modes", "1", "number of modes"},
     {"start", "", "\"rest\", or \"helmholtz\": in the motion of a bowed string"}}};
constexpr std::array<BuilderKey, 7> beam_keys{
    {{"length", "m", "of the beam, clamped at one end, rubbing with its tip"},
     {"mass_per_length", "kg/m", "density times cross section"},
     {"bending_stiffness", "N*m^2", "E I"},
     {"axial_stiffness", "N", "E A"},
     {"damping_ratio", "1", "share of critical damping of each mode"},
     {"incidence_angle", "deg", "from the surface's direction of motion to the beam's axis"},
     {"modes", "1", "number of bending modes; an axial one comes besides"}}};
constexpr std::array<StructureBuilder, 3> all_builders{
    {{"chain", chain_keys, chain_of}, {"string", string_keys, string_of}, {"beam", beam_keys, beam_of}}};

}  // namespace

std::span<const StructureBuilder> structure_builders() {
    return all_builders;
}

OwnStructure built_structure(const StructureBuilder& builder, const TomlSection& section) {
    OwnStructure structure = builder.build(section);
    structure.builder_lines = "builder = \"" + std::string(builder.name) + "\"\n";
    for (const BuilderKey& key : builder.keys) {
        if (!section.has(key.name)) continue;
        const bool is_text = key.unit.empty();
        const std::string value = is_text
                                      ? section.text(key.name)
                                      : base::quantity_text(section.quantity(key.name, key.unit, Bound::any), key.unit);
        const bool is_plain = key.unit == "1";
        structure.builder_lines +=
            fmt::format("# {}\n{} = {}\n", key.sentence, key.name, is_plain ? value : "\"" + value + "\"");
    }
    return structure;
}

}  // namespace stridor::io
