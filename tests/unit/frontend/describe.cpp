#include "tests/unit/frontend/describe.hpp"

#include <fmt/format.h>

#include "ir/control/construct.hpp"

namespace fagorc::frontend {
namespace {

using namespace program;

std::string of(WordRun r) {
    return fmt::format("[{}+{}]", r.first, r.count);
}
std::string of(const Expression& e) {
    return fmt::format("<{}+{} {}..{}>", e.first, e.count, e.token, e.end_token);
}
std::string of(const Word& w) {
    return fmt::format("{}{}{}:{}@{}..{}", w.address, w.value.negative ? "-" : "", static_cast<int>(w.value.kind),
                       w.value.slot, w.token, w.end_token);
}
std::string of(const Node& n) {
    return fmt::format("{}{}{}{}:{}:{}@{}", static_cast<int>(n.op), n.condition ? "c" : "", n.indexed ? "i" : "",
                       n.logical ? "l" : "", n.operand, n.slot, n.token);
}
std::string of(const std::vector<FunctionCall>& calls) {
    std::string out;
    for (const FunctionCall& c : calls)
        out += fmt::format(" {}{}@{}{}", c.construct ? c.construct->code : "?", c.number, c.token, of(c.words));
    return out;
}
std::string of(const std::vector<Assignment>& list) {
    std::string out;
    for (const Assignment& a : list)
        out += fmt::format(" {}:{}:{}{}@{}={}", static_cast<int>(a.target.kind), a.target.operand, a.target.slot,
                           of(a.target.index), a.target.token, of(a.value));
    return out;
}

std::string of(const Statement& s);

/// What a kind of statement holds; the kinds without a case here hold nothing that their tokens do not say.
struct Parts {
    std::string operator()(const Assign& s) const { return of(s.list); }
    std::string operator()(const Jump& s) const { return of(s.label); }
    std::string operator()(const Repeat& s) const { return of(s.first) + of(s.last) + of(s.program); }
    std::string operator()(const SubroutineBegin& s) const { return fmt::format("{}:{}", s.local, s.slot); }
    std::string operator()(const Call& s) const {
        return std::to_string(static_cast<int>(s.kind)) + of(s.number) + of(s.arguments);
    }
    std::string operator()(const Execute& s) const {
        return fmt::format("{}:{}{}", static_cast<int>(s.device), s.modal, of(s.program));
    }
    std::string operator()(const Write& s) const { return std::to_string(s.text_slot); }
    std::string operator()(const Message& s) const { return std::to_string(s.text_slot); }
    std::string operator()(const ErrorStop& s) const {
        return fmt::format("{}:{}", of(s.number), s.text_slot ? *s.text_slot : -1);
    }
    std::string operator()(const Enable& s) const { return fmt::format("{}:{}", static_cast<int>(s.what), s.on); }
    std::string operator()(const Probe& s) const { return of(s.cycle) + of(s.arguments); }
    std::string operator()(const If& s) const {
        std::string out = of(s.condition);
        for (const Statement& t : s.then) out += " then " + of(t);
        for (const Statement& e : s.otherwise) out += " else " + of(e);
        return out;
    }
    template <class Other>
    std::string operator()(const Other&) const {
        return {};
    }
};

std::string of(const Statement& s) {
    return fmt::format("{}@{}..{} {}", s.what.index(), s.token, s.end_token, std::visit(Parts{}, s.what));
}

std::string of(const IsoBlock& b) {
    std::string out = fmt::format("iso modal{} functions{} misc{} geometry{} letters{:x} axis{}", of(b.modal),
                                  of(b.functions), of(b.misc), of(b.geometry), b.letters, b.has_axis);
    for (const auto& w : {b.feed, b.speed, b.tool, b.offset}) out += w ? " " + of(*w) : " -";
    for (const Word& w : b.misc_by_parameter) out += " M" + of(w);
    return out;
}

}  // namespace

std::string describe(const BlockTemplate& t) {
    std::string out = fmt::format("skip{} label{} repeat{}@{}{}{}\n", t.skip_marks, t.label_slot ? *t.label_slot : -1,
                                  t.repeat_slot ? *t.repeat_slot : -1, t.repeat_token,
                                  t.by_parameter ? " by parameter" : "", t.broken ? " broken" : "");
    if (const auto* iso = std::get_if<IsoBlock>(&t.body)) out += of(*iso);
    if (const auto* s = std::get_if<Statement>(&t.body)) out += of(*s);
    for (const Word& w : t.words) out += "\nword " + of(w);
    for (const Node& n : t.nodes) out += "\nnode " + of(n);
    for (const Finding& f : t.findings) {
        out += fmt::format("\nfinding {}@{}..{}", static_cast<int>(f.id), f.token, f.end_token);
        for (const auto& a : f.arguments) out += fmt::format(" {}", a.in(Language::english));
    }
    return out;
}

}  // namespace fagorc::frontend
