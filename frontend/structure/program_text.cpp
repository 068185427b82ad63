#include "frontend/structure/program_text.hpp"

#include <algorithm>
#include <bit>

#include "frontend/structure/header.hpp"
#include "ir/base/whole.hpp"
#include "ir/program/findings.hpp"

namespace fagorc::frontend {
namespace {

using program::Block;
using program::Cursor;

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// A block that says nothing: blank, or a comment alone. The control's editor cannot store a blank line, files have
/// some.
bool is_silent(const Scan& scan) {
    return scan.key().empty();
}

const program::SubroutineBegin* subroutine_begin(const Block& block) {
    const auto* s = std::get_if<program::Statement>(&block.shape->body);
    return s ? std::get_if<program::SubroutineBegin>(&s->what) : nullptr;
}

/// The template of a block that cannot be used for what is wrong with its own text.
program::BlockTemplate broken(program::Finding finding) {
    program::BlockTemplate shape;
    shape.broken = true;
    shape.findings.push_back(std::move(finding));
    return shape;
}

}  // namespace

std::optional<std::uint32_t> program_number(std::string_view path) {
    const std::string_view name = path.substr(path.find_last_of('/') + 1);
    if (name.size() != 10 || name[6] != '.') return std::nullopt;
    std::string suffix(name.substr(7));
    for (char& c : suffix) c = static_cast<char>(c & ~0x20);
    if (suffix != "PIT" && suffix != "PIM") return std::nullopt;
    std::uint32_t number = 0;
    for (char c : name.substr(0, 6)) {
        if (c < '0' || c > '9') return std::nullopt;
        number = number * 10 + static_cast<std::uint32_t>(c - '0');
    }
    return number;
}

ProgramText::ProgramText(const Decoder& decoder, diag::FileId file, std::string name, std::unique_ptr<Text> text)
    : decoder_(decoder),
      file_(file),
      name_(std::move(name)),
      number_(program_number(name_)),
      text_(std::move(text)),
      reading_{Scan(decoder.dialect.limits.block_bytes), {}, {}},
      looking_{Scan(decoder.dialect.limits.block_bytes), {}, {}},
      rebound_{Scan(decoder.dialect.limits.block_bytes), {}, {}},
      token_scan_(decoder.dialect.limits.block_bytes) {}

std::string_view ProgramText::line_at(std::uint64_t offset) {
    if (offset >= text_->ready()) return {};
    const char* const begin = text_->data() + offset;
    const char* end = begin;
    while (*end != '\n' && *end != '\r') ++end;
    return {begin, static_cast<std::size_t>(end - begin)};
}

const program::Header& ProgramText::header() {
    read_start();
    return header_;
}

Cursor ProgramText::first() {
    read_start();
    return first_;
}

Cursor ProgramText::start() {
    read_start();
    return *start_;
}

/// Header line, then local subroutines up to the line that starts with `%` (8055 T 2.2).
void ProgramText::read_start() {
    if (start_) return;
    if (text_->reach(0) && line_at(0).starts_with(byte_order_mark)) first_.offset = byte_order_mark.size();
    if (is_mark(first_.offset)) {
        const std::string_view line = line_at(first_.offset);
        bool well_formed = true;
        header_ = read_header(line, well_formed);
        if (!well_formed)
            decoder_.diagnostics.report(
                diag::Id::header_malformed,
                diag::Place{file_, 1, 1, static_cast<std::uint32_t>(line.size()) + 1, first_.offset});
        first_ = line_after(first_);
    }
    start_ = read_to_ = indexed_to_ = first_;
    mark_ = first_.offset;
    const Block* block = decode(first_, looking_);
    const auto* sub = block ? subroutine_begin(*block) : nullptr;
    if (!sub || !sub->local) return;
    for (Cursor at = first_; text_->reach(at.offset); at = line_after(at))
        if (is_mark(at.offset)) {
            start_ = read_to_ = line_after(at);
            mark_ = at.offset;
            return;
        }
}

bool ProgramText::is_mark(std::size_t offset) {
    return text_->reach(offset) && text_->data()[offset] == '%';
}

Cursor ProgramText::line_after(Cursor at) {
    const char* p = text_->data() + at.offset;
    const std::size_t length = line_at(at.offset).size();
    return {at.offset + length + (p[length] == '\r' && p[length + 1] == '\n' ? 2 : 1), at.line + 1};
}

/// A lone % behind the last block is the end-of-tape sign of other systems (8055 T 1.1).
bool ProgramText::is_end_of_tape(Cursor at) {
    if (line_at(at.offset).find_first_not_of("% \t") != std::string_view::npos) return false;
    for (at = line_after(at); text_->reach(at.offset); at = line_after(at))
        if (line_at(at.offset).find_first_not_of(" \t") != std::string_view::npos) return false;
    return true;
}

const Block* ProgramText::read(Cursor at) {
    const bool back = at.offset < furthest_;
    if (back && !loop_.empty()) {
        const Decoded* const d = loop_[at.offset % loop_slots].get();
        if (d && d->asked == at.offset) return ++blocks_read_, &d->block;
    }
    const Block* block = decode(at, reading_);
    if (!block) return nullptr;
    ++blocks_read_;
    if (read_to_ == at && !subroutine_begin(*block)) read_to_ = block->next;  // a subroutine's number is checked later
    furthest_ = std::max(furthest_, block->next.offset);
    return back && decoder_.loop_cache && block->shape != &reading_.shape ? keep(at) : block;
}

/// Remembers the block that was read: a loop reads the same ones again and again.
const Block* ProgramText::keep(Cursor asked) {
    if (loop_.empty()) loop_.resize(loop_slots);
    std::unique_ptr<Decoded>& slot = loop_[asked.offset % loop_slots];
    if (!slot) slot = std::make_unique<Decoded>();
    Decoded& d = *slot;
    d.asked = asked.offset;
    d.block = reading_.block;
    d.slots.assign(d.block.slots.begin(), d.block.slots.end());
    d.block.slots = d.slots;
    return &d.block;
}

const Block* ProgramText::decode(Cursor at, Reading& into) {
    while (text_->reach(at.offset)) {
        const char* p = text_->data() + at.offset;
        if (*p == '%' && is_end_of_tape(at)) return nullptr;
        const Scanner::Extent extent = decoder_.scanner.scan(p, into.scan);
        const Cursor next{at.offset + extent.next, at.line + 1};
        if (extent.too_long) {
            const auto limit = static_cast<std::uint64_t>(decoder_.dialect.limits.block_bytes);
            into.block = {&into.shape, {}, {p, extent.length}, at, next};
            into.shape = broken({diag::Id::block_too_long, 0, 0, {limit}});
            return &into.block;
        }
        if (is_silent(into.scan)) {
            at = next;
            continue;
        }
        into.block = {&decoder_.shapes.find(into.scan.key(), into.shape),
                      {into.scan.slots(), into.scan.slot_count()},
                      {p, extent.length},
                      at,
                      next};
        if (into.block.shape->label_slot) refuse_label(into);
        return &into.block;
    }
    if (auto failure = text_->take_failure()) {
        failure->place = place_of_line(at.line);
        decoder_.diagnostics.report(std::move(*failure));
    }
    return nullptr;
}

/// A label is whole and has its range (8055 T 2.1.1). It is a number, so no shape can tell.
void ProgramText::refuse_label(Reading& reading) const {
    const program::BlockTemplate& shape = *reading.block.shape;
    const double label = reading.block.slots[*shape.label_slot].value;
    const std::uint32_t most = decoder_.dialect.limits.label;
    const bool in_range = label >= 0 && label <= most;
    if (in_range && whole_number(label)) return;
    const auto first = static_cast<std::uint16_t>(std::popcount(shape.skip_marks));
    const auto end = static_cast<std::uint16_t>(first + 2);
    reading.shape = in_range ? broken({diag::Id::decimals_not_allowed, first, end, {'N', label}})
                             : broken({diag::Id::label_too_large, first, end, {most}});
    reading.block.shape = &reading.shape;
}

const Block* ProgramText::rebind(const Block& original, std::string_view text, diag::Sink& out) {
    rebound_text_.assign(text);
    rebound_text_ += '\n';
    const Scanner::Extent extent = decoder_.scanner.scan(rebound_text_.c_str(), rebound_.scan);
    if (extent.too_long) return nullptr;
    const program::BlockTemplate& shape = decoder_.shapes.find(rebound_.scan.key(), rebound_.shape);
    rebound_.block = {&shape,
                      {rebound_.scan.slots(), rebound_.scan.slot_count()},
                      {rebound_text_.data(), extent.length},
                      original.here,
                      original.next};
    if (!shape.broken) return &rebound_.block;
    program::report_findings(*this, rebound_.block, out);
    return nullptr;
}

std::vector<program::PlacedToken> ProgramText::tokens(const Block& block) {
    return decoder_.scanner.tokens(block.text.data(), token_scan_);
}

diag::Place ProgramText::place_of_line(std::uint32_t line) {
    const Cursor at = cursor_of_line(line);
    return {file_, line, 1, static_cast<std::uint32_t>(line_at(at.offset).size()) + 1, at.offset};
}

std::optional<std::uint32_t> ProgramText::label_of_line(std::uint32_t line) {
    const Block* block = decode(cursor_of_line(line), looking_);
    if (!block || block->here.line != line || !block->shape->label_slot) return std::nullopt;
    return whole_number(block->slots[*block->shape->label_slot].value);
}

Cursor ProgramText::cursor_of_line(std::uint32_t line) {
    Cursor at = lines_.before(line, Cursor{});
    if (last_line_.line <= line && last_line_.line > at.line) at = last_line_;
    while (at.line < line && text_->reach(at.offset)) at = line_after(at);
    return last_line_ = at;
}

/// Indexes one block more; null at the end of the text.
const Block* ProgramText::index_next() {
    read_start();
    const Block* block = decode(indexed_to_, looking_);
    if (!block) return nullptr;
    indexed_to_ = block->next;
    lines_.add(block->here);
    if (const auto slot = block->shape->label_slot)
        if (const auto label = whole_number(block->slots[*slot].value)) labels_.add(*label, block->here.line);
    if (const auto* sub = subroutine_begin(*block))
        if (const auto number = whole_number(block->slots[sub->slot].value))
            subroutines_.try_emplace({sub->local, *number},
                                     program::Subroutine{*number, sub->local, block->here, block->next});
    return block;
}

std::optional<Cursor> ProgramText::label(std::uint32_t number) {
    Target& target = targets_[number % targets_.size()];
    if (!target.at || target.label != number) target = {number, find_label(number)};
    return target.at;
}

std::optional<Cursor> ProgramText::find_label(std::uint32_t number) {
    if (const auto line = labels_.find(number)) return cursor_of_line(*line);
    while (const Block* block = index_next()) {
        const auto slot = block->shape->label_slot;
        if (slot && whole_number(block->slots[*slot].value) == number) return block->here;
    }
    return std::nullopt;
}

const program::Subroutine* ProgramText::subroutine(std::uint32_t number, bool local) {
    for (;;) {
        const auto at = subroutines_.find({local, number});
        if (at != subroutines_.end()) return &at->second;
        if (!index_next()) return nullptr;
    }
}

}  // namespace fagorc::frontend
