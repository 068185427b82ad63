// Sorts the words of an ISO block: codes by what they do, each word to the code that takes it, the rest to motion,
// feed, speed, tool and offset (8055 T 5).
#include <array>

#include "frontend/bind/binding.hpp"

namespace fagorc::frontend {

namespace {

using control::Construct;
using control::Takes;
using diag::Id;
using program::FunctionCall;
using program::Word;
using program::WordValue;
using syntax::Item;

constexpr int nobody = -1, refused = -2;
constexpr std::size_t letters = 26;

constexpr std::size_t at(char letter) {
    return static_cast<std::size_t>(letter - 'A');
}
constexpr std::uint32_t bit(char letter) {
    return 1u << at(letter);
}

class IsoBinder {
  public:
    IsoBinder(Binding& binding, std::span<const Item> items)
        : b_(binding), items_(items), owner_(items.size(), nobody) {}

    program::IsoBlock bind() {
        for (const Item& i : items_)
            if (is_code_by_parameter(i)) {
                b_.out.by_parameter = true;  // bound when it is executed, with the code put in
                return {};
            }
        for (std::size_t i = 0; i < items_.size(); ++i) code(i);
        for (std::size_t i = 0; i < items_.size(); ++i) word(i);
        order();
        hand_out_words();
        for (const FunctionCall& call : calls_) file(call);
        if (!b_.has_error()) check_company(b_, block_);  // what follows from an error says nothing new
        if (b_.has_error()) return {};
        for (const FunctionCall& call : calls_) check_operands(b_, call);
        return std::move(block_);
    }

  private:
    static bool is_code_by_parameter(const Item& i) {
        return i.word.address == 'G' && i.word.value.kind == WordValue::Kind::parameter;
    }
    static bool is_code(const Item& i) { return i.word.address == 'G' || i.word.address == 'M'; }
    const Construct* row(int owner) const { return calls_[static_cast<std::size_t>(owner)].construct; }

    // ---- codes

    void code(std::size_t i) {
        const Item& item = items_[i];
        if (!is_code(item)) return;
        const char letter = item.word.address;
        if (letter == 'M' && cycle_ != nobody && row(cycle_)->operand('M')) return;  // an operand: G68 ... M2
        if (item.word.value.kind == WordValue::Kind::number) {
            b_.report(Id::improper_format, item.word.token, item.word.end_token, letter);
            owner_[i] = refused;
            return;
        }
        if (item.word.value.kind == WordValue::Kind::parameter) return;  // MP1
        const std::uint16_t number = item.code.value_or(0);              // G alone is G0 (8055 T 2)
        const Construct* construct = b_.dialect.find(letter, number);
        if (!construct && !known_misc(item, number)) {
            owner_[i] = refused;
            return;
        }
        owner_[i] = static_cast<int>(calls_.size());
        calls_.push_back({construct, number, item.word.token, {}});
        if (!construct) return;
        if (construct->takes == Takes::all) cycle_ = owner_[i];
        if (construct->takes == Takes::listed) list_operands(*construct, owner_[i]);
    }

    /// An M code needs no row: the machine's table knows it (8055 T 5.7).
    bool known_misc(const Item& item, std::uint16_t number) {
        const std::uint32_t first = item.word.token, end = item.word.end_token;
        const std::string spelled = item.word.address + std::to_string(number);
        if (item.word.address == 'M') {
            if (number <= b_.dialect.limits.misc) return true;
            b_.report(Id::unknown_misc, first, end, spelled, b_.dialect.limits.misc);
        } else if (const control::SisterCode* sister = b_.dialect.find_sister('G', number)) {
            b_.report(Id::code_of_sister_model, first, end, spelled, sister->title, b_.dialect.sister_model,
                      b_.dialect.model);
            sister_ = true;
        } else {
            b_.report(Id::unknown_g, first, end, spelled, b_.dialect.model);
        }
        return false;
    }

    void list_operands(const Construct& c, int owner) {
        for (const control::Operand& o : c.operands) {
            if (o.address != control::any_axis) {
                claim(o.address, owner);
            } else {
                for (Axis a : all_axes) claim(letter(a), owner);
            }
        }
    }
    void claim(char letter, int owner) {
        if (listed_[at(letter)] == nobody) listed_[at(letter)] = owner;
    }

    // ---- words

    void word(std::size_t i) {
        const Item& item = items_[i];
        if (owner_[i] == refused) return;
        if (owner_[i] != nobody) {  // a code: what follows at once may belong to it
            const Construct* c = row(owner_[i]);
            if (c && c->takes == Takes::all) cycle_ = owner_[i];
            next_ = c && c->takes == Takes::next ? owner_[i] : nobody;
            next_taken_ = 0;
            return;
        }
        const int owner = owner_of(item.word.address, i);
        if (owner != next_ || owner == nobody) next_ = nobody;
        if (owner != nobody) {
            owner_[i] = owner;
        } else if (item.word.address == 'M') {
            block_.misc_by_parameter.push_back(item.word);
        } else if (item.word.address == 'N') {
            repetition(i);
        } else {
            place(item.word);
        }
    }

    int owner_of(char letter, std::size_t i) {
        if (next_ != nobody && !(next_taken_ & bit(letter)) && row(next_)->operand(letter)) {
            next_taken_ |= bit(letter);
            return next_;
        }
        // A cycle takes what is written after it.
        if (cycle_ != nobody && calls_[static_cast<std::size_t>(cycle_)].token < items_[i].word.token &&
            row(cycle_)->operand(letter))
            return taken_by(cycle_, letter, i);
        if (listed_[at(letter)] != nobody) return taken_by(listed_[at(letter)], letter, i);
        return nobody;
    }

