#include "frontend/structure/program_text.hpp"

#include <algorithm>
#include <cstring>

#include "frontend/structure/header.hpp"
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

bool is_return(const Block& block) {
    const auto* s = std::get_if<program::Statement>(&block.shape->body);
    return s && std::holds_alternative<program::Return>(s->what);
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
      token_scan_(decoder.dialect.limits.block_bytes) {
    too_long_.broken = true;
    if (text_->reach(byte_order_mark.size()) &&
        std::memcmp(text_->data(), byte_order_mark.data(), byte_order_mark.size()) == 0)
        first_.offset = byte_order_mark.size();
}

std::string_view ProgramText::line_at(std::uint64_t offset) {
    if (offset >= text_->ready()) return {};
    const std::string_view rest(text_->data() + offset, text_->ready() - offset);
    return rest.substr(0, rest.find_first_of("\r\n"));
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

/// Header line, then local subroutines up to the line that starts with `%` (8055 T 2.7).
void ProgramText::read_start() {
    if (start_) return;
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

const Block* ProgramText::read(Cursor at) {
    ++blocks_read_;
    const bool back = at.offset < furthest_;
    if (!loop_.empty()) {
        const Decoded& d = loop_[at.offset % loop_slots];
        if (d.block.shape && d.block.here.offset == at.offset) return &d.block;
    }
    const Block* block = decode(at, reading_);
    if (!block) return nullptr;
    if (read_to_ == at) read_to_ = block->next;
    if (!back) {
        furthest_ = block->here.offset;
        return block;
    }
    return decoder_.loop_cache && decoder_.shapes.kept() ? keep(*block) : block;
}

/// Remembers a decoded block: a loop reads the same ones again and again.
const Block* ProgramText::keep(const Block& block) {
    if (loop_.empty()) loop_.resize(loop_slots);
    Decoded& d = loop_[block.here.offset % loop_slots];
    d.slots.assign(block.slots.begin(), block.slots.end());
    d.block = block;
    d.block.slots = d.slots;
    return &d.block;
}

const Block* ProgramText::decode(Cursor at, Reading& into) {
    while (text_->reach(at.offset)) {
        const char* p = text_->data() + at.offset;
        if (*p == '%') {
            // A lone % at the end is the end-of-tape sign of other systems (8055 T 1.1).
            const Cursor after = line_after(at);
            if (line_at(at.offset).size() == 1 && !text_->reach(after.offset)) return nullptr;
        }
        const Scanner::Extent extent = decoder_.scanner.scan(p, into.scan);
        const Cursor next{at.offset + extent.next, at.line + 1};
        if (extent.too_long) {
            const auto limit = static_cast<std::uint64_t>(decoder_.dialect.limits.block_bytes);
            too_long_.findings = {{diag::Id::block_too_long, 0, 0, {extent.length, limit}}};
            into.block = {&too_long_, {}, {p, extent.length}, at, next};
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
        return &into.block;
    }
    if (!text_->failure().empty())
        decoder_.diagnostics.report(diag::Id::cannot_spool, place_of_line(at.line), text_->failure());
    return nullptr;
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

Cursor ProgramText::cursor_of_line(std::uint32_t line) {
    Cursor at = lines_.before(line, Cursor{});
    if (last_line_.line <= line && last_line_.line > at.line) at = last_line_;
    while (at.line < line && text_->reach(at.offset)) at = line_after(at);
    return last_line_ = at;
}

/// Indexes on to the end of the text; from a pipe, a block at a time, since what follows may not have come yet.
bool ProgramText::index_more() {
    read_start();
    bool any = false;
    while (const Block* block = decode(indexed_to_, looking_)) {
        index_block(*block);
        indexed_to_ = block->next;
        any = true;
        if (!text_->complete()) return true;
    }
    return any;
}

void ProgramText::index_block(const Block& block) {
    lines_.add(block.here);
    if (const auto slot = block.shape->label_slot)
        labels_.add(static_cast<std::uint32_t>(block.slots[*slot].value), block.here.line);
    if (const auto* sub = subroutine_begin(block))
        subroutines_.push_back(
            {{static_cast<std::uint32_t>(block.slots[sub->slot].value), sub->local, block.here, block.next}, 0});
    else if (is_return(block) && !subroutines_.empty() && subroutines_.back().end_line == 0)
        subroutines_.back().end_line = block.here.line;
}

std::optional<Cursor> ProgramText::label(std::uint32_t number) {
    do {
        if (const auto line = labels_.find(number)) return cursor_of_line(*line);
    } while (index_more());
    return std::nullopt;
}

const program::Subroutine* ProgramText::subroutine(std::uint32_t number, bool local) {
    do {
        for (const SubroutineEntry& e : subroutines_)
            if (e.subroutine.number == number && e.subroutine.local == local) return &e.subroutine;
    } while (index_more());
    return nullptr;
}

std::vector<std::uint32_t> ProgramText::global_subroutines() {
    while (index_more()) {
    }
    std::vector<std::uint32_t> numbers;
    for (const SubroutineEntry& e : subroutines_)
        if (!e.subroutine.local) numbers.push_back(e.subroutine.number);
    return numbers;
}

bool ProgramText::inside_subroutine(Cursor at) {
    while (indexed_to_.offset <= at.offset && index_more()) {
    }
    return std::any_of(subroutines_.begin(), subroutines_.end(), [&](const SubroutineEntry& e) {
        return e.subroutine.begin.line <= at.line && (e.end_line == 0 || at.line <= e.end_line);
    });
}

}  // namespace fagorc::frontend
