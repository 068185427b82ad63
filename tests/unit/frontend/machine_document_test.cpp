// docs/machine-file.md names every key that a machine file may have.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "frontend/machine/key.hpp"

namespace fagorc::frontend::machine_file {
namespace {

TEST(MachineDocument, NamesEveryKey) {
    std::ifstream in("docs/machine-file.md", std::ios::binary);
    const std::string document{std::istreambuf_iterator<char>(in), {}};
    ASSERT_FALSE(document.empty()) << "tests run in the project's folder";
    const auto named = [&](std::string_view key) {
        return document.find('`' + std::string(key) + '`') != std::string::npos;
    };
    for (const auto keys : {machine_keys(), modal_keys(), axis_keys(), spindle_keys(), start_keys(), offset_keys(),
                            tool_keys(), misc_keys(), policy_keys()})
        for (const Key& key : keys) EXPECT_TRUE(named(key.name)) << key.name;
    for (const std::string_view name : other_parameters()) EXPECT_TRUE(named(name)) << name;
}

}  // namespace
}  // namespace fagorc::frontend::machine_file