    int taken_by(int owner, char letter, std::size_t i) {
        const Word& w = items_[i].word;
        if (owned_ & bit(letter))
            b_.report(axis_of(letter) ? Id::axis_repeated : Id::repeated_word, w.token, w.end_token, letter);
        owned_ |= bit(letter);
        return owner;
    }

    /// N after another word: how often the block is executed (8055 T 2.1.3).
    void repetition(std::size_t i) {
        const Word& w = items_[i].word;
        if (i + 1 != items_.size()) {
            b_.report(Id::syntax_error, w.token, w.end_token, 'N');
        } else if (w.value.kind == WordValue::Kind::number) {
            b_.out.repeat_slot = w.value.slot;
            b_.out.repeat_token = w.token;
        } else if (w.value.kind == WordValue::Kind::parameter) {
            b_.report(Id::label_by_parameter, w.token, w.end_token);
        } else {
            b_.report(Id::number_expected, w.token, w.end_token, 'N');
        }
    }

    void place(const Word& w) {
        switch (w.address) {
            case 'F':
                return single(block_.feed, w);
            case 'S':
                return single(block_.speed, w);
            case 'T':
                return single(block_.tool, w);
            case 'D':
                return single(block_.offset, w);
            default:
                break;
        }
        if (axis_of(w.address) || (b_.motion_letters & bit(w.address)))
            geometry(w);
        else if (sister_)
            return;  // perhaps an operand of the sister model's code
        else if (!calls_.empty() && calls_.front().construct)
            b_.report(Id::word_not_taken, w.token, w.end_token, w.address, calls_.front().construct->code);
        else
            b_.report(Id::unknown_word, w.token, w.end_token, w.address);
    }

    void single(std::optional<Word>& into, const Word& w) {
        if (into) b_.report(Id::repeated_word, w.token, w.end_token, w.address);
        into = w;
    }

    void geometry(const Word& w) {
        if (block_.letters & bit(w.address)) repeated(w);
        block_.letters |= bit(w.address);
        block_.has_axis = block_.has_axis || axis_of(w.address) || w.address == 'R' || w.address == 'Q';
        geometry_.push_back(w);
    }

    void repeated(const Word& w) {
        if (axis_of(w.address)) return;  // the order of the axes says so
        if (w.address == 'Q') {
            b_.report(Id::two_angles, w.token, w.end_token);
            return;
        }
        // In a plane such as XU both axes have the same centre letter: I for the first, then I for the second.
        int axes = 0;
        for (Axis a : all_axes) axes += centre_letter(a) == w.address && (block_.letters & bit(letter(a)));
        if (axes < 2) b_.report(Id::repeated_word, w.token, w.end_token, w.address);
    }

    // ---- the block

    bool is_operand(std::size_t i) const {
        return owner_[i] >= 0 && calls_[static_cast<std::size_t>(owner_[i])].token != items_[i].word.token;
    }

    void order() {
        std::vector<const Item*> free;
        free.reserve(items_.size());
        for (std::size_t i = 0; i < items_.size(); ++i)
            if (!is_operand(i)) free.push_back(&items_[i]);
        check_order(b_, free);
    }

    /// Words to the pool, those of one code side by side.
    void hand_out_words() {
        std::vector<Word>& pool = b_.out.words;
        pool.reserve(items_.size());
        std::vector<std::vector<Word>> of(calls_.size());
        for (std::size_t i = 0; i < items_.size(); ++i) {
            if (!is_operand(i)) continue;
            Word w = items_[i].word;
            if (items_[i].code) w.value = {WordValue::Kind::literal, false, *items_[i].code};
            of[static_cast<std::size_t>(owner_[i])].push_back(w);
        }
        for (std::size_t k = 0; k < calls_.size(); ++k) {
            calls_[k].words = {static_cast<std::uint16_t>(pool.size()), static_cast<std::uint16_t>(of[k].size())};
            pool.insert(pool.end(), of[k].begin(), of[k].end());
        }
        block_.geometry = {static_cast<std::uint16_t>(pool.size()), static_cast<std::uint16_t>(geometry_.size())};
        pool.insert(pool.end(), geometry_.begin(), geometry_.end());
    }

    void file(const FunctionCall& call) {
        if (!call.construct || call.construct->letter == 'M')
            block_.misc.push_back(call);
        else if (call.construct->group != program::Group::none)
            block_.modal.push_back(call);
        else
            block_.functions.push_back(call);
    }

    Binding& b_;
    std::span<const Item> items_;
    std::vector<int> owner_;           ///< of each item: an index into calls_; of a code: its own
    std::vector<FunctionCall> calls_;  ///< in the order written
    std::vector<Word> geometry_;
    std::array<int, letters> listed_ = [] {
        std::array<int, letters> none{};
        none.fill(nobody);
        return none;
    }();  ///< who takes a letter anywhere in the block
    int cycle_ = nobody, next_ = nobody;
    std::uint32_t next_taken_ = 0, owned_ = 0;
    bool sister_ = false;  ///< the block has a code of the sister model
    program::IsoBlock block_;
};

}  // namespace

std::uint32_t motion_letters(const control::Dialect& dialect) {
    std::uint32_t set = 0;
    for (const Construct* c : dialect.constructs)
        if (c->takes == Takes::motion)
            for (const control::Operand& o : c->operands)
                if (o.address != control::any_axis) set |= bit(o.address);
    return set;
}

program::IsoBlock bind_iso(Binding& b, std::span<const syntax::Item> items) {
    return IsoBinder(b, items).bind();
}

}  // namespace fagorc::frontend
