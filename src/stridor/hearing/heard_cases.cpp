#include "stridor/hearing/heard_cases.hpp"

#include "stridor/base/error.hpp"
#include "stridor/hearing/heard_recordings.hpp"
#include "stridor/hearing/rendered_sound.hpp"
#include "stridor/parameters/paper_cases.hpp"

#include <array>
#include <memory>

namespace stridor::hearing {

namespace {

classification::RecordingVerdict verdict_on_whole(const parameters::Case& c, const HearingOptions& options) {
    sound::AuralisationSettings settings;
    settings.pickup = heard_motion(c, options.settings.motion, options.stop).pickup;
    settings.rate = options.settings.sound.rate;
    settings.stretches = {{0.0, c.run.duration}};
    const std::unique_ptr<RenderedSound> sound = render(c, settings, options.stop, [](double) {});
    return verdict_on(*sound, options.settings.thresholds);
}

}  // namespace

std::vector<HeardCase> hear_table_1(const HearingOptions& options) {
    constexpr std::array directions{parameters::Direction::going, parameters::Direction::coming};
    std::vector<HeardCase> cases;
    integration::Workspace workspace;
    for (std::size_t k = 0; k < parameters::paper_case_names.size(); ++k) {
        const parameters::Case c = parameters::paper_case(static_cast<parameters::PaperCase>(k));
        HeardCase& heard = cases.emplace_back();
        heard.name = parameters::paper_case_names[k];
        heard.phases = hear(c, directions, options.settings, options.stop, workspace);
        if (heard.phases.empty()) throw_stopped("Table 1");
        const classification::RecordingVerdict whole = verdict_on_whole(c, options);
        heard.whole = whole.category;
        heard.reason = whole.reasons.front();
    }
    return cases;
}

void throw_stopped(const std::string& where) {
    throw Error(ErrorKind::interrupted,
                {"stopped in " + where, "the sounds heard so far are kept", "Run the same command again to go on."});
}

}  // namespace stridor::hearing
