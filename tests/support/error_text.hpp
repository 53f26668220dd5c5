#pragma once

#include "stridor/base/error.hpp"

#include <gtest/gtest.h>

#include <string>

namespace stridor::support {

/// What an action that must fail throws: its kind and its whole message. Fails the test if nothing is thrown.
struct Thrown {
    ErrorKind kind = ErrorKind::io;
    std::string message;

    bool says(const std::string& part) const { return message.find(part) != std::string::npos; }
};

template <typename Action>
Thrown thrown_by(Action&& action) {
    try {
        action();
    } catch (const Error& error) {
        return {error.kind(), error.what()};
    }
    ADD_FAILURE() << "nothing was thrown";
    return {};
}

}  // namespace stridor::support
