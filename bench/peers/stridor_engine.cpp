#include "peers/stridor_engine.hpp"

#include "stridor/integration/simulate.hpp"

#include <stdexcept>
#include <string>
#include <utility>

namespace stridor::peers {

std::function<record::ContactHistory(const parameters::Case&)> stridor_engine(void (*set)(parameters::Run&)) {
    return [set](const parameters::Case& c) {
        parameters::Case mine = c;
        set(mine.run);
        integration::Motion motion = integration::simulate(mine, {record::KeepHistory::yes, {}});
        if (!integration::has_result(motion.outcome))
            throw std::runtime_error(
                std::string(integration::reason_names[static_cast<std::size_t>(motion.outcome.reason)]));
        // what is settled stays so
        motion.record.histories.front().back().to = c.run.duration;
        return std::move(motion.record.histories.front());
    };
}

}  // namespace stridor::peers
