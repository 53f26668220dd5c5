#include "stridor/signal/channel_name.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"

namespace stridor::signal {

namespace {

// so much of a name is told again; nobody knows a longer one by heart
constexpr std::size_t longest_told = 60;

std::string told(std::string_view name) {
    if (base::character_count(name) <= longest_told) return std::string(name);
    std::size_t end = longest_told;
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U)  // not within a character
        --end;
    return std::string(name.substr(0, end)) + "...";
}

}  // namespace

std::size_t channel_named(const ChannelLayout& layout, std::string_view name) {
    for (std::size_t k = 0; k < layout.channels.size(); ++k)
        if (!name.empty() && layout.channels[k].name == name) return k;
    for (std::size_t k = 0; k < layout.channels.size(); ++k)
        if (std::to_string(k + 1) == name) return k;
    throw Error(ErrorKind::input,
                {"there is no channel \"" + told(name) + "\"", "the recording has " + channel_list(layout),
                 "Give its name, or its number from 1."});
}

std::string channel_list(const ChannelLayout& layout) {
    std::string text;
    for (std::size_t k = 0; k < layout.channels.size(); ++k) {
        const Channel& channel = layout.channels[k];
        const std::string name = channel.name.empty() ? "" : " \"" + channel.name + "\"";
        text += (k > 0 ? ", " : "") + std::to_string(k + 1) + name + " [" + channel.unit + "]";
    }
    return text;
}

}  // namespace stridor::signal
