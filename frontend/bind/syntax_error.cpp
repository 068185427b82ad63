// The words for a syntax error: which rule of the grammar broke off, at which token, and what it could have taken.
#include <algorithm>
#include <string>

#include "frontend/bind/binding.hpp"
#include "ir/base/nearest.hpp"

namespace fagorc::frontend {

namespace {

using diag::Id;
using program::Keyword;
using program::Token;
using syntax::Rule;

constexpr Text a_number{"a number", "un nombre", "un número"};
constexpr Text a_letter_or_code{"a word", "un mot", "una palabra"};

class Explainer {
  public:
    Explainer(Binding& binding, const syntax::Error& error) : b_(binding), error_(error), at_(error.token) {}

    void explain() {
        if (!high_level()) return iso();
        if (spelled_word() || at_statement() || at_missing_part()) return;
        if (error_.rule == Rule::block) return after_statement();
        unexpected();
    }

  private:
    // ---- what stands where

    bool ended() const { return at_ >= b_.tokens.size(); }
    Token kind(std::size_t i) const { return i < b_.tokens.size() ? b_.tokens[i].kind : Token::end; }
    bool is_word(std::size_t i, Keyword word) const {
        return kind(i) == Token::keyword && b_.tokens[i].payload == static_cast<std::uint16_t>(word);
    }
    bool expects(syntax::Expected what) const { return error_.expected & what; }
    /// The parenthesis that makes the block a high-level one; one past the last token where there is none before the
    /// error.
    std::size_t opening() const {
        std::size_t i = 0;
        while (i < at_ && kind(i) != Token::left_parenthesis) ++i;
        return i;
    }
    bool high_level() const { return opening() < at_; }
    /// Whether the parenthesis of the statement has been closed before the error.
    bool closed() const {
        int depth = 0;
        for (std::size_t i = 0; i < at_; ++i) {
            depth += kind(i) == Token::left_parenthesis;
            depth -= kind(i) == Token::right_parenthesis;
        }
        return depth <= 0;
    }
    bool starts_operand(std::size_t i) const {
        switch (kind(i)) {
            case Token::number:
            case Token::left_parenthesis:
            case Token::function:
            case Token::variable:
                return true;
            default:
                return is_letter(kind(i)) || is_word(i, Keyword::pi) || is_word(i, Keyword::arg);
        }
    }
    bool ends_operand(std::size_t i) const {
        return kind(i) == Token::number || kind(i) == Token::right_parenthesis || kind(i) == Token::variable ||
               is_letter(kind(i)) || is_word(i, Keyword::pi);
    }
    static bool is_statement_word(Keyword word) { return word < Keyword::device_hd && word != Keyword::input; }

    // ---- reports

    template <class... Arguments>
    bool report(Id id, Arguments&&... arguments) {
        // Where the block ends too early its last token is marked.
        const std::uint32_t first = ended() && at_ > 0 ? at_ - 1u : at_;
        b_.report(id, first, first + 1, std::forward<Arguments>(arguments)...);
        return true;
    }
    bool unexpected() {
        if (!ended()) return report(Id::syntax_error, b_.named(at_));
        return report(Id::block_ends_early, expects(syntax::expects_number)  ? diag::Argument(a_number)
                                            : expects(syntax::expects_right) ? diag::Argument(')')
                                                                             : diag::Argument(a_letter_or_code));
    }

    // ---- ISO blocks

    void iso() {
        switch (kind(at_)) {
            case Token::left_parenthesis:
                report(Id::mixed_languages);
                return;
            case Token::divide:
            case Token::skip:
                report(Id::skip_mark_not_first);
                return;
            case Token::keyword:
            case Token::function:
            case Token::variable:
            case Token::relation:
                report(Id::opening_parenthesis_missing, b_.named(at_));
                return;
            default:
                if (kind(at_) == program::letter_token('P') && error_.rule == Rule::block)
                    report(Id::opening_parenthesis_missing, b_.named(at_));
                else
                    unexpected();
        }
    }

    // ---- high-level blocks

    /// Two letters side by side name nothing: a word that the control does not have.
    bool spelled_word() {
        if (!is_spelling(at_) || error_.rule == Rule::name || closed()) return false;
        std::size_t first = at_, end = at_ + 1;
        while (first > opening() + 1 && is_letter(kind(first - 1))) --first;
        while (is_spelling(end)) ++end;
        if (end - first < 2) return false;
        std::string word;
        for (std::size_t i = first; i < end; ++i) word += static_cast<char>(kind(i));
        unknown(word, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end));
        return true;
    }

    /// A letter, but not that of a label, a program or a parameter: N10, P(A).
    bool is_spelling(std::size_t i) const {
        const bool numbered = kind(i + 1) == Token::number || kind(i + 1) == Token::left_parenthesis;
        const bool n_or_p = kind(i) == program::letter_token('N') || kind(i) == program::letter_token('P');
        return is_letter(kind(i)) && !(n_or_p && numbered);
    }

    void unknown(const std::string& word, std::uint32_t first, std::uint32_t end) {
        if (const control::SisterWord* sister = b_.dialect.find_sister(word)) {
            b_.report(Id::word_of_sister_model, first, end, word, sister->title, b_.dialect.sister_model,
                      b_.dialect.model);
            return;
        }
        std::vector<std::string_view> names;
        for (const control::ReservedWord& w : b_.dialect.words) names.push_back(w.text);
        if (const std::string_view near = nearest(word, names); !near.empty())
            b_.report(Id::unknown_word_near, first, end, word, near);
        else
            b_.report(Id::unknown_word, first, end, word);
    }

