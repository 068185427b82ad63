// The fence: the only file that includes ANTLR. It feeds the generated parser with the tokens of a shape key and copies
// its tree into our own syntax, one small function a rule of grammar/Fagor8055.g4.
#include "frontend/antlr/block_parser.hpp"

#include <Fagor8055.h>

#include <mutex>

#include "frontend/antlr/expression_reader.hpp"
#include "frontend/antlr/key_stream.hpp"
#include "frontend/antlr/token_types.hpp"
#include "frontend/antlr/tree.hpp"

namespace fagorc::frontend {

namespace {

using namespace tree;  // NOLINT(google-build-using-namespace): the helpers of this one file
using program::Target;
using program::WordValue;
using syntax::Statement;

// ---------------------------------------------------------------- errors

syntax::Rule rule_of(std::size_t rule) {
    using T = Fagor8055;
    switch (rule) {
        case T::RuleBlock:
            return syntax::Rule::block;
        case T::RuleIso:
        case T::RuleWord:
        case T::RuleCount:
        case T::RuleLabel:
        case T::RuleRepetition:
        case T::RuleValue:
        case T::RuleCall:
        case T::RuleArgument:
            return syntax::Rule::iso;
        case T::RuleStatement:
        case T::RuleAction:
            return syntax::Rule::statement;
        case T::RuleDevice:
        case T::RuleOption:
        case T::RuleName:
            return syntax::Rule::name;
        case T::RuleIndex:
        case T::RuleReference:
            return syntax::Rule::index;
        case T::RuleUnary:
        case T::RulePrimary:
        case T::RuleVariable:
            return syntax::Rule::operand;
        default:
            return syntax::Rule::other;
    }
}

syntax::Error error_of(const FirstError& at) {
    using T = Fagor8055;
    syntax::Error e{rule_of(at.rule), static_cast<Index>(at.token), 0};
    const auto note = [&](std::size_t type, syntax::Expected flag) {
        if (at.expected->contains(type)) e.expected = static_cast<std::uint16_t>(e.expected | flag);
    };
    note(T::EOF, syntax::expects_end);
    note(T::NUMBER, syntax::expects_number);
    note(T::TEXT, syntax::expects_text);
    note(T::COMMA, syntax::expects_comma);
    note(T::EQUALS, syntax::expects_equals);
    note(T::LEFT, syntax::expects_left);
    note(T::RIGHT, syntax::expects_right);
    note(T::LETTER_P, syntax::expects_program);
    note(T::PI, syntax::expects_operand);
    note(T::LETTER_N, syntax::expects_label);
    note(T::INPUT, syntax::expects_input);
    return e;
}

// ---------------------------------------------------------------- reading the tree

/// Copies one tree.
class Reader : private ExpressionReader {
  public:
    syntax::Block block(const Fagor8055::BlockContext& c) {
        for (const antlr4::Token* mark : c.marks) out_.skip_marks.push_back(place(mark));
        if (c.numbered) out_.label = counted(*c.numbered);
        if (c.words) iso(*c.words);
        if (c.body) out_.statement = statement(*c.body);
        if (c.times) out_.repetition = counted(*c.times);
        return std::move(out_);
    }

  private:
    // ---- ISO

    /// A label or a repetition: N and a value.
    static program::Word counted(const ParserRuleContext& c) {
        return word(c.start, &child<Fagor8055::ValueContext>(c, 1));
    }

    static program::Word word(const antlr4::Token* address, const Fagor8055::ValueContext* v) {
        program::Word w{.address = letter(address), .value = {}, .token = place(address), .end_token = 0};
        w.end_token = static_cast<Index>(v ? end_of(*v) : w.token + 1);
        if (!v) return w;
        w.value = {v->parameter ? WordValue::Kind::parameter : WordValue::Kind::number, is_minus(v->sign),
                   key(v->number).slot};
        return w;
    }

    static syntax::Item code(const antlr4::Token* token) {
        const syntax::Token& k = key(token);
        const Index at = place(token), end = static_cast<Index>(at + 1);
        return {{k.kind == program::Token::m_code ? 'M' : 'G', {}, at, end}, k.payload};
    }

    void iso(const Fagor8055::IsoContext& c) {
        out_.items.reserve(c.children.size());
        for (std::size_t i = 0; i < c.children.size(); ++i) {
            const ParserRuleContext& part = rule(c, i);
            switch (part.getRuleIndex()) {
                case Fagor8055::RuleWord: {
                    const auto& w = static_cast<const Fagor8055::WordContext&>(part);
                    out_.items.push_back(w.code ? code(w.code) : syntax::Item{word(w.letter, w.amount), {}});
                    break;
                }
                case Fagor8055::RuleCount:
                    out_.items.push_back(
                        {word(part.start, static_cast<const Fagor8055::CountContext&>(part).amount), {}});
                    break;
                default:
                    call(static_cast<const Fagor8055::CallContext&>(part));
            }
        }
    }

