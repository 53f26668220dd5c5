#pragma once

#include "stridor/base/error.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace stridor::support {

/// The error an action ends in; nothing, and a failed test, if it does not.
template <typename Action>
std::optional<Error> error_of(Action&& action) {
    try {
        action();
    } catch (const Error& error) {
        return error;
    }
    ADD_FAILURE() << "nothing was thrown";
    return std::nullopt;
}

/// What an error must be: a part of its message and where it points ("case.toml:28:11").
inline void expect_error(const std::optional<Error>& error, const std::string& part, const std::string& place) {
    ASSERT_TRUE(error);
    EXPECT_NE(std::string(error->what()).find(part), std::string::npos) << error->what();
    EXPECT_EQ(error->place() ? base::describe(*error->place()) : std::string(), place) << error->what();
}

/// Text with the first `from` replaced.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t position = text.find(from);
    EXPECT_NE(position, std::string::npos) << from;
    return text.replace(position, from.size(), to);
}

}  // namespace stridor::support
