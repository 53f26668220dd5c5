#include "stridor/io/arrow_stream.hpp"

#include "support/expected_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace stridor::io {
namespace {

const double missing = std::nan("");

ArrowTable small_table(std::size_t rows) {
    ArrowTable table{{{"preload", {{"unit", "N"}}, ArrowKind::number, {}, {}},
                      {"contact", {}, ArrowKind::integer, {}, {}},
                      {"category", {}, ArrowKind::word, {}, {"none", "squeal", "", "ü"}}},
                     {{"title", "a table"}},
                     64};
    for (std::size_t row = 0; row < rows; ++row) {
        const auto k = static_cast<double>(row);
        table.columns[0].values.push_back(row % 5 == 3 ? missing : 0.1 * k);
        table.columns[1].values.push_back(k - 7.0);
        table.columns[2].values.push_back(row % 7 == 2 ? missing : static_cast<double>(row % 4));
    }
    return table;
}

bool is_there(const ArrowArray& array, std::size_t row) {
    const auto* bytes = static_cast<const unsigned char*>(array.buffers[0]);
    return bytes == nullptr || (bytes[row / 8] >> row % 8 & 1U) != 0;
}

std::string word_at(const ArrowArray& array, std::size_t row) {
    const auto index = static_cast<std::size_t>(static_cast<const std::int32_t*>(array.buffers[1])[row]);
    const auto* ends = static_cast<const std::int32_t*>(array.dictionary->buffers[1]);
    return {static_cast<const char*>(array.dictionary->buffers[2]) + ends[index],
            static_cast<std::size_t>(ends[index + 1] - ends[index])};
}

void expect_chunk(const ArrowArray& chunk, std::size_t first) {
    const ArrowTable whole = small_table(first + static_cast<std::size_t>(chunk.length));
    for (std::size_t row = 0; row < static_cast<std::size_t>(chunk.length); ++row) {
        const double number = whole.columns[0].values[first + row];
        ASSERT_EQ(is_there(*chunk.children[0], row), !std::isnan(number));
        if (!std::isnan(number)) {
            EXPECT_EQ(static_cast<const double*>(chunk.children[0]->buffers[1])[row], number);
        }
        EXPECT_EQ(static_cast<const std::int64_t*>(chunk.children[1]->buffers[1])[row],
                  static_cast<std::int64_t>(whole.columns[1].values[first + row]));
        const double word = whole.columns[2].values[first + row];
        ASSERT_EQ(is_there(*chunk.children[2], row), !std::isnan(word));
        if (!std::isnan(word)) {
            EXPECT_EQ(word_at(*chunk.children[2], row), whole.columns[2].words[static_cast<std::size_t>(word)]);
        }
    }
}

TEST(ArrowStream, GivesEachRowOnce) {
    for (const std::size_t rows : {0U, 1U, 63U, 64U, 65U, 1000U}) {
        ArrowArrayStream stream = arrow_stream(small_table(rows));
        std::size_t first = 0;
        for (;;) {
            ArrowArray chunk;
            ASSERT_EQ(stream.get_next(&stream, &chunk), 0);
            if (chunk.release == nullptr) break;
            EXPECT_EQ(chunk.n_children, 3);
            EXPECT_LE(chunk.length, 64);
            expect_chunk(chunk, first);
            first += static_cast<std::size_t>(chunk.length);
            chunk.release(&chunk);
        }
        EXPECT_EQ(first, rows);
        stream.release(&stream);
        EXPECT_EQ(stream.release, nullptr);
    }
}

TEST(ArrowStream, SchemaSaysTypesAndUnits) {
    ArrowArrayStream stream = arrow_stream(small_table(3));
    ArrowSchema schema;
    ASSERT_EQ(stream.get_schema(&stream, &schema), 0);
    stream.release(&stream);  // the schema lives on
    EXPECT_STREQ(schema.format, "+s");
    ASSERT_EQ(schema.n_children, 3);
    const char* formats[] = {"g", "l", "i"};
    for (int k = 0; k < 3; ++k) {
        EXPECT_STREQ(schema.children[k]->format, formats[k]);
        EXPECT_EQ(schema.children[k]->flags, 2);
    }
    EXPECT_STREQ(schema.children[0]->name, "preload");
    EXPECT_STREQ(schema.children[2]->dictionary->format, "u");
    EXPECT_EQ(schema.children[1]->metadata, nullptr);
    const char packed[] = "\1\0\0\0\4\0\0\0unit\1\0\0\0N";
    EXPECT_EQ(std::memcmp(schema.children[0]->metadata, packed, sizeof packed - 1), 0);
    schema.release(&schema);
    EXPECT_EQ(schema.release, nullptr);
}

TEST(ArrowStream, ChunksAndTheirChildrenOutliveEverything) {
    ArrowArrayStream stream = arrow_stream(small_table(200));
    std::vector<ArrowArray> chunks(3);
    for (ArrowArray& chunk : chunks)
        ASSERT_EQ(stream.get_next(&stream, &chunk), 0);
    stream.release(&stream);
    // a consumer moves a child away: it copies the structure, and marks the old one as released
    ArrowArray moved = *chunks[1].children[2];
    chunks[1].children[2]->release = nullptr;
    for (const std::size_t k : {1U, 0U})
        chunks[k].release(&chunks[k]);
    expect_chunk(chunks[2], 128);
    EXPECT_EQ(word_at(moved, 3), small_table(68).columns[2].words[67 % 4]);
    moved.release(&moved);
    chunks[2].release(&chunks[2]);
    EXPECT_EQ(chunks[2].release, nullptr);
}

TEST(ArrowStream, ReleasesWhatIsReleasedAlreadyWithoutHarm) {
    ArrowArrayStream stream = arrow_stream(small_table(5));
    ArrowSchema schema;
    ArrowArray chunk;
    stream.get_schema(&stream, &schema);
    stream.get_next(&stream, &chunk);
    const auto release_schema = schema.release;
    const auto release_chunk = chunk.release;
    const auto release_stream = stream.release;
    const auto next = stream.get_next;
    for (int time = 0; time < 2; ++time) {
        release_schema(&schema);
        release_chunk(&chunk);
        release_stream(&stream);
    }
    EXPECT_NE(next(&stream, &chunk), 0);
}

TEST(ArrowStream, OfColumnsThatDoNotFitIsRefused) {
    ArrowTable uneven = small_table(5);
    uneven.columns[1].values.pop_back();
    EXPECT_NE(support::error_of([&] { arrow_stream(uneven); })->problem().what.find("contact"), std::string::npos);
    ArrowTable wordless = small_table(5);
    wordless.columns[2].values[0] = 4.0;
    EXPECT_NE(support::error_of([&] { arrow_stream(wordless); })->problem().what.find("category"), std::string::npos);
    ArrowArrayStream empty = arrow_stream({});
    ArrowArray chunk;
    EXPECT_EQ(empty.get_next(&empty, &chunk), 0);
    EXPECT_EQ(chunk.release, nullptr);
    empty.release(&empty);
}

}  // namespace
}  // namespace stridor::io
