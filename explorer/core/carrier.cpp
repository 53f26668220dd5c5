// The answers of the explorer as functions of a WebAssembly module: a path and a text in, a response out
// (explorer/answers/seam.hpp). The page puts a text into `room`, calls, and is called back with what was answered.

#include "page_crew.hpp"
#include "page_files.hpp"
#include "stridor/base/error.hpp"
#include "stridor/explorer/answers/answers.hpp"
#include "stridor/explorer/answers/seam.hpp"
#include "stridor/explorer/world.hpp"
#include "stridor/recordings/open_signal.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>

#define STRIDOR_FROM_PAGE(name) __attribute__((import_module("page"), import_name(name)))
#define STRIDOR_FOR_PAGE(name) __attribute__((export_name(name)))

extern "C" {

/// Tells the page how an answer begins; its body comes in parts.
STRIDOR_FROM_PAGE("head") void page_head(int status, const char* type, std::size_t length);

/// Hands the page a part of the body.
STRIDOR_FROM_PAGE("part") void page_part(const char* bytes, std::size_t length);
}

namespace stridor::explorer {

namespace {

/// What one module holds: the text that the page put in, and the cases it may ask for.
struct Carrier {
    std::string room;
    World world{paper_presets(), {}, 1};
};

Carrier& carrier() {
    static Carrier only;
    return only;
}

void carry(const Response& response) {
    page_head(response.status, response.content_type.data(), response.content_type.size());
    const auto part = [](std::string_view bytes) { page_part(bytes.data(), bytes.size()); };
    if (response.stream)
        response.stream(part, {});
    else
        part(response.body);
}

// a file that a case leans on was not chosen with it
[[noreturn]] void tell_missing(const Error& error) {
    throw Error(ErrorKind::input,
                {error.problem().what, "it is not here: a page opens only what was chosen together",
                 "Choose it together with the case, or use stridor explore."},
                error.place());
}

// with the files that were kept for it
Response opened(const std::string& text) {
    World world{paper_presets(), {}, 1};
    try {
        world.presets.insert(world.presets.begin(), preset_of({text, "case.toml", {}}, {}));
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::io) throw;
        tell_missing(error);
    }
    Response response = start(world);  // reads every case once: a world that cannot be shown is not kept
    carrier().world = std::move(world);
    return response;
}

// a recording that was kept
Response heard(const std::string& name) {
    return analysis_of(*recordings::open_signal(name));
}

Response routed(std::string_view path, const std::string& body) {
    if (path == "/api/start") return start(carrier().world);
    if (path == "/api/open") return opened(body);
    if (path == "/api/recording") return heard(body);
    if (std::optional<Response> found = answer_at(carrier().world, path, body, {})) return std::move(*found);
    throw Error(ErrorKind::input, {std::string(path.substr(0, 100)) + " is not in the page in one file",
                                   "it needs the program", "Start stridor explore."});
}

constexpr int done = 200, lacking = 202;
constexpr std::string_view bytes = "application/octet-stream";

// what lies in the room behind the question
std::string cut_room(std::size_t question_length) {
    std::string& room = carrier().room;
    std::string rest = room.substr(std::min(question_length, room.size()));
    room.resize(std::min(question_length, room.size()));
    return rest;
}

void answer_in_room(std::size_t path_length) {
    const std::string question = std::exchange(carrier().room, {});
    carry(answered([&] { return routed(question.substr(0, path_length), question.substr(path_length)); }));
}

}  // namespace

}  // namespace stridor::explorer

extern "C" {

/// Returns where the page puts the bytes of its next question.
STRIDOR_FOR_PAGE("room") char* room(std::size_t length) {
    std::string& room = stridor::explorer::carrier().room;
    room.resize(length);
    return room.data();
}

/// Keeps the file in the room (its name, its bytes) beside the case that is opened next; without a name: forgets all.
STRIDOR_FOR_PAGE("keep") void keep(std::size_t name_length) {
    using namespace stridor;
    std::string bytes = explorer::cut_room(name_length);
    const std::string name = std::exchange(explorer::carrier().room, {});
    if (name.empty())
        storage::forget_files();
    else
        storage::keep_file(name, std::move(bytes));
}

/// Answers the question in the room: its path, then its body.
STRIDOR_FOR_PAGE("answer") void answer(std::size_t path_length) {
    stridor::crew::compute_alone();
    stridor::explorer::answer_in_room(path_length);
}

/// Answers the question in the room (path, body, results of helpers) by these results alone. Where it lacks some, the
/// last head has status 202, and its body are the tasks, a part for each helper.
STRIDOR_FOR_PAGE("share") void share(std::size_t path_length, std::size_t body_length, std::size_t helpers) {
    using namespace stridor;
    try {
        crew::take_results(explorer::cut_room(path_length + body_length));
        explorer::answer_in_room(path_length);
    } catch (const crew::Lacking&) {
        page_head(explorer::lacking, explorer::bytes.data(), explorer::bytes.size());
        for (const std::string& tasks : crew::lacking_tasks(helpers))
            page_part(tasks.data(), tasks.size());
    }
}

/// Computes tasks (in the room: path, body, the tasks) of somebody's question; the body of the answer are the results.
STRIDOR_FOR_PAGE("help") void help(std::size_t path_length, std::size_t body_length) {
    using namespace stridor;
    try {
        crew::help_with(explorer::cut_room(path_length + body_length));
        explorer::answer_in_room(path_length);
    } catch (const crew::Lacking&) {
        const std::string results = crew::helpers_results();
        page_head(explorer::done, explorer::bytes.data(), explorer::bytes.size());
        page_part(results.data(), results.size());
    }
}
}
