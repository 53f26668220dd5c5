#include "stridor/console/results/structure_text.hpp"

#include "stridor/base/text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <unordered_set>

namespace stridor::console {

namespace {

using Nodes = std::unordered_set<std::string_view>;

std::string set_text(const reduction::ElasticPart& part, const Nodes& with_rows) {
    std::string text;
    for (const reduction::NodeSet& set : part.sets) {
        const Nodes nodes(set.nodes.begin(), set.nodes.end());
        std::size_t free = 0;
        for (const std::string_view node : nodes)
            free += with_rows.count(node);
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", set.name, nodes.size());
        if (free != nodes.size()) text += fmt::format(" ({} with rows)", free);
    }
    return text;
}

std::string frequency_list(const std::vector<double>& frequencies) {
    std::string text;
    for (const double each : frequencies)
        text += fmt::format("{}{:.6g}", text.empty() ? "" : ", ", each);
    return text;
}

// what is rounding depends on the machine
std::string statics_text(const std::optional<double>& error) {
    constexpr double rounding = 1e-11;
    if (!error) return "the part is free: it has no flexibility";
    if (*error < rounding) return "flexibility of the boundary as of the full part";
    return fmt::format("flexibility of the boundary within {:.0e}", *error);
}

double percent(double error) {
    constexpr double shown = 0.5e-6;
    return std::abs(error) < shown ? 0.0 : 100.0 * error;
}

}  // namespace

std::string part_text(const reduction::ElasticPart& part, const reduction::PartSize& size) {
    Nodes nodes;
    for (const reduction::RowLabel& label : part.labels)
        if (label.component != 0) nodes.insert(label.node);
    std::string text = fmt::format("rows         {} of {} nodes, {} entries of stiffness{}\n", size.rows, nodes.size(),
                                   size.entries, part.damping.rows() != 0 ? ", with damping" : "");
    text += fmt::format("mass         {:.6g} kg along x, {:.6g} kg along y, {:.6g} kg along z\n", size.mass[0],
                        size.mass[1], size.mass[2]);
    if (size.extent)
        text += fmt::format("extent       {:.6g} x {:.6g} x {:.6g} m\n", (*size.extent)[0], (*size.extent)[1],
                            (*size.extent)[2]);
    if (!part.sets.empty()) text += "node sets    " + set_text(part, nodes) + "\n";
    return text;
}

std::string vibration_text(const reduction::PartVibration& vibration) {
    std::string text =
        fmt::format("rigid body   {} mode{}\n", vibration.rigid_body_modes, vibration.rigid_body_modes == 1 ? "" : "s");
    text += "frequencies  " + frequency_list(vibration.frequencies) + " Hz\n";
    text += std::isfinite(vibration.highest_frequency)
                ? fmt::format("highest      {:.4g} Hz\n", vibration.highest_frequency)
                : std::string("highest      none: some motion has no mass\n");
    return text;
}

std::string part_contacts_text(const reduction::PartContacts& contacts) {
    constexpr double shown = 1e-9;
    std::string text = fmt::format("contact      {} rows; ", contacts.rows);
    text += contacts.shared_inertia < shown
                ? std::string("no inertia is shared\n")
                : fmt::format("{} and {} share {:.2g} of their inertia\n", describe(contacts.first),
                              describe(contacts.second), contacts.shared_inertia);
    if (!contacts.painleve_friction) return text;
    if (!(*contacts.painleve_friction < 1.0 / shown)) return text + "friction     never presses a contact together\n";
    return text + fmt::format("friction     presses {} together from mu = {:.3g} on (Painleve)\n",
                              describe(contacts.weakest), *contacts.painleve_friction);
}

std::string reduction_text(const reduction::Reduction& reduction, const reduction::ReductionErrors& errors) {
    const std::vector<double>& modes = reduction.mode_frequencies;
    std::string text = fmt::format("boundary     {} rows\n", reduction.boundary_rows);
    const bool is_free = reduction.method == reduction::ReductionMethod::macneal;
    text += modes.empty() ? std::string("modes        none\n")
                          : fmt::format("modes        {} from {:.6g} to {:.6g} Hz with the boundary {}\n", modes.size(),
                                        modes.front(), modes.back(), is_free ? "free" : "held");
    text += reduction.inertia == reduction::BoundaryInertia::massless
                ? std::string("inertia      none: the boundary follows at once\n")
                : fmt::format("inertia      {}: neighbours are coupled by {:.2g} of their own\n",
                              name_of(reduction.inertia), errors.coupling < 1e-9 ? 0.0 : errors.coupling);
    if (reduction.solver == reduction::LinearSolver::mumps)
        text += "solver       MUMPS: its last digits are this machine's\n";
    text += "statics      " + statics_text(errors.flexibility) + "\n";
    text += "\ncontacts     frequency      reduced       error\n";
    for (const reduction::StateErrors& state : errors.states)
        for (const reduction::FrequencyPair& pair : state.frequencies)
            text += fmt::format("{:<9}{:10.2f} Hz{:10.2f} Hz{:+11.4f} %\n", state.name, pair.full, pair.reduced,
                                percent(relative_error(pair)));
    return text + "\n";
}

}  // namespace stridor::console
