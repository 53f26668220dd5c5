#include "stridor/io/simulation/motion_netcdf.hpp"

#include "stridor/base/hash.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/netcdf_dataset.hpp"
#include "stridor/io/simulation/dof_names.hpp"
#include "stridor/parameters/field.hpp"
#include "stridor/record/columns.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace stridor::io {

namespace {

// numbers of each contact; without a dimension of contacts, if there is only one
void put_contacts(NetcdfDataset& file, const record::Trace& trace, const std::vector<int>& along) {
    for (const record::ContactColumn& column : record::contact_columns) {
        std::vector<double> values;
        for (const record::ContactTrace& contact : trace.contacts)
            values.insert(values.end(), (contact.*column.samples).begin(), (contact.*column.samples).end());
        file.doubles(std::string(column.name), along, values, {column.unit, column.sentence});
    }
    std::vector<signed char> states;
    for (const record::ContactTrace& contact : trace.contacts)
        for (const model::ContactState state : contact.state)
            states.push_back(static_cast<signed char>(state));
    file.flags(std::string(record::state_column), along, states, {model::contact_state_names}, {"", "contact state"});
}

void put_trace(NetcdfDataset& file, const parameters::Case& c, const record::Trace& trace) {
    const std::vector<std::string> names = dof_names(c, trace.displacement.size());
    const int time = file.dimension("time", trace.time.size());
    const int dof = file.dimension("dof", names.size());
    const auto put = [&](const record::TraceColumn& column, MissingNumbers missing) {
        file.doubles(std::string(column.name), std::array{time}, trace.*column.samples,
                     {column.unit, column.sentence, missing});
    };
    put(record::time_column, MissingNumbers::no);
    file.words("dof", std::array{dof}, names, {"", "degree of freedom"});
    for (const record::DofColumn& column : record::dof_columns) {
        std::vector<double> values;
        for (const std::vector<double>& row : trace.*column.samples)
            values.insert(values.end(), row.begin(), row.end());
        file.doubles(std::string(column.name), std::array{dof, time}, values, {column.unit, column.sentence});
    }
    put(record::surface_column, MissingNumbers::as_nan);
    std::vector<int> along{time};
    if (trace.contacts.size() > 1) along.insert(along.begin(), file.dimension("contact", trace.contacts.size()));
    put_contacts(file, trace, along);
}

// the stays of all contacts, one contact after the other
void put_histories(NetcdfDataset& file, const std::vector<record::ContactHistory>& histories) {
    std::vector<record::ContactInterval> stays;
    std::vector<double> contacts;
    for (std::size_t k = 0; k < histories.size(); ++k) {
        stays.insert(stays.end(), histories[k].begin(), histories[k].end());
        contacts.insert(contacts.end(), histories[k].size(), static_cast<double>(k + 1));
    }
    const std::array along{file.dimension("interval", stays.size())};
    if (histories.size() > 1)
        file.doubles("interval_contact", along, contacts, {"1", "number of the contact, from 1", MissingNumbers::no});
    std::vector<signed char> states;
    for (const record::ContactInterval& interval : stays)
        states.push_back(static_cast<signed char>(interval.state));
    file.flags("interval_state", along, states, {model::contact_state_names}, {"", "contact state"});
    const auto put = [&](const std::string& name, double record::ContactInterval::*member,
                         const Description& description) {
        std::vector<double> values;
        for (const record::ContactInterval& interval : stays)
            values.push_back(interval.*member);
        file.doubles(name, along, values, description);
    };
    put("interval_from", &record::ContactInterval::from, {"s", "time at which the state began", MissingNumbers::no});
    put("interval_to", &record::ContactInterval::to, {"s", "time at which it ended", MissingNumbers::no});
    put("interval_slip_velocity", &record::ContactInterval::slip_velocity, {"m/s", "slip velocity at its beginning"});
    put("interval_gap_velocity", &record::ContactInterval::gap_velocity,
        {"m/s", "velocity of the gap at its beginning; negative: the surfaces met"});
}

}  // namespace

void write_trace_netcdf(const std::string& path, const parameters::Case& c, const record::Record& record) {
    const std::string canonical = parameters::canonical_text(c);
    NetcdfDataset file(path);
    put_origin(file, "trace", c.title.empty() ? "simulated motion" : c.title);
    file.attribute("study", canonical);
    file.attribute("study_hash", base::hash_text(canonical));
    file.attribute("case", case_toml(c, {.comments = Comments::none, .heading = ""}));
    if (!record.trace.time.empty()) put_trace(file, c, record.trace);
    const bool has_history = std::any_of(record.histories.begin(), record.histories.end(),
                                         [](const record::ContactHistory& history) { return !history.empty(); });
    if (has_history) put_histories(file, record.histories);
    file.finish([&](std::string_view bytes) { storage::write_file(path, bytes); });
}

}  // namespace stridor::io
