#include "stridor/advice/advice.hpp"
#include "stridor/base/text.hpp"
#include "stridor/explorer/answers/answers.hpp"
#include "stridor/explorer/answers/asked_advice.hpp"
#include "stridor/io/advice/advice_texts.hpp"

namespace stridor::explorer {

Response advice(const World& world, const Json& body, const std::stop_token& stop) {
    return json(io::advice_json(advice::advise(case_in(world, body), advice_options_in(world, body, stop))));
}

Response design(const World& world, const Json& body, const std::stop_token& stop) {
    const parameters::Case c = case_in(world, body);
    advice::AdviceOptions options;
    options.crew = crew::thread_crews(world.threads);
    options.stop = stop;
    const advice::Look look = flag_in(body, "around") ? advice::Look::around : advice::Look::here;
    Json document = Json::parse(io::standing_json(advice::standing_of(c, look, options)));
    document["ranges"] = ranges_object(c);
    return json(base::text_of(document));
}

}  // namespace stridor::explorer
