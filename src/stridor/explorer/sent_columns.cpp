#include "stridor/explorer/sent_columns.hpp"

#include "stridor/io/simulation/simulation_tables.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/record/trace.hpp"

#include <string_view>
#include <tuple>
#include <utility>

namespace stridor::explorer {

namespace {

/// A degree of freedom as the page knows it.
struct SentDof {
    std::string name;  // x1 and y1 of the first joint, y2 of the plate; x_lip2 and y_lip2 of a further joint
    std::string whose;
};

std::vector<SentDof> dofs_of(const parameters::Case& c) {
    std::vector<std::string> names = io::dof_names(parameters::Case{});
    std::vector<SentDof> dofs;
    for (std::size_t dof = 0; dof < names.size(); ++dof)
        dofs.push_back({names[dof], std::string(io::dof_sentences[dof])});
    if (!parameters::has_several_joints(c)) return dofs;
    names = io::dof_names(c);
    const SentDof plate = dofs.back();
    dofs.pop_back();
    for (std::size_t dof = dofs.size(); dof + 1 < names.size(); ++dof)
        dofs.push_back({names[dof], dofs[dof % 2].whose});
    for (std::size_t dof = 0; dof < dofs.size(); ++dof)
        dofs[dof].whose.replace(0, std::string_view("of the joint").size(), "of " + parameters::joint_name(c, dof / 2));
    dofs.push_back(plate);
    return dofs;
}

void add_samples(const std::vector<double>& samples, std::vector<float>& sent) {
    for (const double value : samples)
        sent.push_back(static_cast<float>(value));
}

/// Rows of a motion with what each counts; those that count nothing are left out.
using Weights = std::vector<std::pair<std::size_t, double>>;

Weights weights_of(const std::vector<double>& rows) {
    Weights weights;
    for (std::size_t row = 0; row < rows.size(); ++row)
        if (rows[row] != 0.0) weights.emplace_back(row, rows[row]);
    return weights;
}

using Rows = std::vector<std::vector<double>> record::Trace::*;

SentColumn weighed(std::string name, std::string_view unit, std::string sentence, Rows rows, Weights weights) {
    return {std::move(name), std::string(unit), std::move(sentence),
            [rows, weights = std::move(weights)](const record::Trace& trace, std::vector<float>& sent) {
                for (std::size_t sample = 0; sample < trace.time.size(); ++sample) {
                    double sum = 0.0;
                    for (const auto& [row, weight] : weights)
                        sum += weight * (trace.*rows)[row][sample];
                    sent.push_back(static_cast<float>(sum));
                }
            }};
}

void add_joints(std::vector<SentColumn>& columns, const parameters::Case& c) {
    const std::vector<SentDof> dofs = dofs_of(c);
    for (const record::DofColumn& column : std::span(record::dof_columns).first(2))
        for (std::size_t dof = 0; dof < dofs.size(); ++dof) {
            const bool is_place = column.samples == &record::Trace::displacement;
            columns.push_back({dofs[dof].name + (is_place ? "" : "_" + std::string(column.name)),
                               std::string(column.unit),
                               std::string(is_place ? "displacement" : column.name) + " " + dofs[dof].whose,
                               [member = column.samples, dof](const record::Trace& trace, std::vector<float>& sent) {
                                   add_samples((trace.*member)[dof], sent);
                               }});
        }
}

void add_structure(std::vector<SentColumn>& columns, const parameters::OwnStructure& own) {
    for (const parameters::OwnContact& contact : own.contacts) {
        const std::string ending = own.contacts.size() > 1 ? "_" + contact.name : "1";
        for (const auto& [axis, rows, way] : {std::tuple("x", &contact.tangent, " along the sliding direction"),
                                              std::tuple("y", &contact.normal, " along the normal")}) {
            const Weights weights = weights_of(*rows);
            columns.push_back(weighed(axis + ending, "m", "displacement of " + contact.name + way,
                                      &record::Trace::displacement, weights));
            columns.push_back(weighed(axis + ending + "_velocity", "m/s", "velocity of " + contact.name + way,
                                      &record::Trace::velocity, weights));
        }
    }
    for (const parameters::OwnOutput& output : own.outputs)
        columns.push_back(weighed("velocity_" + output.name, "m/s", "velocity of " + output.name,
                                  &record::Trace::velocity, weights_of(output.weights)));
    for (std::size_t k = 0; k < own.outline.size(); ++k)
        for (const auto& [axis, rows] :
             {std::pair("_x", &own.outline[k].along), std::pair("_y", &own.outline[k].across)})
            if (Weights weights = weights_of(*rows); !weights.empty())
                columns.push_back(weighed("outline_" + std::to_string(k + 1) + axis, "m",
                                          "displacement of a point of the outline", &record::Trace::displacement,
                                          std::move(weights)));
}

}  // namespace

std::vector<SentColumn> sent_columns(const parameters::Case& c) {
    std::vector<SentColumn> columns;
    if (c.own_structure)
        add_structure(columns, *c.own_structure);
    else
        add_joints(columns, c);
    columns.push_back({std::string(record::surface_column.name), std::string(record::surface_column.unit),
                       std::string(record::surface_column.sentence),
                       [](const record::Trace& trace, std::vector<float>& sent) {
                           add_samples(trace.*record::surface_column.samples, sent);
                       }});
    const std::size_t contacts = parameters::contact_count(c);
    for (std::size_t contact = 0; contact < contacts; ++contact)
        for (const record::ContactColumn& column : record::contact_columns)
            columns.push_back(
                {std::string(column.name) + record::contact_ending(contact, contacts), std::string(column.unit),
                 std::string(column.sentence),
                 [member = column.samples, contact](const record::Trace& trace, std::vector<float>& sent) {
                     add_samples(trace.contacts[contact].*member, sent);
                 }});
    return columns;
}

}  // namespace stridor::explorer
