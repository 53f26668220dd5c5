#pragma once

#include "stridor/base/error.hpp"
#include "stridor/explorer/body.hpp"
#include "stridor/explorer/http.hpp"
#include "stridor/explorer/world.hpp"
#include "stridor/integration/run/motion.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/signal/source.hpp"

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

/// One function per kind of request; api.cpp has the table of their paths. They throw `Error` for requests that cannot
/// be answered.
namespace stridor::explorer {

/// Returns a document, with a line end behind it.
Response json(std::string document);

/// Returns "stridor.explorer.error/1", on one line: the first complaint, the next few in "others", how many more in
/// "untold".
std::string error_document(const Error& error);

// answers_case.cpp

/// Returns a run that has a result; throws `Error` for any other.
integration::Motion run_case(const parameters::Case& c, const record::Request& request, const std::stop_token& stop);

/// Returns the usual range of each quantity of a case (`parameters::usual_range`), for a velocity that of its
/// magnitude: {"contact.preload": {"from": 2, "to": 200, "scale": "log"}}.
Json ranges_object(const parameters::Case& c);

/// Returns "stridor.explorer.start/1": presets, fields and figures, with which the page begins.
Response start(const World& world);

/// Returns the verdict and figures of a case, as `simulate --json` has them.
Response simulate(const World& world, const Json& body, const std::stop_token& stop);

/// Returns the stability of sliding at the case, or over a quantity at most 2000 values, as JSON.
Response stability(const World& world, const Json& body, const std::stop_token& stop);

/// Returns "stridor.explorer.friction/1": the one law of friction of a case over the speed of slip, the points of it
/// that may be moved and what each sets, and between which speeds the case slips if the body asks for `visited`. The
/// picture reaches at least to these speeds, or to `reach` [m/s].
Response friction(const World& world, const Json& body, const std::stop_token& stop);

/// Returns the case, or the chart if the body has one, as a TOML file.
Response toml(const World& world, const Json& body, const std::stop_token& stop);

// answers_advice.cpp

/// Returns advice on a case, as `advise --json` has it.
Response advice(const World& world, const Json& body, const std::stop_token& stop);

/// Returns "stridor.design/1": the headline of a case, judged both ways and from every start and, if the body asks for
/// `around`, the changes of verdict close to it; "ranges" has those of its quantities.
Response design(const World& world, const Json& body, const std::stop_token& stop);

// answers_report.cpp

/// Returns the report on a design as an HTML file.
Response report(const World& world, const Json& body, const std::stop_token& stop);

// answers_motion.cpp
/// Returns trace and contact histories of a case in bytes: the length of a JSON header, the header, then the columns
/// that it describes.
Response motion(const World& world, const Json& body, const std::stop_token& stop);

/// Returns "stridor.explorer.analysis/1" of a source's loudest channel; reads it to its end.
Response analysis_of(signal::Source& source);

/// Returns the sound of a case as a WAV file.
Response sound(const World& world, const Json& body, const std::stop_token& stop);

/// Returns "stridor.explorer.modal/1": the strongest lines in the spectrum of a case's velocity, and the free modes
/// with the largest shares of each.
Response modal_lines(const World& world, const Json& body, const std::stop_token& stop);

/// Returns "stridor.explorer.analysis/1" of that sound.
Response analysis(const World& world, const Json& body, const std::stop_token& stop);

// answers_share.cpp

/// Returns "stridor.explorer.value/1": a text with a unit as the number of a quantity, as `--set` would read it.
Response value(const World& world, const Json& body, const std::stop_token& stop);

/// Returns "stridor.explorer.share/1": a case as one of the paper's with all differences, so that it is the same case
/// on a machine without its files.
Response share(const World& world, const Json& body, const std::stop_token& stop);

// answers_chart.cpp
/// Returns a chart as it is refined: a line of JSON after each round, streamed.
Response chart(const World& world, const Json& body, const std::stop_token& stop);

// answers_library.cpp

/// Returns the answer at /api/library and below, or `std::nullopt` for an unknown path.
std::optional<Response> library(const World& world, std::string_view path);

/// Returns "stridor.explorer.analysis/1" of a WAV file, which is kept nowhere.
Response recording(std::string wav);

}  // namespace stridor::explorer