    void call(const Fagor8055::CallContext& c) {
        syntax::Call& call = out_.call.emplace();
        call.token = place(c.start);
        call.number = key(c.start).payload;
        for (std::size_t i = 1; i < c.children.size(); ++i) {
            if (rule(c, i).getRuleIndex() == Fagor8055::RuleRepetition)
                out_.repetition = counted(rule(c, i));
            else
                call.arguments.push_back(argument(child<Fagor8055::ArgumentContext>(c, i)));
        }
    }

    program::Assignment argument(const Fagor8055::ArgumentContext& c) {
        program::Assignment a;
        if (c.code) {  // M3 gives the parameter M the value 3
            a.target = local(code(c.code).word.address, c.code);
            a.value = open(c);
            push({.op = Operator::constant, .operand = key(c.code).payload, .token = place(c.code)}, a.value);
            return a;
        }
        a.target = c.letter || !c.number ? local(letter(c.start), c.start) : parameter(c.parameter, c.number);
        const Fagor8055::ValueContext& v = *c.amount;
        a.value = open(v);
        push({.op = v.parameter ? Operator::parameter : Operator::number,
              .slot = key(v.number).slot,
              .token = place(v.start)},
             a.value);
        if (is_minus(v.sign)) push({.op = Operator::negate, .token = place(v.sign)}, a.value);
        return a;
    }

    // ---- statements

    Statement statement(const Fagor8055::StatementContext& c) {
        const ParserRuleContext& what = rule(c, 0);
        switch (what.getRuleIndex()) {
            case Fagor8055::RuleBranch:
                return branch(static_cast<const Fagor8055::BranchContext&>(what));
            case Fagor8055::RuleDefinition: {
                Statement s = started(what);
                s.operands.push_back(number(leaf(what, 1)));
                return s;
            }
            default:
                return action(static_cast<const Fagor8055::ActionContext&>(what));
        }
    }

    /// A statement that starts with its word.
    static Statement started(const ParserRuleContext& c) {
        Statement s;
        if (key(c.start).kind == program::Token::keyword) s.word = static_cast<program::Keyword>(key(c.start).payload);
        s.token = place(c.start);
        s.end_token = end_of(c);
        return s;
    }

    Statement branch(const Fagor8055::BranchContext& c) {
        Statement s = started(c);
        s.operands.push_back(expression(*c.condition));
        if (c.then) s.then.push_back(action(*c.then));
        if (c.alternative) s.alternative = place(c.alternative);
        if (c.otherwise) s.otherwise.push_back(action(*c.otherwise));
        return s;
    }

    Statement action(const Fagor8055::ActionContext& of) {
        const ParserRuleContext& c = rule(of, 0);
        Statement s = started(c);
        const std::size_t n = c.children.size();
        switch (c.getRuleIndex()) {
            case Fagor8055::RuleAssignments:
                s.word.reset();
                for (std::size_t i = 0; i < n; i += 2) s.assignments.push_back(assignment(rule(c, i)));
                break;
            case Fagor8055::RuleJump:
                s.operands.push_back(numeral(rule(c, 2)));
                break;
            case Fagor8055::RuleRepeat: {
                const auto& r = static_cast<const Fagor8055::RepeatContext&>(c);
                s.operands = {numeral(*r.first), numeral(*r.last)};
                if (r.in) s.operands.push_back(numeral(rule(*r.in, 1)));
                break;
            }
            case Fagor8055::RuleSubroutine:
                s.operands.push_back(expression(rule(c, 1)));
                for (std::size_t i = 3; i < n; i += 2) s.assignments.push_back(assignment(rule(c, i)));
                break;
            case Fagor8055::RuleExecute:
                s.operands.push_back(numeral(rule(rule(c, 1), 1)));
                if (n > 3) s.names.push_back({place(rule(c, 3).start), end_of(rule(c, 3))});
                break;
            case Fagor8055::RuleOpen:
                s.operands.push_back(numeral(rule(rule(c, 1), 1)));
                for (std::size_t i = 3; i < n; i += 2) option(child<Fagor8055::OptionContext>(c, i), s);
                break;
            case Fagor8055::RuleText:
                if (n > 1) s.texts.push_back(place(leaf(c, 1)));
                break;
            case Fagor8055::RuleError: {
                const auto& e = static_cast<const Fagor8055::ErrorContext&>(c);
                if (e.number) s.operands.push_back(expression(*e.number));
                if (e.message) s.texts.push_back(place(e.message));
                break;
            }
            case Fagor8055::RuleOperands:
                for (std::size_t i = 1; i < n; i += 2) s.operands.push_back(expression(rule(c, i)));
                break;
            case Fagor8055::RuleReposition:
                for (std::size_t i = 1; i < n; i += 2) s.names.push_back({place(rule(c, i).start), end_of(rule(c, i))});
                break;
            default:
                screen(c, s);
        }
        return s;
    }

