#include "stridor/analysis/evidence.hpp"

namespace stridor::analysis {

Evidence evidence(const record::Tally& tally) {
    Evidence figures;
    figures.phase = tally.phase;
    figures.window_time = tally.time[0] + tally.time[1] + tally.time[2];
    figures.judged_time = tally.judged_time[0] + tally.judged_time[1] + tally.judged_time[2];
    figures.rates = rates(tally.time);
    figures.judged_rates = rates(tally.judged_time);
    figures.alternation = alternation(tally);
    figures.levels = levels(tally);
    return figures;
}

}  // namespace stridor::analysis
