// The order of the words in an ISO block: G, axes, F, S, T, D, M (8055 T 5). Words that belong to a code keep the order
// of the code, and so do the words of a motion such as I, K, R, Q.
#include <string>

#include "frontend/bind/binding.hpp"

namespace fagorc::frontend {

namespace {

using diag::Id;
using program::Word;
using syntax::Item;

/// What a letter is, by its place in the control's order.
enum class Kind : std::uint8_t { preparatory, axis, technology, misc, free };

class OrderCheck {
  public:
    explicit OrderCheck(Binding& binding) : b_(binding), order_(binding.dialect.word_order) {}

    /// The first word out of order is reported: what follows is out of order because of it. Returns whether all is
    /// well.
    bool accept(const Item& item) {
        const Kind kind = kind_of(item.word.address);
        const bool fits = kind == Kind::preparatory  ? preparatory(item.word)
                          : kind == Kind::axis       ? axis(item.word)
                          : kind == Kind::technology ? technology(item.word)
                                                     : true;
        if (kind == Kind::axis) last_axis_ = &item.word;
        if (kind == Kind::technology) last_technology_ = &item.word;
        if (kind == Kind::misc) last_misc_ = &item.word;
        return fits;
    }

  private:
    Kind kind_of(char letter) const {
        if (order_.find(letter) == std::string_view::npos) return Kind::free;
        if (axis_of(letter)) return Kind::axis;
        if (letter == order_.front()) return Kind::preparatory;
        return letter == order_.back() ? Kind::misc : Kind::technology;
    }
    bool refuse(Id id, const Word& word, const Word& before) {
        b_.report(id, word.token, word.end_token, b_.named(word.token), b_.named(before.token));
        return false;
    }

    bool preparatory(const Word& w) {
        if (const Word* before = last_misc_ ? last_misc_ : last_technology_)
            return refuse(Id::g_after_technology, w, *before);
        return last_axis_ ? refuse(Id::g_after_axis, w, *last_axis_) : true;
    }

    bool axis(const Word& w) {
        if (const Word* before = last_misc_ ? last_misc_ : last_technology_)
            return refuse(Id::axis_after_technology, w, *before);
        if (!last_axis_ || order_.find(last_axis_->address) < order_.find(w.address)) return true;
        if (last_axis_->address == w.address) {
            b_.report(Id::axis_repeated, w.token, w.end_token, w.address);
        } else {
            b_.report(Id::axis_order, w.token, w.end_token, w.address, last_axis_->address, axes());
        }
        return false;
    }

    bool technology(const Word& w) {
        if (last_misc_) return refuse(Id::technology_after_misc, w, *last_misc_);
        if (!last_technology_ || order_.find(last_technology_->address) <= order_.find(w.address)) return true;
        return refuse(Id::technology_order, w, *last_technology_);
    }

    std::string axes() const {
        std::string text;
        for (const char c : order_)
            if (axis_of(c)) text += text.empty() ? std::string(1, c) : std::string{' ', c};
        return text;
    }

    Binding& b_;
    std::string_view order_;
    const Word *last_axis_ = nullptr, *last_technology_ = nullptr, *last_misc_ = nullptr;
};

}  // namespace

void check_order(Binding& b, std::span<const Item* const> items) {
    OrderCheck check(b);
    for (const Item* item : items)
        if (!check.accept(*item)) return;
}

}  // namespace fagorc::frontend
