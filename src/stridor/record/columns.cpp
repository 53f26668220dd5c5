#include "stridor/record/columns.hpp"

#include "stridor/base/check.hpp"

namespace stridor::record {

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
