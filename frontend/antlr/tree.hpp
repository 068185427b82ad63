// Access to ANTLR's tree. Children of a context are taken by their place in the rule, or by a label of the grammar
// where parts may be missing: the accessors that ANTLR generates search the children with dynamic casts. Only
// block_parser.cpp includes this file.
#pragma once

#include <antlr4-runtime.h>

#include "frontend/antlr/key_stream.hpp"

namespace fagorc::frontend::tree {

using antlr4::ParserRuleContext;
using syntax::Index;

template <class Context>
const Context& child(const ParserRuleContext& of, std::size_t i) {
    return static_cast<const Context&>(*of.children[i]);
}
inline const ParserRuleContext& rule(const ParserRuleContext& of, std::size_t i) {
    return child<ParserRuleContext>(of, i);
}
inline Index place(const antlr4::Token* token) {
    return static_cast<Index>(token->getTokenIndex());
}
inline Index end_of(const ParserRuleContext& c) {
    return static_cast<Index>(place(c.stop) + 1);
}
inline const syntax::Token& key(const antlr4::Token* token) {
    return static_cast<const KeyToken*>(token)->key;
}
/// The token of a child that is no rule.
inline const antlr4::Token* leaf(const ParserRuleContext& of, std::size_t i) {
    return const_cast<antlr4::tree::TerminalNode&>(child<antlr4::tree::TerminalNode>(of, i)).getSymbol();
}
inline bool is_minus(const antlr4::Token* sign) {
    return sign && sign->getType() == grammar::Fagor8055::MINUS;
}
inline char letter(const antlr4::Token* token) {
    return static_cast<char>(key(token).kind);
}

}  // namespace fagorc::frontend::tree
