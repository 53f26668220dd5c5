#pragma once

// What all JSON documents share. Only sources include this, so that nlohmann's types stay out of the headers that
// others read.

#include "stridor/base/text.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace stridor::base {

using Json = nlohmann::ordered_json;

/// Most levels of nesting in a document from outside; no program of ours needs ten.
inline constexpr std::size_t deepest_document = 64;

/// Returns a text from outside as a document. The document is discarded (`is_discarded`) if the text is not JSON or
/// nests deeper than `deepest_document`.
inline Json foreign_document(std::string_view text) {
    if (nesting(text) > deepest_document) return Json(Json::value_t::discarded);
    return Json::parse(text, nullptr, false);
}

/// Returns a document as text, indented by two. Bytes that are not UTF-8 become replacement characters; NaN and
/// infinities become null.
inline std::string text_of(const Json& document) {
    return document.dump(2, ' ', false, Json::error_handler_t::replace);
}

/// Returns a text as a value of a document; null if the text is empty.
inline Json text_or_null(const std::string& text) {
    return text.empty() ? Json() : Json(text);
}

}  // namespace stridor::base
