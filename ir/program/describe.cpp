#include "ir/program/describe.hpp"

#include <fmt/format.h>

#include "ir/diag/catalogue.hpp"

namespace fagorc::program {

namespace {

template <class... F>
struct Cases : F... {
    using F::operator()...;
};
template <class... F>
Cases(F...) -> Cases<F...>;

class Describer {
  public:
    Describer(const BlockTemplate& shape, const control::Dialect& dialect) : shape_(shape), dialect_(dialect) {}

    std::string block() {
        for (int mark = 1; mark <= 3; ++mark)
            if (shape_.skip_marks & 1 << (mark - 1)) add(fmt::format("skip={}", mark));
        if (shape_.label_slot) add(fmt::format("label=#{}", *shape_.label_slot));
        if (shape_.by_parameter) add("by_parameter");
        if (const auto* iso = std::get_if<IsoBlock>(&shape_.body)) words(*iso);
        if (const auto* s = std::get_if<Statement>(&shape_.body)) add(statement(*s));
        if (shape_.repeat_slot) add(fmt::format("repeat=#{}", *shape_.repeat_slot));
        for (const Finding& f : shape_.findings)
            add(fmt::format("{}({}..{})", diag::row(f.id).name, f.token, f.end_token));
        return std::move(out_);
    }

  private:
    void add(std::string_view part) {
        if (!out_.empty()) out_ += ' ';
        out_ += part;
    }

    // ---- ISO

    static std::string word(const Word& w) {
        switch (w.value.kind) {
            case WordValue::Kind::none:
                return std::string(1, w.address);
            case WordValue::Kind::number:
                return fmt::format("{}=#{}", w.address, w.value.slot);
            case WordValue::Kind::parameter:
                return fmt::format("{}={}P#{}", w.address, w.value.negative ? "-" : "", w.value.slot);
            case WordValue::Kind::literal:
                return fmt::format("{}={}", w.address, w.value.slot);
        }
        return {};
    }
    std::string call(const FunctionCall& c) const {
        std::string text = c.construct ? std::string(c.construct->code) : fmt::format("M{}", c.number);
        std::string operands;
        for (const Word& w : shape_.run(c.words)) operands += (operands.empty() ? "" : " ") + word(w);
        return operands.empty() ? text : fmt::format("{}({})", text, operands);
    }
    void calls(std::string_view kind, const std::vector<FunctionCall>& list) {
        std::string text;
        for (const FunctionCall& c : list) text += (text.empty() ? "" : " ") + call(c);
        if (!list.empty()) add(fmt::format("{}[{}]", kind, text));
    }
    void words(const IsoBlock& iso) {
        calls("modal", iso.modal);
        calls("function", iso.functions);
        for (const Word& w : shape_.run(iso.geometry)) add(word(w));
        for (const auto* w : {&iso.feed, &iso.speed, &iso.tool, &iso.offset})
            if (*w) add(word(**w));
        calls("misc", iso.misc);
        for (const Word& w : iso.misc_by_parameter) add(word(w));
    }

    // ---- statements

    std::string of(Expression e) const { return describe(shape_, e, dialect_); }
    std::string of(const Target& t) const {
        switch (t.kind) {
            case Target::Kind::parameter:
                return fmt::format("P#{}", t.slot);
            case Target::Kind::letter:
                return std::string(1, static_cast<char>('A' + t.operand));
            case Target::Kind::indirect:
                return fmt::format("P({})", of(t.index));
            case Target::Kind::variable:
                break;
        }
        const std::string name = dialect_.variable_name(t.operand);
        return t.index.present() ? fmt::format("{}({})", name, of(t.index)) : name;
    }
    std::string of(const std::vector<Assignment>& list, std::string text = {}) const {
        for (const Assignment& a : list)
            text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", of(a.target), of(a.value));
        return text;
    }
    static std::string_view of(Device device) {
        constexpr std::string_view names[] = {"memory", "disk", "serial", "ethernet", "unknown"};
        return names[static_cast<std::size_t>(device)];
    }
    static std::string text(std::optional<std::uint16_t> slot) { return slot ? fmt::format(", #{}", *slot) : ""; }

