#include "stridor/signal/channel_name.hpp"

#include "stridor/base/error.hpp"

namespace stridor::signal {

std::size_t channel_named(const ChannelLayout& layout, std::string_view name) {
    for (std::size_t k = 0; k < layout.channels.size(); ++k)
        if (!name.empty() && layout.channels[k].name == name) return k;
    for (std::size_t k = 0; k < layout.channels.size(); ++k)
        if (std::to_string(k + 1) == name) return k;
    throw Error(ErrorKind::input,
                {"there is no channel \"" + std::string(name) + "\"", "the recording has " + channel_list(layout),
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
