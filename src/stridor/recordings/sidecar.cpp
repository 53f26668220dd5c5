#include "stridor/recordings/sidecar.hpp"

#include "stridor/base/field_table.hpp"
#include "stridor/base/json.hpp"
#include "stridor/base/text.hpp"
#include "stridor/base/version.hpp"
#include "stridor/recordings/raw_signal.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace stridor::recordings {

namespace {

using base::Json;

constexpr const char* schema = "stridor.sidecar/1";

void check_keys(const Json& object, std::initializer_list<std::string_view> known, const std::string& name) {
    for (const auto& [key, value] : object.items()) {
        bool is_known = false;
        for (const std::string_view candidate : known)
            is_known = is_known || key == candidate;
        if (is_known) continue;
        const std::vector<std::string_view> candidates(known);
        throw refusal(name, "unknown key \"" + key + "\"", "",
                      base::did_you_mean(key, candidates, "What has no key of its own goes into \"metadata\"."));
    }
}

std::string text_in(const Json& object, const char* key, const std::string& name) {
    const Json& value = object.at(key);
    if (!value.is_string()) throw refusal(name, "\"" + std::string(key) + "\" is no text");
    return value.get<std::string>();
}

double positive_in(const Json& object, const char* key, const std::string& name) {
    const Json& value = object.at(key);
    const double number = value.is_number() ? value.get<double>() : 0.0;
    if (!(number > 0.0) || !std::isfinite(number))
        throw refusal(name, "\"" + std::string(key) + "\" is no positive number");
    return number;
}

SidecarChannel channel_of(const Json& object, const std::string& name) {
    if (!object.is_object()) throw refusal(name, "a channel is no object");
    check_keys(object, {"name", "unit", "full_scale"}, name);
    SidecarChannel channel;
    if (object.contains("name")) channel.name = text_in(object, "name", name);
    const bool has_full_scale = object.contains("full_scale");
    if (!object.contains("unit")) {
        if (has_full_scale) throw refusal(name, "a channel has a \"full_scale\" without a \"unit\"");
        return channel;
    }
    const std::string unit = text_in(object, "unit", name);
    if (!is_known_unit(unit))
        throw refusal(name, "unknown unit \"" + unit + "\"", "",
                      "Known are Pa, m/s^2, g, m/s, m, N, V and their like.");
    channel.full_scale = unit_of_label(unit);
    if (has_full_scale) channel.full_scale->value *= positive_in(object, "full_scale", name);
    if (!(channel.full_scale->value > 0.0) || !std::isfinite(channel.full_scale->value))
        throw refusal(name, "\"full_scale\" leaves double precision");
    return channel;
}

Json parsed(std::string_view json, const std::string& name) {
    if (base::nesting(json) > base::deepest_document)
        throw refusal(name, "the sidecar is no JSON of ours",
                      "it nests deeper than " + std::to_string(base::deepest_document) + " levels");
    try {
        return Json::parse(json);
    } catch (const Json::parse_error& error) {
        const std::string_view before = json.substr(0, error.byte > 0 ? error.byte - 1 : 0);
        const std::size_t begin = before.rfind('\n') + 1;  // 0 where there is none
        const auto line = static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1;
        const std::string_view text = json.substr(begin, json.find('\n', begin) - begin);
        constexpr std::size_t longest_shown = 200;  // [bytes]
        const base::Place place{name, line, static_cast<int>(before.size() - begin) + 1,
                                text.size() > longest_shown ? "" : std::string(text)};
        throw refusal(place, "the sidecar is no JSON", "it cannot be read on from here",
                      "Correct it, or remove it: the recording is read without one.");
    } catch (const Json::exception&) {
        throw refusal(name, "the sidecar is no JSON", "a number in it is too large");
    }
}

}  // namespace

std::string sidecar_path(const std::string& recording) {
    return recording + ".json";
}

Sidecar parse_sidecar(std::string_view json, const std::string& name) {
    const Json document = parsed(json, name);
    if (!document.is_object() || !document.contains("schema") || document["schema"] != schema)
        throw refusal(name, "the file beside the recording is no sidecar",
                      "its \"schema\" is not \"" + std::string(schema) + "\"", "Rename it?");
    check_keys(document, {"schema", "version", "rate", "channels", "metadata"}, name);
    Sidecar sidecar;
    if (document.contains("rate")) sidecar.rate = positive_in(document, "rate", name);
    if (document.contains("channels")) {
        if (!document["channels"].is_array()) throw refusal(name, "\"channels\" is no list");
        for (const Json& channel : document["channels"])
            sidecar.channels.push_back(channel_of(channel, name));
    }
    if (document.contains("metadata")) {
        if (!document["metadata"].is_object()) throw refusal(name, "\"metadata\" is no object");
        for (const auto& [key, value] : document["metadata"].items())
            sidecar.metadata.emplace_back(key, value.is_string() ? value.get<std::string>() : value.dump());
    }
    return sidecar;
}

std::string sidecar_json(const Sidecar& sidecar) {
    Json document{{"schema", schema}, {"version", base::version()}};
    if (sidecar.rate) document["rate"] = *sidecar.rate;
    document["channels"] = Json::array();
    for (const SidecarChannel& channel : sidecar.channels) {
        Json object = Json::object();
        if (channel.name) object["name"] = *channel.name;
        if (channel.full_scale) {
            object["unit"] = channel.full_scale->unit;
            object["full_scale"] = channel.full_scale->value;
        }
        document["channels"].push_back(std::move(object));
    }
    for (const auto& [key, value] : sidecar.metadata)
        document["metadata"][key] = value;
    return base::text_of(document) + "\n";
}

}  // namespace stridor::recordings
