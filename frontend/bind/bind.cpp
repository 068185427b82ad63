// Makes templates: tokens of the key, syntax by the grammar, meaning by the tables.
#include "frontend/bind/bind.hpp"

#include "frontend/antlr/block_parser.hpp"
#include "frontend/bind/binding.hpp"

namespace fagorc::frontend {

namespace {

using diag::Id;
using program::Token;

/// More tokens than any block that a control could hold. Places are 16 bits wide, and a bad block must not cost much.
constexpr std::size_t most_tokens = 4096;
constexpr std::uint16_t skip_marks = 3;

/// Memory that a template holds.
std::size_t bytes_of(const program::BlockTemplate& t) {
    return sizeof t + t.words.capacity() * sizeof(program::Word) + t.nodes.capacity() * sizeof(program::Node) +
           t.findings.capacity() * (sizeof(program::Finding) + 2 * sizeof(diag::Argument));
}

class Maker final : public TemplateMaker {
  public:
    explicit Maker(const control::Dialect& dialect)
        : dialect_(dialect), motion_letters_(motion_letters(dialect)), parser_(dialect) {}

    program::BlockTemplate make(std::string_view key) override {
        program::BlockTemplate t;
        const std::vector<syntax::Token> tokens = tokens_of(key);
        Binding b{dialect_, tokens, motion_letters_, t};
        if (!key.empty() && static_cast<Token>(key[0]) == Token::lower_case)
            b.report(Id::lower_case_word, 0, static_cast<std::uint32_t>(tokens.size()));
        if (readable(b)) {
            auto parsed = parser_.parse(tokens);
            if (auto* block = std::get_if<syntax::Block>(&parsed)) {
                bind(b, *block);
            } else {
                explain(b, std::get<syntax::Error>(parsed));
            }
            if (b.has_error()) {
                explain_statement_without_parentheses(b);
                give_up(t);
            }
        }
        t.bytes = bytes_of(t);
        return t;
    }

  private:
    /// What makes parsing pointless: characters that are no token, and blocks beyond all measure.
    static bool readable(Binding& b) {
        const auto refuse = [&] {
            give_up(b.out);
            return false;
        };
        if (b.tokens.size() > most_tokens) {
            b.report(Id::block_too_complex, 0, 1, most_tokens);
            return refuse();
        }
        int depth = 0;
        for (std::uint32_t i = 0; i < b.tokens.size(); ++i) {
            const Token kind = b.tokens[i].kind;
            if (kind == Token::invalid) b.report(Id::strange_character, i, i + 1, b.named(i));
            if (kind == Token::right_parenthesis) --depth;
            if (kind == Token::left_parenthesis && ++depth > program::max_expression_depth) {
                b.report(Id::expression_too_deep, i, i + 1, program::max_expression_depth);
                return refuse();
            }
        }
        return b.has_error() ? refuse() : true;
    }

    static void give_up(program::BlockTemplate& t) {
        t.broken = true;
        t.body = std::monostate{};
    }

    static void bind(Binding& b, syntax::Block& block) {
        program::BlockTemplate& t = b.out;
        for (const syntax::Index mark : block.skip_marks) bind_skip_mark(b, mark);
        t.nodes = std::move(block.nodes);
        if (block.label) bind_count(b, *block.label, t.label_slot);
        if (block.repetition) {
            bind_count(b, *block.repetition, t.repeat_slot);
            t.repeat_token = block.repetition->token;
        }
        if (block.call) {
            t.body = bind_call(b, *block.call);
            if (!block.items.empty())
                b.report(Id::must_be_alone, block.call->token, block.call->token + 1u, b.named(block.call->token));
        } else if (block.statement) {
            for (const syntax::Index at : block.bare_arguments)
                b.report(Id::argument_without_parentheses, at, at + 1u, b.named(at));
            t.body = bind_statement(b, *block.statement);
        } else if (!block.items.empty()) {
            t.body = bind_iso(b, block.items);
        } else if (!b.tokens.empty()) {
            b.report(Id::empty_block, 0, static_cast<std::uint32_t>(b.tokens.size()));
        }
    }

    /// `/` is `/1`; there are three (8055 T 2.1.1).
    static void bind_skip_mark(Binding& b, syntax::Index token) {
        const std::uint16_t mark = b.tokens[token].payload;
        if (mark >= 1 && mark <= skip_marks)
            b.out.skip_marks = static_cast<std::uint8_t>(b.out.skip_marks | 1u << (mark - 1));
        else
            b.report(Id::improper_format, token, token + 1u, b.named(token));
    }

    /// A label and a repetition are numbers, never parameters (8055 T 2.1.1).
    static void bind_count(Binding& b, const program::Word& word, std::optional<std::uint16_t>& slot) {
        if (word.value.kind == program::WordValue::Kind::number)
            slot = word.value.slot;
        else
            b.report(Id::label_by_parameter, word.token, word.end_token);
    }

    const control::Dialect& dialect_;
    std::uint32_t motion_letters_;
    BlockParser parser_;
};

}  // namespace

std::unique_ptr<TemplateMaker> make_template_maker(const control::Dialect& dialect) {
    return std::make_unique<Maker>(dialect);
}

}  // namespace fagorc::frontend
