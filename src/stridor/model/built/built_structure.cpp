#include "stridor/model/built/built_structure.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/model/built/bowed_string.hpp"
#include "stridor/model/built/cantilever.hpp"
#include "stridor/model/built/chain_on_belt.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>
#include <vector>

namespace stridor::model {

namespace {

using parameters::OwnStructure;
using parameters::Recipe;

std::vector<double> row_numbers(const Eigen::MatrixXd& matrix) {
    return {matrix.data(), matrix.data() + matrix.size()};
}

OwnStructure own_of(const Structure& built, const Recipe& recipe, std::string origin, std::vector<std::string> rows,
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
    structure.recipe = recipe;
    return structure;
}

constexpr int outline_steps = 40;  // from one end to the other: the corner of a bowed string is seen as one

void take(const Recipe& recipe, std::string_view key, double& value) {
    if (const auto found = recipe.numbers.find(key); found != recipe.numbers.end()) value = found->second;
}

int count_of(const Recipe& recipe, std::string_view key) {
    const auto found = recipe.numbers.find(key);
    STRIDOR_EXPECT(found != recipe.numbers.end());
    return static_cast<int>(found->second);
}

std::vector<std::string> mode_names(int modes, std::string last) {
    std::vector<std::string> names;
    for (int k = 1; k <= modes; ++k)
        names.push_back("mode" + std::to_string(k));
    names.push_back(std::move(last));
    return names;
}

}  // namespace

OwnStructure built_chain(const Recipe& recipe) {
    ChainBlock block;
    double coupling = 0.0;
    take(recipe, "mass", block.mass);
    take(recipe, "stiffness", block.stiffness);
    take(recipe, "damping", block.damping);
    take(recipe, "coupling", coupling);
    const int count = count_of(recipe, "blocks");
    std::vector<std::string> rows, contacts;
    for (int k = 1; k <= count; ++k) {
        rows.push_back("x" + std::to_string(k));
        rows.push_back("y" + std::to_string(k));
        contacts.push_back("block" + std::to_string(k));
    }
    return own_of(chain_on_belt(std::vector(static_cast<std::size_t>(count), block), coupling), recipe,
                  fmt::format("chain of {} blocks on a belt", count), std::move(rows), contacts);
}

OwnStructure built_string(const Recipe& recipe) {
    BowedString string;
    take(recipe, "frequency", string.frequency);
    take(recipe, "impedance", string.impedance);
    take(recipe, "length", string.length);
    take(recipe, "damping_ratio", string.damping_ratio);
    take(recipe, "bridge_resistance", string.bridge_resistance);
    take(recipe, "position", string.bow_position);
    const int modes = count_of(recipe, "modes");
    OwnStructure structure = own_of(bowed_string(string, modes), recipe, fmt::format("string of {} modes", modes),
                                    mode_names(modes, "bow"), {"bow"});
    const auto start = recipe.words.find("start");
    if (start != recipe.words.end() && start->second == "helmholtz")
        structure.initial_velocity = row_numbers(helmholtz_motion(string, modes, 1.0));
    structure.contacts.front().position = {0.0, 0.0, string.bow_position * string.length};
    for (int step = 0; step <= outline_steps; ++step) {
        const double place = static_cast<double>(step) / outline_steps;
        structure.outline.push_back({{0.0, 0.0, place * string.length},
                                     row_numbers(string_shape(string, modes, place)),
                                     std::vector<double>(structure.row.size(), 0.0)});
    }
    return structure;
}

OwnStructure built_beam(const Recipe& recipe) {
    Cantilever beam;
    take(recipe, "length", beam.length);
    take(recipe, "mass_per_length", beam.mass_per_length);
    take(recipe, "bending_stiffness", beam.bending_stiffness);
    take(recipe, "axial_stiffness", beam.axial_stiffness);
    take(recipe, "damping_ratio", beam.damping_ratio);
    take(recipe, "incidence_angle", beam.incidence_angle);
    const int modes = count_of(recipe, "modes");
    OwnStructure structure = own_of(cantilever(beam, modes), recipe, fmt::format("beam of {} bending modes", modes),
                                    mode_names(modes, "axial"), {"tip"});
    structure.contacts.front().position = {0.0, 0.0, 0.0};
    const base::SineCosine angle = base::sine_cosine_of_degrees(beam.incidence_angle);
    for (int step = 0; step <= outline_steps; ++step) {
        const double place = static_cast<double>(step) / outline_steps;
        const double away = beam.length * (1.0 - place);  // from the tip, which rubs
        const BeamShape shape = cantilever_shape(beam, modes, place);
        structure.outline.push_back(
            {{away * angle.cosine, away * angle.sine, 0.0}, row_numbers(shape.along), row_numbers(shape.across)});
    }
    return structure;
}

}  // namespace stridor::model
