// The verifier that stands after each pass: it passes everything on, and names what must not be.
#include "passes/verifier.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "ir/diag/catalogue.hpp"
#include "ir/diag/collection.hpp"

namespace fagorc::passes {
namespace {

using namespace operation;

struct Counter : Sink {
    void push(const Operation&) override { ++count; }
    int count = 0;
};

struct Nowhere : Places {
    diag::Place of(const Context&) override { return {}; }
};

class VerifierTest : public testing::Test {
  protected:
    void push(const What& what) {
        Operation o;
        o.at.state = state_;
        o.at.frame = frame_;
        o.at.chain = chain_;
        o.what = what;
        verifier_->push(o);
    }
    /// What the verifier has said, one text a finding.
    std::vector<std::string> said() const {
        std::vector<std::string> out;
        for (const diag::Diagnostic& d : findings_.list()) {
            EXPECT_EQ(d.id, diag::Id::invariant_broken);
            out.push_back(diag::message(d, Language::english));
        }
        return out;
    }

    Tables tables_;
    machine::Machine machine_;
    Nowhere places_;
    diag::Collection findings_;
    Counter next_;
    StateId state_ = tables_.states.intern({});
    FrameId frame_ = tables_.frames.intern({});
    ChainId chain_ = tables_.chains.intern({});
    std::unique_ptr<Pass> verifier_ = make_verifier({machine_, tables_, findings_, places_}, next_, "axes");
};

TEST_F(VerifierTest, SoundOperationsPass) {
    push(Line{{10, 0}, false});
    push(Arc{{0, 10}, {0, 0}, true, false});
    push(Arc{{0, 10}, {0, 20}, false, true});
    push(Thread{{-20, 10}, 1.5, 0});
    push(Dwell{0.5});
    EXPECT_EQ(said(), std::vector<std::string>{});
    EXPECT_EQ(next_.count, 5);
}

TEST_F(VerifierTest, WhatMustNotBeIsNamed) {
    push(Line{{std::numeric_limits<double>::quiet_NaN(), 0}, false});
    push(Line{{10, 0}, false});
    push(Arc{{0, 10.5}, {0, 0}, true, false});  // radii 10 and 10.5
    push(Arc{{0, 10.5}, {0, 10.5}, true, false});
    push(Thread{{0, 0}, 0, 0});
    push(Dwell{-1});
    chain_ = static_cast<ChainId>(7);
    push(Line{{0, 0}, true});
    EXPECT_EQ(said(), (std::vector<std::string>{"internal error after axes: a coordinate is not a number",
                                                "internal error after axes: the radii of an arc disagree",
                                                "internal error after axes: an arc has no radius",
                                                "internal error after axes: a thread has no lead",
                                                "internal error after axes: a dwell is negative",
                                                "internal error after axes: a handle names nothing"}));
    EXPECT_EQ(next_.count, 7);
}

}  // namespace
}  // namespace fagorc::passes
