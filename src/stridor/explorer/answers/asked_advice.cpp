#include "stridor/explorer/answers/asked_advice.hpp"

#include "stridor/base/error.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace stridor::explorer {

namespace {

constexpr std::size_t most_asked = 40;  // ranges or tolerances

const Json& list_in(const Json& body, const std::string& name) {
    static const Json none = Json::array();
    const auto found = body.find(name);
    if (found == body.end() || found->is_null()) return none;
    bool are_objects = found->is_array() && found->size() <= most_asked;
    for (const Json& item : *found)
        are_objects = are_objects && item.is_object();
    if (!are_objects) throw Error(ErrorKind::input, {"\"" + name + "\" must be a list of at most 40 objects", "", ""});
    return *found;
}

std::optional<double> optional_in(const Json& object, const std::string& name) {
    return object.contains(name) ? std::optional(number_in(object, name)) : std::nullopt;
}

}  // namespace

advice::AdviceOptions advice_options_in(const World& world, const Json& body, const std::stop_token& stop) {
    constexpr int most_samples = 16384;
    advice::AdviceOptions options;
    options.crew = crew::thread_crews(world.threads);
    options.stop = stop;
    for (const Json& range : list_in(body, "over"))
        options.over.push_back({text_in(range, "key"), optional_in(range, "from"), optional_in(range, "to")});
    for (const Json& tolerance : list_in(body, "tolerance"))
        options.tolerances.push_back({text_in(tolerance, "key"), optional_in(tolerance, "relative"),
                                      optional_in(tolerance, "absolute"), advice::Spread::uniform});
    const int samples = whole_in(body, "samples", 2048);
    if (samples < 1 || samples > most_samples)
        throw Error(ErrorKind::input, {"\"samples\" must be from 1 to " + std::to_string(most_samples), "", ""});
    options.chance.samples = static_cast<std::size_t>(samples);
    return options;
}

}  // namespace stridor::explorer
