// JSON lines: every line is an object, everything that is referred to stands before.
#include "backends/table/json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/stream.hpp"

namespace fagorc::test {
namespace {

std::vector<nlohmann::json> json_lines(Stream s) {
    backends::MemoryOutput output;
    s.play(*backends::make_json_writer(s.job(), output));
    std::istringstream in{std::string(output.text())};
    std::vector<nlohmann::json> out;
    for (std::string line; std::getline(in, line);) out.push_back(nlohmann::json::parse(line));
    return out;
}

TEST(Json, WhatIsReferredToStandsBefore) {
    std::size_t programs = 0, chains = 0, states = 0, moves = 0, events = 0;
    const auto lines = json_lines(everything());
    ASSERT_EQ(lines.front()["type"], "header");
    for (const auto& line : lines) {
        const std::string type = line["type"];
        if (type == "program") {
            EXPECT_EQ(line["program"], programs++);
        }
        if (type == "state") {
            EXPECT_EQ(line["state"], states++);
        }
        if (type == "chain") {
            EXPECT_EQ(line["chain"], chains++);
            EXPECT_LT(line["program"], programs);
        }
        if (type == "move") {
            EXPECT_EQ(line["move"], moves++);
        }
        if (type == "event") {
            EXPECT_EQ(line["before"], moves);
            ++events;
        }
        if (type == "move" || type == "event") {
            EXPECT_LT(line["chain"], chains);
            EXPECT_LT(line["state"], states);
        }
    }
    EXPECT_EQ(events, 6u);
    EXPECT_EQ(lines.back(), (nlohmann::json{{"type", "end"}, {"moves", 9}, {"events", 6}, {"completed", true}}));
}

TEST(Json, AMoveHasAllThatItIs) {
    for (const auto& line : json_lines(everything())) {
        if (line["type"] == "move" && line["move"] == 3) {
            EXPECT_EQ(line, nlohmann::json::parse(R"({"type":"move","move":3,"kind":"ccw","end":{"X":30,"Z":-20},
                "centre":{"X":30,"Z":-25},"full":true,"feed":0.25,"line":6,"pass":3,"chain":1,"state":2})"));
        }
        if (line["type"] == "event" && line["kind"] == "message") {
            EXPECT_EQ(line["text"], "a \"quoted\", text; \u00e9");
        }
        if (line["type"] == "state" && line["state"] == 2) {
            EXPECT_EQ(line["feed_unit"], "mm/rev");
            EXPECT_EQ(line["length"], (nlohmann::json{{"X", 2}, {"Z", 30}}));
            EXPECT_EQ(line["speed"], 1000);
        }
    }
}

}  // namespace
}  // namespace fagorc::test