    std::string statement(const Statement& s) const {
        return std::visit(
            Cases{[&](const Assign& a) { return fmt::format("assign({})", of(a.list)); },
                  [&](const Jump& j) { return fmt::format("goto({})", of(j.label)); },
                  [&](const Repeat& r) { return repeat(r); },
                  [&](const SubroutineBegin& b) { return fmt::format("{}(#{})", b.local ? "lsub" : "sub", b.slot); },
                  [&](const Return&) { return std::string("ret"); }, [&](const Call& c) { return of(c); },
                  [&](const EndModal&) { return std::string("end_modal"); },
                  [&](const Execute& e) {
                      return fmt::format("{}({}, {})", e.modal ? "mexec" : "exec", of(e.program), of(e.device));
                  },
                  [&](const Open& o) { return open(o); },
                  [&](const Write& w) { return fmt::format("write(#{})", w.text_slot); },
                  [&](const ErrorStop& e) {
                      return fmt::format("error({}{})", e.number.present() ? of(e.number) : "", text(e.text_slot));
                  },
                  [&](const Message& m) { return fmt::format("message(#{})", m.text_slot); },
                  [&](const GraphicZone& z) {
                      return fmt::format("graphic_zone({}, {}, {}, {})", of(z.z_min), of(z.z_max), of(z.inner),
                                         of(z.outer));
                  },
                  [&](const Enable& e) { return enable(e); },
                  [&](const Probe& p) { return fmt::format("probe({})", of(p.arguments, of(p.cycle))); },
                  [&](const Reposition& r) { return reposition(r); }, [&](const Screen& s2) { return screen(s2); },
                  [&](const If& i) { return branch(i); }},
            s.what);
    }

    std::string repeat(const Repeat& r) const {
        const std::string program = r.program.present() ? ", program " + of(r.program) : "";
        return fmt::format("repeat({}, {}{})", of(r.first), of(r.last), program);
    }
    std::string of(const Call& c) const {
        constexpr std::string_view names[] = {"call", "call_local", "call_with", "call_modal", "call_by_code"};
        return fmt::format("{}({})", names[static_cast<std::size_t>(c.kind)], of(c.arguments, of(c.number)));
    }
    std::string open(const Open& o) const {
        const std::string_view how = !o.append ? "new" : *o.append ? "append" : "replace";
        return fmt::format("open({}, {}, {}{})", of(o.program), of(o.device), how, text(o.comment_slot));
    }
    static std::string enable(const Enable& e) {
        constexpr std::string_view names[] = {"single_block", "stop", "feed_hold"};
        return fmt::format("{}({})", e.on ? "enable" : "disable", names[static_cast<std::size_t>(e.what)]);
    }
    static std::string reposition(const Reposition& r) {
        std::string text;
        for (const Axis a : r.axes) text += (text.empty() ? "" : ", ") + std::string(1, letter(a));
        return fmt::format("reposition({})", text);
    }
    std::string screen(const Screen& s) const {
        std::string text;
        for (const Expression e : s.operands) text += (text.empty() ? "" : ", ") + of(e);
        for (const std::uint16_t slot : s.text_slots) text += fmt::format("{}#{}", text.empty() ? "" : ", ", slot);
        return fmt::format("screen({}: {})", dialect_.word(s.word), text);
    }
    std::string branch(const If& i) const {
        std::string text = of(i.condition);
        for (const Statement& s : i.then) text += ", " + statement(s);
        for (const Statement& s : i.otherwise) text += ", else " + statement(s);
        return fmt::format("if({})", text);
    }

    const BlockTemplate& shape_;
    const control::Dialect& dialect_;
    std::string out_;
};

}  // namespace

std::string describe(const BlockTemplate& shape, const control::Dialect& dialect) {
    return Describer(shape, dialect).block();
}

}  // namespace fagorc::program
