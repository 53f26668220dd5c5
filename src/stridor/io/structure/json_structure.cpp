#include "stridor/io/structure/json_structure.hpp"

#include "stridor/io/json_parts.hpp"

namespace stridor::io {

using base::Json;

std::string part_json(const reduction::ElasticPart& part, const reduction::PartSize& size,
                      const reduction::PartVibration* vibration, const reduction::PartContacts* contacts) {
    Json document = json_parts::opening("part");
    document["rows"] = size.rows;
    document["entries"] = size.entries;
    document["damping"] = part.damping.rows() != 0;
    document["mass"] = size.mass;
    document["extent"] = size.extent ? Json{(*size.extent)[0], (*size.extent)[1], (*size.extent)[2]} : Json();
    Json sets = Json::object();
    for (const reduction::NodeSet& set : part.sets)
        sets[set.name] = set.nodes;
    document["sets"] = std::move(sets);
    document["notes"] = part.notes;
    if (vibration != nullptr) {
        document["rigid_body_modes"] = vibration->rigid_body_modes;
        document["frequencies"] = vibration->frequencies;
        document["highest_frequency"] = vibration->highest_frequency;  // infinite becomes null
    }
    if (contacts != nullptr) {
        Json contact{{"rows", contacts->rows}, {"shared_inertia", contacts->shared_inertia}};
        contact["between"] = {describe(contacts->first), describe(contacts->second)};
        if (contacts->painleve_friction) contact["painleve_friction"] = *contacts->painleve_friction;
        document["contact"] = std::move(contact);
    }
    return base::text_of(document);
}

std::string reduction_json(const reduction::Reduction& reduction, const reduction::ReductionErrors& errors) {
    Json document = json_parts::opening("reduction");
    document["boundary_rows"] = reduction.boundary_rows;
    document["mode_frequencies"] = reduction.mode_frequencies;
    document["method"] = name_of(reduction.method);
    document["solver"] = name_of(reduction.solver);
    document["inertia"] = name_of(reduction.inertia);
    document["coupling"] = errors.coupling;
    document["flexibility_error"] = errors.flexibility ? Json(*errors.flexibility) : Json();
    Json states = Json::object();
    for (const reduction::StateErrors& state : errors.states)
        states[state.name] = json_parts::array_of(state.frequencies, [](const reduction::FrequencyPair& pair) -> Json {
            return {{"full", pair.full}, {"reduced", pair.reduced}, {"error", relative_error(pair)}};
        });
    document["states"] = std::move(states);
    return base::text_of(document);
}

}  // namespace stridor::io