    bool at_statement() {
        if (is_word(at_, Keyword::else_)) return report(Id::else_without_if);
        if (error_.rule != Rule::statement) return false;
        if (kind(at_) == Token::g_code || kind(at_) == Token::m_code)
            return report(Id::iso_words_in_statement, b_.named(at_));
        return unexpected();
    }

    bool at_missing_part() {
        const auto word = static_cast<std::uint32_t>(opening() + 1);
        if (error_.rule == Rule::operand && !expects(syntax::expects_left) && expects(syntax::expects_number))
            return index_missing();
        if (expects(syntax::expects_operand)) return operand_missing();
        if (error_.rule == Rule::index) return index_missing();
        if (error_.rule == Rule::name) return report(Id::device_unknown, b_.named(at_));
        if (expects(syntax::expects_program) && !expects(syntax::expects_label))
            return report(Id::program_number_expected, b_.named(at_ - 1u));
        if (expects(syntax::expects_text)) return report(Id::text_expected, b_.named(word));
        if (expects(syntax::expects_input)) return report(Id::input_expected, b_.named(at_));
        if (expects(syntax::expects_equals)) return report(Id::equals_expected, b_.named(at_));
        if (expects(syntax::expects_comma)) return report(Id::comma_expected, b_.named(at_));
        if (expects(syntax::expects_left)) return report(Id::opening_parenthesis_missing, b_.named(at_));
        return false;
    }

    /// No operand where one has to be: the expression is incomplete, or a sign stands in its place.
    bool operand_missing() {
        const Token k = kind(at_);
        const bool stops = ended() || k == Token::right_parenthesis || k == Token::comma || k == Token::keyword;
        if (stops) return report(Id::operation_incomplete);
        return report(Id::expression_malformed, b_.named(at_));
    }

    /// After a table, a label or a program: its number, or an expression in parentheses.
    bool index_missing() {
        if (kind(at_ - 1u) == Token::variable) return report(Id::index_expected, b_.named(at_ - 1u));
        if (starts_operand(at_)) return report(Id::opening_parenthesis_missing, b_.named(at_));
        return report(Id::number_expected, b_.named(at_ - 1u));
    }

    void after_statement() {
        if (closed()) {
            if (kind(at_) == Token::left_parenthesis)
                report(Id::two_statements);
            else if (is_letter(kind(at_)) || kind(at_) == Token::g_code || kind(at_) == Token::m_code)
                report(Id::mixed_languages);
            else
                unexpected();
            return;
        }
        if (ended()) {
            report(Id::closing_parenthesis_missing);
        } else if (kind(at_) == Token::keyword) {
            keyword_after_statement();
        } else if (iso_word_before()) {
            report(Id::iso_words_in_statement, b_.named(at_));
        } else if (starts_operand(at_) && in_list()) {
            report(Id::comma_expected, b_.named(at_));
        } else if (starts_operand(at_) && ends_operand(at_ - 1u)) {
            report(Id::operator_expected, b_.named(at_));
        } else {
            unexpected();
        }
    }

    void keyword_after_statement() {
        const auto word = static_cast<Keyword>(b_.tokens[at_].payload);
        if (is_word(opening() + 1, Keyword::if_) &&
            (word == Keyword::if_ || word == Keyword::sub || word == Keyword::lsub))
            report(Id::if_action_invalid, b_.named(at_));
        else if (is_statement_word(word))
            report(Id::two_statements);
        else
            unexpected();
    }

    /// `(G01 X10)`: what stands before reads as the assignment G=01, so the next letter is a word of ISO.
    bool iso_word_before() const {
        return is_letter(kind(at_)) && at_ >= 3 && kind(at_ - 1u) == Token::number && is_letter(kind(at_ - 2u)) &&
               (at_ - 3u == opening() || kind(at_ - 3u) == Token::comma) &&
               kind(at_ - 2u) != program::letter_token('P');
    }

    /// In a statement whose parts are separated by commas.
    bool in_list() const {
        const std::size_t first = opening() + 1;
        return kind(first) == Token::keyword && !is_word(first, Keyword::if_) && !is_word(first, Keyword::goto_) &&
               !is_word(first, Keyword::sub) && !is_word(first, Keyword::lsub);
    }

    Binding& b_;
    const syntax::Error& error_;
    syntax::Index at_;
};

}  // namespace

void explain(Binding& b, const syntax::Error& error) {
    Explainer(b, error).explain();
}

bool explain_statement_without_parentheses(Binding& b) {
    std::size_t first = 0;
    while (first < b.tokens.size() && b.tokens[first].kind == Token::skip) ++first;
    if (first + 1 < b.tokens.size() && b.tokens[first].kind == program::letter_token('N')) first += 2;
    std::string letters;
    for (std::size_t i = first; i < b.tokens.size(); ++i) {
        const syntax::Token& t = b.tokens[i];
        if (t.payload != 0 || !(is_letter(t.kind) || t.kind == Token::g_code || t.kind == Token::m_code)) break;
        letters += is_letter(t.kind) ? static_cast<char>(t.kind) : t.kind == Token::g_code ? 'G' : 'M';
    }
    std::string_view word;
    for (const control::ReservedWord& w : b.dialect.words)
        if (w.token == Token::keyword && w.text.size() > word.size() && letters.starts_with(w.text)) word = w.text;
    if (word.empty()) return false;
    b.out.findings.clear();
    b.report(Id::opening_parenthesis_missing, static_cast<std::uint32_t>(first),
             static_cast<std::uint32_t>(first + word.size()), word);
    return true;
}

}  // namespace fagorc::frontend
