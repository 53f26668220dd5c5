#pragma once

// What all JSON documents share, whatever they tell. Only sources include this: nlohmann's types stay out of the
// headers that others see.

#include "stridor/base/text.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace stridor::base {

using Json = nlohmann::ordered_json;

/// Most levels of a document that somebody else wrote; no program of ours needs ten.
inline constexpr std::size_t deepest_document = 64;

/// The text of others as a document. It is discarded (`is_discarded`) where it is no JSON, or nests deeper than
/// `deepest_document`.
inline Json foreign_document(std::string_view text) {
    if (nesting(text) > deepest_document) return Json(Json::value_t::discarded);
    return Json::parse(text, nullptr, false);
}

/// A document as text, indented by two. Bytes that are no UTF-8 become replacement characters, NaN and infinities null.
inline std::string text_of(const Json& document) {
    return document.dump(2, ' ', false, Json::error_handler_t::replace);
}

/// A text as a value of a document; null where it is empty.
inline Json text_or_null(const std::string& text) {
    return text.empty() ? Json() : Json(text);
}

}  // namespace stridor::base
