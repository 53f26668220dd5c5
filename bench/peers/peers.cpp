#include "peers/odeint.hpp"
#include "peers/peer.hpp"
#include "peers/stridor_engine.hpp"

#ifdef STRIDOR_WITH_CVODE
#    include "peers/cvode.hpp"
#endif

#include "stridor/base/version.hpp"

namespace stridor::peers {

using parameters::Case;
using parameters::EarlyEnding;
using parameters::Engine;
using parameters::Run;

std::vector<Peer> peers() {
    return {
        {"Stridor exact", stridor_engine([](Run& run) { run.early_ending = EarlyEnding::never; })},
        {"Stridor exact, early endings", stridor_engine([](Run&) {})},
        {"Stridor beta_2, h = 1e-6 s", stridor_engine([](Run& run) { run.engine = Engine::beta_2, run.step = 1e-6; })},
        {"Stridor beta_2, h = 1e-7 s", stridor_engine([](Run& run) { run.engine = Engine::beta_2, run.step = 1e-7; })},
        {"odeint dopri5, rtol 1e-8", [](const Case& c) { return by_odeint(c, 1e-8); }},
        {"odeint dopri5, rtol 1e-11", [](const Case& c) { return by_odeint(c, 1e-11); }},
#ifdef STRIDOR_WITH_CVODE
        {"CVODE Adams, rtol 1e-8", [](const Case& c) { return by_cvode(c, 1e-8); }},
        {"CVODE Adams, rtol 1e-11", [](const Case& c) { return by_cvode(c, 1e-11); }},
#endif
    };
}

std::vector<Peer> stiff_peers() {
    return {
#ifdef STRIDOR_WITH_CVODE
        {"CVODE BDF, rtol 1e-8", [](const Case& c) { return by_cvode(c, 1e-8, Formulas::bdf); }},
        {"CVODE BDF, rtol 1e-11", [](const Case& c) { return by_cvode(c, 1e-11, Formulas::bdf); }},
#endif
    };
}

std::vector<std::string> peer_versions() {
    return {
        "Stridor " + std::string(base::version()),
        odeint_version(),
#ifdef STRIDOR_WITH_CVODE
        cvode_version(),
#else
        "SUNDIALS CVODE: not found when configured, skipped (Debian: libsundials-dev)",
#endif
    };
}

}  // namespace stridor::peers