    static void option(const Fagor8055::OptionContext& c, Statement& s) {
        if (c.comment)
            s.texts.push_back(place(c.comment));
        else
            s.names.push_back({place(c.start), end_of(c)});
    }

    /// Statements of customisation programs; RET, ESBLK and others have their word only.
    void screen(const ParserRuleContext& c, Statement& s) {
        const std::size_t n = c.children.size();
        switch (c.getRuleIndex()) {
            case Fagor8055::RuleEntry:
                s.operands.push_back(numeral(rule(c, 1)));
                s.texts.push_back(place(leaf(c, 4)));
                if (n > 6) s.operands.push_back(expression(rule(c, 6)));
                break;
            case Fagor8055::RuleWindows:
                for (std::size_t i = 0; i < n; i += 2) {
                    s.operands.push_back(numeral(rule(rule(c, i), 1)));
                    s.operands.push_back(expression(rule(rule(c, i), 3)));
                }
                break;
            case Fagor8055::RuleSoftkeys:
                for (std::size_t i = 0; i < n; i += 2) {
                    s.operands.push_back(numeral(rule(rule(c, i), 1)));
                    s.texts.push_back(place(leaf(rule(c, i), 3)));
                }
                break;
            case Fagor8055::RuleBuffer:
                if (n > 1) s.texts.push_back(place(leaf(c, 1)));
                if (n > 3) s.operands.push_back(expression(rule(c, 3)));
                break;
            default:
                break;
        }
    }

    program::Assignment assignment(const ParserRuleContext& of) {
        const auto& c = static_cast<const Fagor8055::AssignmentContext&>(of);
        program::Assignment a;
        if (c.target) {
            a.target = {
                .kind = Target::Kind::variable, .operand = key(c.target->start).payload, .token = place(c.start)};
            if (c.target->children.size() > 1) a.target.index = numeral(rule(*c.target, 1));
        } else if (c.number_of) {
            a.target = {.kind = Target::Kind::indirect, .index = expression(*c.number_of), .token = place(c.start)};
        } else {
            a.target = c.number ? parameter(c.letter, c.number) : local(letter(c.letter), c.letter);
        }
        a.value = c.result ? expression(*c.result) : number(c.constant);
        if (is_minus(c.sign)) push({.op = Operator::negate, .token = place(c.sign)}, a.value);
        return a;
    }

    static Target local(char name, const antlr4::Token* token) {
        return {.kind = Target::Kind::letter, .operand = static_cast<Index>(name - 'A'), .token = place(token)};
    }
    static Target parameter(const antlr4::Token* token, const antlr4::Token* number) {
        return {.kind = Target::Kind::parameter, .slot = key(number).slot, .token = place(token)};
    }
};

}  // namespace

struct BlockParser::Antlr {
    explicit Antlr(const control::Dialect& dialect) : types(dialect), parser(&stream) {
        parser.removeErrorListeners();
        parser.setErrorHandler(errors);
    }

    TokenTypes types;
    KeyStream stream;
    std::shared_ptr<FirstErrorStops> errors = std::make_shared<FirstErrorStops>(stream);
    Fagor8055 parser;
};

BlockParser::BlockParser(const control::Dialect& dialect) : antlr_(std::make_unique<Antlr>(dialect)) {}
BlockParser::~BlockParser() = default;

std::variant<syntax::Block, syntax::Error> BlockParser::parse(std::span<const syntax::Token> tokens) {
    // Parsers of the runtime 4.9 share lazily made tables without a lock of their own.
    static std::mutex one_at_a_time;
    const std::lock_guard lock(one_at_a_time);
    Antlr& a = *antlr_;
    a.stream.load(tokens, a.types);
    a.parser.reset();
    const Fagor8055::BlockContext& tree = *a.parser.block();
    if (a.errors->first()) return error_of(*a.errors->first());
    return Reader().block(tree);
}

}  // namespace fagorc::frontend
