#pragma once

#include "stridor/base/error.hpp"
#include "stridor/explorer/body.hpp"
#include "stridor/explorer/http.hpp"
#include "stridor/explorer/world.hpp"
#include "stridor/integration/motion.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/signal/source.hpp"

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

/// One function per kind of request; api.cpp has the table of their paths. They throw `Error` for
/// what cannot be answered.
namespace stridor::explorer {

/// A document; with a line end after it.
Response json(std::string document);

/// "stridor.explorer.error/1", on one line: the first complaint, the next few in "others", how many more in "untold".
std::string error_document(const Error& error);

// answers_case.cpp

/// A run that has a result; what went wrong with any other is an `Error`.
integration::Motion run_case(const parameters::Case& c, const record::Request& request, const std::stop_token& stop);

/// {"contact.preload": {"from": 2, "to": 200, "scale": "log"}}: between which values each quantity of a case is varied
/// (`parameters::usual_range`), of a velocity its magnitude.
Json ranges_object(const parameters::Case& c);

/// "stridor.explorer.start/1": presets, fields and figures, what the page begins with.
Response start(const World& world);

/// The verdict and figures of a case, as `simulate --json` has them.
Response simulate(const World& world, const Json& body, const std::stop_token& stop);

/// Stability of sliding at the case, or over a quantity at most 2000 values, as JSON.
Response stability(const World& world, const Json& body, const std::stop_token& stop);

/// The case, or the chart where the body has one, as a TOML file.
Response toml(const World& world, const Json& body, const std::stop_token& stop);

/// Advice on a case, as `advise --json` has it.
Response advice(const World& world, const Json& body, const std::stop_token& stop);

/// "stridor.design/1": the headline of a case, judged both ways and from every start, and, where the body asks for
/// `around`, what lies close to it; "ranges" has those of its quantities.
Response design(const World& world, const Json& body, const std::stop_token& stop);

/// The report on a design as an HTML file.
Response report(const World& world, const Json& body, const std::stop_token& stop);

// answers_motion.cpp
/// Trace and contact histories of a case in bytes: the length of a JSON header, the header, then the columns as it
/// says.
Response motion(const World& world, const Json& body, const std::stop_token& stop);

/// "stridor.explorer.analysis/1" of a source's loudest channel; reads it to its end.
Response analysis_of(signal::Source& source);

/// The sound of a case as a WAV file.
Response sound(const World& world, const Json& body, const std::stop_token& stop);

/// "stridor.explorer.modal/1": the strongest lines in the spectrum of a case's velocity, and the free modes that have
/// most of each.
Response modal_lines(const World& world, const Json& body, const std::stop_token& stop);

/// "stridor.explorer.analysis/1" of that sound.
Response analysis(const World& world, const Json& body, const std::stop_token& stop);

// answers_share.cpp

/// "stridor.explorer.value/1": a text with a unit as the number it is for a quantity, as `--set` would take it.
Response value(const World& world, const Json& body, const std::stop_token& stop);

/// "stridor.explorer.share/1": a case as one of the paper's with all that differs in it, so that it is the same case on
/// a machine that has none of its files.
Response share(const World& world, const Json& body, const std::stop_token& stop);

// answers_chart.cpp
/// A chart as it is refined: a line of JSON after each round, streamed.
Response chart(const World& world, const Json& body, const std::stop_token& stop);

// answers_library.cpp

/// What stands at /api/library and below; nothing for a path that means nothing.
std::optional<Response> library(const World& world, std::string_view path);

}  // namespace stridor::explorer
