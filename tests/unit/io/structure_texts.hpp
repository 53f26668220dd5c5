#pragma once

#include "io_support.hpp"
#include "stridor/io/case/toml_case.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace stridor::io {

inline constexpr const char* shared_sections =
    "[contact]\npreload = \"2 N\"\nstatic_friction = 1\nkinetic_friction = 0.5\n"
    "[drive]\nkind = \"constant\"\nvelocity = 0.1\n[run]\nduration = 3\n";

inline std::string whole_case(const std::string& structure) {
    return "title = \"own\"\n" + structure + shared_sections;
}

inline parameters::Case read_structure_text(const std::string& text, std::vector<std::string> overrides = {}) {
    return read_case(TomlSource{text, "case.toml", std::move(overrides)});
}

inline std::string structure_refusal(const std::string& text, std::vector<std::string> overrides = {}) {
    const auto error = error_of([&] { read_structure_text(text, std::move(overrides)); });
    if (!error) return "nothing";
    EXPECT_EQ(error->kind(), ErrorKind::input);
    return error->what();
}

}  // namespace stridor::io
