#include "stridor/record/trace.hpp"

#include "stridor/base/check.hpp"

#include <utility>

namespace stridor::record {

namespace {

void append(std::vector<std::vector<double>>& rows, std::span<const double> values) {
    STRIDOR_EXPECT(rows.size() == values.size());
    for (std::size_t dof = 0; dof < rows.size(); ++dof)
        rows[dof].push_back(values[dof]);
}

}  // namespace

Trace empty_trace(int dofs, int contacts) {
    const auto size = static_cast<std::size_t>(dofs);
    Trace trace;
    for (auto* rows : {&trace.displacement, &trace.velocity, &trace.acceleration})
        rows->resize(size);
    trace.contacts.resize(static_cast<std::size_t>(contacts));
    return trace;
}

void append(Trace& trace, const Sample& sample) {
    STRIDOR_EXPECT(trace.contacts.size() == sample.contacts.size());
    trace.time.push_back(sample.time);
    append(trace.displacement, sample.displacement);
    append(trace.velocity, sample.velocity);
    append(trace.acceleration, sample.acceleration);
    trace.surface_velocity.push_back(sample.surface_velocity);
    for (std::size_t k = 0; k < trace.contacts.size(); ++k) {
        ContactTrace& contact = trace.contacts[k];
        contact.normal_force.push_back(sample.contacts[k].normal_force);
        contact.friction_force.push_back(sample.contacts[k].friction_force);
        contact.gap.push_back(sample.contacts[k].gap);
        contact.state.push_back(sample.contacts[k].state);
    }
}

void add_points(Trace& trace, const std::vector<std::vector<double>>& weights) {
    if (trace.time.empty()) return;
    for (auto* rows : {&trace.displacement, &trace.velocity, &trace.acceleration}) {
        const std::size_t dofs = rows->size();
        for (const std::vector<double>& point : weights) {
            STRIDOR_EXPECT(point.size() == dofs);
            std::vector<double> motion(trace.time.size(), 0.0);
            for (std::size_t dof = 0; dof < dofs; ++dof)
                for (std::size_t sample = 0; sample < motion.size() && point[dof] != 0.0; ++sample)
                    motion[sample] += point[dof] * (*rows)[dof][sample];
            rows->push_back(std::move(motion));
        }
    }
}

void clear(Trace& trace) {
    trace.time.clear();
    for (auto* rows : {&trace.displacement, &trace.velocity, &trace.acceleration})
        for (std::vector<double>& samples : *rows)
            samples.clear();
    trace.surface_velocity.clear();
    for (ContactTrace& contact : trace.contacts) {
        for (auto* samples : {&contact.normal_force, &contact.friction_force, &contact.gap})
            samples->clear();
        contact.state.clear();
    }
}

std::string contact_ending(std::size_t index, std::size_t contacts) {
    return contacts > 1 ? "_" + std::to_string(index + 1) : "";
}

std::vector<NumberColumn> columns(const Trace& trace, std::span<const std::string> dofs) {
    STRIDOR_EXPECT(dofs.size() == trace.displacement.size());
    const auto once = [&](const TraceColumn& column) {
        return NumberColumn{std::string(column.name), column.unit, &(trace.*column.samples)};
    };
    std::vector<NumberColumn> all{once(time_column)};
    for (const DofColumn& column : dof_columns)
        for (std::size_t dof = 0; dof < dofs.size(); ++dof)
            all.push_back({std::string(column.name) + "_" + dofs[dof], column.unit, &(trace.*column.samples)[dof]});
    all.push_back(once(surface_column));
    for (std::size_t k = 0; k < trace.contacts.size(); ++k)
        for (const ContactColumn& column : contact_columns)
            all.push_back({std::string(column.name) + contact_ending(k, trace.contacts.size()), column.unit,
                           &(trace.contacts[k].*column.samples)});
    return all;
}

}  // namespace stridor::record
