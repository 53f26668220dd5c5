#include "stridor/base/json.hpp"
#include "stridor/base/version.hpp"
#include "stridor/verification/published.hpp"

namespace stridor::verification {

namespace {

using base::Json;

Json number_object(const HeldNumber& held) {
    const PublishedNumber& number = *held.published;
    Json object{{"quantity", number.quantity}, {"unit", number.unit}, {"set", number.set}};
    const bool word = is_word(number);
    object["theirs"] = word ? Json(number_text(number, number.theirs)) : Json(number.theirs);
    object["ours"] = word ? Json(number_text(number, held.ours)) : Json(held.ours);
    object["difference"] = word ? Json() : Json(held.difference());
    object["tolerance"] = word ? Json() : Json(number.tolerance);
    object["precision"] = number.precision;
    object["agrees"] = held.agrees();
    return object;
}

}  // namespace

std::string published_json(const std::vector<HeldSystem>& systems) {
    Json document{{"schema", "stridor.published/1"},
                  {"version", base::version()},
                  {"commit", base::commit()},
                  {"systems", Json::array()}};
    for (const HeldSystem& held : systems) {
        const PublishedSystem& system = *held.published;
        Json object{{"source", system.source},
                    {"system", system.system},
                    {"origin", origin_names[static_cast<std::size_t>(system.origin)]},
                    {"case", system.file},
                    {"assumed", base::text_or_null(std::string(system.assumed))},
                    {"numbers", Json::array()}};
        for (const HeldNumber& number : held.numbers)
            object["numbers"].push_back(number_object(number));
        document["systems"].push_back(std::move(object));
    }
    document["not_reproduced"] = Json::array();
    for (const NotReproduced& each : not_reproduced())
        document["not_reproduced"].push_back({{"source", each.source}, {"what", each.what}, {"why", each.why}});
    return base::text_of(document);
}

}  // namespace stridor::verification
