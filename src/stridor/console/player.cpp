#include "stridor/console/player.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/process.hpp"
#include "stridor/base/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace stridor::console {

namespace {

struct Player {
    std::string_view program;
    std::array<std::string_view, 5> arguments;  // before the file's name
};

// those that know the sound server of the desktop come first
constexpr std::array players{
    Player{"pw-play", {}},
    Player{"paplay", {}},
    Player{"aplay", {"-q"}},
    Player{"play", {"-q"}},
    Player{"ffplay", {"-nodisp", "-autoexit", "-loglevel", "error"}},
    Player{"afplay", {}},
};

}  // namespace

std::string known_players() {
    std::string names;
    for (const Player& player : players)
        names += (names.empty() ? "" : ", ") + std::string(player.program);
    return names;
}

std::string find_player() {
    for (const Player& player : players)
        if (base::is_on_path(std::string(player.program))) return std::string(player.program);
    return {};
}

void play(const std::string& player, const std::string& path) {
    const auto* known =
        std::find_if(players.begin(), players.end(), [&](const Player& one) { return one.program == player; });
    std::vector<std::string> command{player};
    if (known != players.end())
        for (const std::string_view argument : known->arguments)
            if (!argument.empty()) command.emplace_back(argument);
    command.push_back(path);
    const base::ProcessResult result = base::run_process(command);
    if (result.exit_status != 0)
        throw Error(ErrorKind::io,
                    {fmt::format("{} could not play the sound", player), std::string(base::trimmed(result.messages)),
                     "Write it with -o FILE.wav and play it elsewhere."});
}

}  // namespace stridor::console
