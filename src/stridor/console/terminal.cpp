#include "stridor/console/terminal.hpp"

#include "stridor/base/escapes.hpp"
#include "stridor/base/text.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace stridor::console {

namespace {

constexpr std::array<std::string_view, 4> styles{"\033[0m", "\033[1m", "\033[2m", "\033[31;1m"};

void put(std::string_view bytes) {
    const bool is_written =
        std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size() && std::fflush(stdout) == 0;
    if (is_written) return;
    const int reason = errno;
    if (reason == EPIPE) {
        // the reader (head, less) has seen enough: end as other programs do, quietly and not as if all were done
        std::signal(SIGPIPE, SIG_DFL);
        std::raise(SIGPIPE);
    }
    throw Error(ErrorKind::io,
                {"cannot write to standard output", std::strerror(reason), "Free some space or write elsewhere."});
}

}  // namespace

std::string shown(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const auto style =
            std::find_if(styles.begin(), styles.end(), [&](std::string_view each) { return text.starts_with(each); });
        const bool is_style = style != styles.end();
        const std::size_t next = is_style ? style->size() : std::max<std::size_t>(1, text.find('\033', 1));
        const std::string_view piece = text.substr(0, next);
        result += is_style ? std::string(piece) : base::visible(piece);
        text.remove_prefix(piece.size());
    }
    return result;
}

void print(std::string_view text) {
    put(shown(text));
}

void print_data(std::string_view bytes) {
    put(isatty(STDOUT_FILENO) == 1 ? base::visible(bytes) : std::string(bytes));
}

void say(std::string_view text) {
    const std::string line = shown(text) + "\n";
    std::fwrite(line.data(), 1, line.size(), stderr);
}

void say_note(const std::string& sentence) {
    say("stridor: note: " + sentence);
}

namespace {

// columns of the terminal that the line takes before the place, each character one; control characters are shown longer
std::size_t width_before(const base::Place& place) {
    std::string_view line = place.source_line;
    std::size_t characters = 0;
    std::size_t width = 0;
    for (const auto before = static_cast<std::size_t>(place.column - 1); characters < before; ++characters) {
        const std::size_t length = std::max<std::size_t>(1, base::utf8_length(line));
        const std::string_view character = line.substr(0, length);
        width += base::is_utf8(character) && !base::has_control(character) ? 1 : base::visible(character).size();
        if (line.empty()) ++width;
        line.remove_prefix(character.size());
    }
    return width;
}

// prose as a terminal of any width can show it; what goes to files and other programs keeps its lines
std::string for_terminal(const std::string& text, std::size_t first) {
    if (!has_terminal()) return text;
    return base::wrapped(text, {static_cast<std::size_t>(terminal_columns()), first, 4});
}

// the line as the user wrote it, with its number and a caret where both are known (an override has neither)
void say_source_line(const base::Place& place) {
    if (place.line <= 0) return say("    " + place.file + " " + place.source_line);
    say(fmt::format("{:5} | {}", place.line, place.source_line));
    if (place.column <= 0) return;
    say(fmt::format("{:5} | {}^", "", std::string(width_before(place), ' ')));
}

}  // namespace

namespace {

constexpr std::size_t most_complaints = 20;  // more fill the screen, and often come from the same slip

// "case.toml:3:1: error: what (why)"; the line of an override, which has no number, stands below
void say_complaint(const base::Complaint& complaint, std::string_view kind, Style style) {
    const auto& [problem, place] = complaint;
    const bool is_option = place && place->line <= 0 && !place->source_line.empty();
    const std::string where = place && !is_option ? base::describe(*place) : std::string("stridor");
    const std::string why = problem.why.empty() ? "" : " (" + problem.why + ")";
    const std::string head = where + ": " + std::string(kind) + ": ";
    say(where + ": " + styled(std::string(kind) + ":", style, STDERR_FILENO) + " " +
        for_terminal(problem.what + why, base::character_count(head)));
}

}  // namespace

void say_error(const Error& error) {
    const std::vector<base::Complaint>& complaints = error.complaints();
    for (std::size_t k = 0; k < std::min(complaints.size(), most_complaints); ++k) {
        const auto& [problem, place] = complaints[k];
        say_complaint(complaints[k], "error", Style::red);
        if (place && !place->source_line.empty()) say_source_line(*place);
        if (!problem.suggestion.empty()) say("help: " + for_terminal(problem.suggestion, 6));
    }
    if (complaints.size() > most_complaints)
        say(fmt::format("stridor: and {} more errors", complaints.size() - most_complaints));
    else if (complaints.size() > 1)
        say(fmt::format("stridor: {} errors", complaints.size()));
}

void say_warning(const base::Complaint& warning) {
    say_complaint(warning, "warning", Style::bold);
}

void open_standard_streams() {
    // a closed one is opened in the way in which it cannot be used, so that what is read or written there is an error
    for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(number, F_GETFD) < 0)
            static_cast<void>(open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY));
}

bool has_terminal() {
    return isatty(STDERR_FILENO) == 1;
}

int terminal_columns(int file_descriptor) {
    constexpr int least = 20;
    if (const char* told = std::getenv("COLUMNS"); told != nullptr) {
        const long columns = std::strtol(told, nullptr, 10);
        if (columns > 0) return static_cast<int>(std::clamp(columns, long{least}, 1000L));
    }
    winsize size{};
    const bool is_known = ioctl(file_descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return is_known ? std::max<int>(size.ws_col, least) : 80;
}

std::string styled(std::string_view text, Style style, int file_descriptor) {
    const char* no_color = std::getenv("NO_COLOR");
    const bool is_plain = (no_color != nullptr && *no_color != '\0') || isatty(file_descriptor) != 1;
    if (is_plain || style == Style::plain) return std::string(text);
    const std::string_view code = style == Style::bold ? "1" : style == Style::dim ? "2" : "31;1";
    return fmt::format("\033[{}m{}\033[0m", code, text);
}

void write_output(const std::string& path, std::string_view text) {
    if (path.empty() || path == "-")
        print_data(text);
    else
        storage::write_file(path, text);
}

}  // namespace stridor::console
