#pragma once

#include "stridor/io/structure/part_files.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

namespace stridor::io::structure {

inline const std::string block_folder = STRIDOR_SOURCE_DIR "/tests/fixtures/structures/calculix/";

inline std::string text_of(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    EXPECT_TRUE(stream) << path;
    return {std::istreambuf_iterator<char>(stream), {}};
}

inline StructureInput input_of(const std::string& text, const std::string& name = "input") {
    return {recordings::bytes_of(text), name};
}

/// Files in memory by name.
using TextFiles = std::map<std::string, std::string>;

inline reduction::ElasticPart part_of(const TextFiles& texts, const PartFiles& files) {
    return read_part(files, [&](const std::string& path) -> std::optional<StructureInput> {
        const auto found = texts.find(path);
        if (found == texts.end()) return std::nullopt;
        return input_of(found->second, path);
    });
}

/// Reading them ends with this sentence, exit code 2, and at a place if it
/// is about the text and not about the part.
inline void expect_refused(const TextFiles& texts, const PartFiles& files, const std::string& sentence) {
    bool is_read = false;
    try {
        const reduction::ElasticPart part = part_of(texts, files);
        is_read = true;
        reduction::expect_sound(part);
        ADD_FAILURE() << "nothing was thrown for: " << sentence;
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input);
        EXPECT_NE(std::string(error.what()).find(sentence), std::string::npos) << error.what();
        EXPECT_TRUE(is_read || error.place()) << error.what();
    }
}

inline reduction::ElasticPart block_part() {
    return read_part({.files = {block_folder + "block.sti"}});
}

}  // namespace stridor::io::structure
