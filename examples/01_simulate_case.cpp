// From a case to a verdict: the four columns of the paper's Table 1.
//
// A case is data. `simulate` runs it and leaves a tally per phase, `evidence` turns a tally into figures, `classify`
// turns figures into a verdict. Nothing in between prints, reads files or keeps state.

#include "stridor/analysis/evidence.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/paper_cases.hpp"

#include <iomanip>
#include <iostream>

using stridor::parameters::PaperCase;

int main() {
    for (const PaperCase which : {PaperCase::quiet, PaperCase::squeal, PaperCase::squeak, PaperCase::creak}) {
        const stridor::parameters::Case c = stridor::parameters::paper_case(which);
        const stridor::integration::Motion motion = stridor::integration::simulate(c);
        if (!stridor::integration::has_result(motion.outcome)) return 1;

        std::cout << c.title << '\n';
        for (const stridor::record::Tally& tally : motion.record.phases) {
            const auto figures = stridor::analysis::evidence(tally, 0);
            const auto verdict = stridor::classification::classify(figures, c.verdict);
            std::cout << "  " << std::setw(7) << std::left
                      << stridor::record::phase_names[static_cast<std::size_t>(tally.phase)] << std::setw(10)
                      << stridor::classification::name(verdict.category) << verdict.reasons.back() << '\n';
        }
    }
}
