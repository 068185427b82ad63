// The tables of the controls: what the compiler cannot assert across files.
#include "frontend/controls/controls.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace fagorc {
namespace {

using control::Construct;
using control::Dialect;
using control::Support;

const Dialect& lathe() {
    return *frontend::dialect("8055");
}

TEST(Controls, DialectsAreFoundByName) {
    ASSERT_NE(frontend::dialect("8055"), nullptr);
    EXPECT_EQ(frontend::dialect("8055")->name, "8055");
    EXPECT_EQ(frontend::dialect("8056"), nullptr);
}

TEST(Controls, ConstructsAreInLookUpOrder) {
    for (const Dialect* d : frontend::dialects())
        for (std::size_t i = 1; i < d->constructs.size(); ++i) {
            const Construct &a = *d->constructs[i - 1], &b = *d->constructs[i];
            EXPECT_LT(std::pair(a.letter, a.number), std::pair(b.letter, b.number)) << a.code << " before " << b.code;
        }
}

TEST(Controls, EachConstructIsFoundByTheCodeThatItPrints) {
    for (const Construct* c : lathe().constructs) {
        EXPECT_EQ(c->code.front(), c->letter) << c->code;
        EXPECT_EQ(std::stoi(std::string(c->code.substr(1))), c->number) << c->code;
        EXPECT_EQ(lathe().find(c->letter, c->number), c);
    }
    EXPECT_EQ(lathe().find('G', 43), nullptr);
}

TEST(Controls, SnippetAndSyntaxShowTheCode) {
    for (const Construct* c : lathe().constructs) {
        if (c->takes == control::Takes::arguments) continue;  // one text stands for thirty codes
        EXPECT_NE(c->snippet.find(c->code), std::string_view::npos) << c->code;
        EXPECT_EQ(c->syntax.substr(0, c->code.size()), c->code);
    }
}

TEST(Controls, EachOperandStandsInTheSyntaxAndFillsItsMember) {
    for (const Construct* c : lathe().constructs)
        for (const control::Operand& o : c->operands) {
            if (o.address != control::any_axis) {
                EXPECT_NE(c->syntax.find(o.address, c->code.size()), std::string_view::npos) << c->code << o.address;
            }
            if (c->takes == control::Takes::motion) continue;
            program::Function f = c->make();
            void* target = c->target(f);
            o.slot.set(target, Axis::Z, 1);
            const auto back = o.slot.get(target, Axis::Z);
            ASSERT_TRUE(back.has_value()) << c->code << o.address;
            EXPECT_TRUE(*back == 1 || o.role == control::Role::choice) << c->code << o.address;
        }
}

TEST(Controls, AnOperandLeftOutDiffersFromZero) {
    for (const Construct* c : lathe().constructs) {
        if (c->operands.empty() || c->takes == control::Takes::motion) continue;
        program::Function f = c->make();
        for (const control::Operand& o : c->operands)
            EXPECT_FALSE(o.slot.get(c->target(f), Axis::Z).has_value()) << c->code << o.address;
    }
}

TEST(Controls, CodesOfTheMillModelAreNoCodesOfTheLathe) {
    for (const control::SisterCode& m : lathe().sister_codes) {
        EXPECT_TRUE(m.title.complete());
        EXPECT_EQ(lathe().find(m.letter, m.number), nullptr) << m.letter << m.number;
        EXPECT_EQ(lathe().find_sister(m.letter, m.number), &m);
    }
}

TEST(Controls, NoVariableIsAReservedWord) {
    std::set<std::string_view> words;
    for (const control::ReservedWord& w : lathe().words) words.insert(w.text);
    for (const control::Variable& v : lathe().variables) {
        if (!v.per_axis) {
            EXPECT_EQ(words.count(v.name), 0u) << v.name;
        }
        for (Axis a : all_axes)
            if (v.per_axis) {
                EXPECT_EQ(words.count(std::string(v.name) + letter(a)), 0u) << v.name << letter(a);
            }
    }
}

TEST(Controls, ParameterRangesDoNotOverlap) {
    const auto p = lathe().parameters;
    for (std::size_t i = 0; i < p.size(); ++i) {
        EXPECT_LE(p[i].first, p[i].last);
        if (i > 0) {
            EXPECT_LT(p[i - 1].last, p[i].first);
        }
    }
}

TEST(Controls, RangesReadAsTheyHold) {
    const control::Range percent{.least = 0, .most = 255, .whole = true};
    EXPECT_EQ(to_string(percent), "0 .. 255");
    EXPECT_TRUE(percent.allows(255));
    EXPECT_FALSE(percent.allows(0.5));
    const control::Range positive{.least = 0, .above = true};
    EXPECT_EQ(to_string(positive), "> 0");
    EXPECT_FALSE(positive.allows(0));
    EXPECT_EQ(to_string(control::Range{.not_zero = true}), "<> 0");
    EXPECT_FALSE(control::Range{.not_zero = true}.allows(0));
}

}  // namespace
}  // namespace fagorc
