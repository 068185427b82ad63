// The tokens of a shape key as ANTLR's runtime reads them, and what happens at the first one that fits no block.
// Only block_parser.cpp includes this file.
#pragma once

#include <antlr4-runtime.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "frontend/antlr/token_types.hpp"
#include "frontend/bind/syntax.hpp"

namespace fagorc::frontend {

/// A token of the key as ANTLR sees it: a type and a place.
class KeyToken final : public antlr4::Token {
  public:
    syntax::Token key;
    std::size_t type = EOF, place = 0;

    std::size_t getType() const override { return type; }
    std::size_t getTokenIndex() const override { return place; }
    std::string getText() const override { return {}; }
    std::size_t getLine() const override { return 1; }
    std::size_t getCharPositionInLine() const override { return place; }
    std::size_t getChannel() const override { return DEFAULT_CHANNEL; }
    std::size_t getStartIndex() const override { return place; }
    std::size_t getStopIndex() const override { return place; }
    antlr4::TokenSource* getTokenSource() const override { return nullptr; }
    antlr4::CharStream* getInputStream() const override { return nullptr; }
    std::string toString() const override { return {}; }
};

/// The tokens of one block; the storage is used again for the next one.
class KeyStream final : public antlr4::TokenStream {
  public:
    void load(std::span<const syntax::Token> tokens, const TokenTypes& types) {
        if (tokens_.size() <= tokens.size()) tokens_.resize(tokens.size() + 1);
        for (std::size_t i = 0; i <= tokens.size(); ++i) {
            tokens_[i].place = i;
            tokens_[i].type = i < tokens.size() ? types.of(tokens[i]) : EOF;
            if (i < tokens.size()) tokens_[i].key = tokens[i];
        }
        size_ = tokens.size() + 1;
        at_ = 0;
    }

    /// What follows is the end of the block.
    void drop_rest() { at_ = size_ - 1; }

    void consume() override { at_ += at_ + 1 < size_; }
    std::size_t LA(ssize_t k) override { return LT(k)->getType(); }
    antlr4::Token* LT(ssize_t k) override {
        if (k < 0) return static_cast<std::size_t>(-k) > at_ ? nullptr : &tokens_[at_ - static_cast<std::size_t>(-k)];
        return &tokens_[std::min(at_ + static_cast<std::size_t>(k) - 1, size_ - 1)];
    }
    antlr4::Token* get(std::size_t i) const override { return const_cast<KeyToken*>(&tokens_[i]); }
    ssize_t mark() override { return 0; }
    void release(ssize_t) override {}
    std::size_t index() override { return at_; }
    void seek(std::size_t i) override { at_ = i; }
    std::size_t size() override { return size_; }
    std::string getSourceName() const override { return {}; }
    antlr4::TokenSource* getTokenSource() const override { return nullptr; }
    std::string getText(const antlr4::misc::Interval&) override { return {}; }
    std::string getText() override { return {}; }
    std::string getText(antlr4::RuleContext*) override { return {}; }
    std::string getText(antlr4::Token*, antlr4::Token*) override { return {}; }

  private:
    std::vector<KeyToken> tokens_;
    std::size_t size_ = 0, at_ = 0;
};

/// Where a block broke off, in terms of the grammar.
struct FirstError {
    std::size_t rule, token;
    const antlr4::misc::IntervalSet* expected;
};

/// No recovery: a spoilt block is not executed, and recovery of one malformed block has been seen to take 15 ms. At the
/// first error the rest of the block is taken away, so the rules that are open return one after the other; an exception
/// through all of them would cost more than the parse.
class FirstErrorStops final : public antlr4::ANTLRErrorStrategy {
  public:
    explicit FirstErrorStops(KeyStream& stream) : stream_(stream) {}

    const std::optional<FirstError>& first() const { return first_; }

    void reset(antlr4::Parser*) override { first_.reset(); }
    antlr4::Token* recoverInline(antlr4::Parser* parser) override {
        stop(*parser);
        return stream_.LT(1);
    }
    void recover(antlr4::Parser* parser, std::exception_ptr) override { stop(*parser); }
    void sync(antlr4::Parser*) override {}
    bool inErrorRecoveryMode(antlr4::Parser*) override { return false; }
    void reportMatch(antlr4::Parser*) override {}
    void reportError(antlr4::Parser* parser, const antlr4::RecognitionException&) override { stop(*parser); }

  private:
    void stop(antlr4::Parser& parser) {
        if (first_) return;
        const antlr4::atn::ATN& grammar = parser.getATN();
        first_ = {parser.getContext()->getRuleIndex(), stream_.index(),
                  &grammar.nextTokens(grammar.states[parser.getState()])};
        stream_.drop_rest();
    }

    KeyStream& stream_;
    std::optional<FirstError> first_;
};

}  // namespace fagorc::frontend
