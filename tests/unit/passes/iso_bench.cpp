#include "tests/unit/passes/iso_bench.hpp"

#include <cctype>
#include <cmath>
#include <cstdlib>

namespace fagorc::passes::testing {
namespace {

using control::Construct;
using control::Takes;
using program::FunctionCall;
using program::IsoBlock;
using program::Quantity;
using program::Word;
using program::WordValue;

/// Puts a block together: letters and numbers, each word to its code or its place in the block.
class Assembler {
  public:
    Assembler(program::BlockTemplate& shape, std::vector<Quantity>& slots) : shape_(shape), slots_(slots) {}

    void assemble(std::string_view text) {
        std::vector<Word> geometry;
        const auto& dialect = *frontend::dialect("8055");
        std::size_t i = 0;
        while (i < text.size()) {
            const char letter = text[i++];
            if (letter == ' ') continue;
            if (letter == 'G' || (letter == 'M' && text[i] != 'P')) {
                const auto number = static_cast<std::uint16_t>(std::strtol(text.data() + i, nullptr, 10));
                while (i < text.size() && std::isdigit(static_cast<unsigned char>(text[i]))) ++i;
                finish_call();
                call_ = FunctionCall{dialect.find(letter, number), number, token_++, {}};
                letter_of_call_ = letter;
                continue;
            }
            const Word word = read_word(letter, text, i);
            if (call_ && takes(*call_, word)) {
                words_of_call_.push_back(word);
                continue;
            }
            switch (letter) {
                case 'F':
                    block_.feed = word;
                    break;
                case 'S':
                    block_.speed = word;
                    break;
                case 'T':
                    block_.tool = word;
                    break;
                case 'D':
                    block_.offset = word;
                    break;
                case 'M':
                    block_.misc_by_parameter.push_back(word);
                    break;
                default:
                    geometry.push_back(word);
                    block_.letters |= 1u << (letter - 'A');
                    block_.has_axis = block_.has_axis || axis_of(letter).has_value() || letter == 'R' || letter == 'Q';
            }
        }
        finish_call();
        block_.geometry = put(geometry);
        shape_.body = block_;
    }

  private:
    bool takes(const FunctionCall& call, const Word& word) const {
        const Construct* row = call.construct;
        if (row == nullptr || row->operands.empty() || row->takes == Takes::motion) return false;
        if (row->takes == Takes::next && !words_of_call_.empty()) return false;
        return row->operand(word.address) != nullptr;
    }

    Word read_word(char letter, std::string_view text, std::size_t& i) {
        Word word;
        word.address = letter;
        word.token = token_++;
        word.end_token = ++token_;
        std::size_t start = i;
        if (i < text.size() && text[i] == '-' && i + 1 < text.size() && text[i + 1] == 'P')
            word.value.negative = true, ++i;
        if (i < text.size() && text[i] == 'P') {
            word.value.kind = WordValue::Kind::parameter;
            start = ++i;
        }
        Quantity q;
        bool point = false, any = false;
        while (i < text.size() && std::string_view("+-.0123456789").find(text[i]) != std::string_view::npos) {
            any = true;
            if (point) ++q.decimals;
            point = point || text[i] == '.';
            ++i;
        }
        if (!any) return word;
        if (word.value.kind == WordValue::Kind::none) word.value.kind = WordValue::Kind::number;
        q.value = std::strtod(std::string(text.substr(start, i - start)).c_str(), nullptr);
        word.value.slot = static_cast<std::uint16_t>(slots_.size());
        slots_.push_back(q);
        return word;
    }

    program::WordRun put(const std::vector<Word>& words) {
        const auto first = static_cast<std::uint16_t>(shape_.words.size());
        shape_.words.insert(shape_.words.end(), words.begin(), words.end());
        return {first, static_cast<std::uint16_t>(words.size())};
    }

    void finish_call() {
        if (!call_) return;
        call_->words = put(words_of_call_);
        const Construct* row = call_->construct;
        if (letter_of_call_ == 'M') {
            block_.misc.push_back(*call_);
        } else if (row->make == nullptr && row->group != program::Group::none) {
            block_.modal.push_back(*call_);
        } else {
            block_.functions.push_back(*call_);
        }
        call_.reset();
        words_of_call_.clear();
    }

    program::BlockTemplate& shape_;
    std::vector<Quantity>& slots_;
    IsoBlock block_;
    std::optional<FunctionCall> call_;
    std::vector<Word> words_of_call_;
    char letter_of_call_ = 0;
    std::uint16_t token_ = 0;
};

}  // namespace

machine::Machine sweep_lathe() {
    machine::Machine m;
    for (Axis a : all_axes) m.axes[a].exists = true;
    const auto rotary = [&](Axis a, machine::AxisType type) {
        m.axes[a].type = type;
        m.axes[a].rollover = true;
    };
    rotary(Axis::A, machine::AxisType::positioning);
    rotary(Axis::B, machine::AxisType::hirth);
    rotary(Axis::C, machine::AxisType::rotary);
    m.tool_count = 99;
    m.default_offset.nose = 0.4;
    m.default_offset.tip = 3;
    m.home_subroutine = 9990;
    for (int number : {0, 1, 2, 5, 30}) m.misc[static_cast<std::uint16_t>(number)].before = false;
    for (int number : {3, 4}) m.misc[static_cast<std::uint16_t>(number)].before = true;
    return m;
}

IsoBench::IsoBench(machine::Machine machine)
    : session{.dialect = *frontend::dialect("8055"),
              .machine = std::move(machine),
              .library = library,
              .live = live,
              .tables = tables,
              .texts = texts,
              .diagnostics = findings,
              .head = out,
              .options = options,
              .parameters = Parameters(*frontend::dialect("8055"), {}),
              .program = &program,
              .wanted = {},
              .reported = {}},
      runner(session) {}

IsoBench& IsoBench::run(std::string_view blocks) {
    while (!blocks.empty() && !session.ends()) {
        const auto end = blocks.find('\n');
        texts_of_blocks_.emplace_back(blocks.substr(0, end));
        blocks.remove_prefix(end == std::string_view::npos ? blocks.size() : end + 1);
        shapes_.emplace_back();
        slots_.emplace_back();
        Assembler(shapes_.back(), slots_.back()).assemble(texts_of_blocks_.back());
        program::Block block{&shapes_.back(), slots_.back(), texts_of_blocks_.back(), {line_, ++line_}, {}};
        session.block = &block;
        outcome = runner.run(std::get<IsoBlock>(shapes_.back().body));
        session.block = nullptr;
    }
    return *this;
}

std::string IsoBench::alarm() const {
    for (auto d = findings.list.rbegin(); d != findings.list.rend(); ++d) {
        const diag::Row& row = diag::row(d->id);
        if (row.severity == diag::Severity::error)
            return std::string(row.alarm_8055.empty() ? row.name : row.alarm_8055);
    }
    return {};
}

std::vector<std::string> IsoBench::warnings() const {
    std::vector<std::string> names;
    for (const auto& d : findings.list)
        if (diag::row(d.id).severity == diag::Severity::warning) names.emplace_back(diag::row(d.id).name);
    return names;
}

std::vector<operation::Operation> IsoBench::moves() const {
    std::vector<operation::Operation> list;
    for (const auto& o : out.list)
        if (operation::is_motion(o.what)) list.push_back(o);
    return list;
}

const operation::Operation& IsoBench::last_move() const {
    for (auto o = out.list.rbegin(); o != out.list.rend(); ++o)
        if (operation::is_motion(o->what)) return *o;
    static const operation::Operation none{};
    return none;
}

std::uint16_t IsoBench::variable_row(std::string_view name, bool per_axis) const {
    const auto& rows = session.dialect.variables;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].name == name && rows[i].per_axis == per_axis) return static_cast<std::uint16_t>(i);
    return 0;
}

double IsoBench::variable(std::string_view name, std::optional<Axis> axis, std::optional<long> number) {
    const auto row = variable_row(name, axis.has_value());
    return runner.variable(row, axis ? static_cast<int>(index(*axis)) : -1, number).value_or(std::nan(""));
}

}  // namespace fagorc::passes::testing
