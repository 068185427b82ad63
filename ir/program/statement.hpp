// Statements of a block, neutral of the control that spells them. Numbers are slots of the block; expressions are runs
// of nodes in the template's pool.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "ir/base/axis.hpp"
#include "ir/program/expression.hpp"

namespace fagorc::control {
struct Construct;
}

namespace fagorc::program {

/// The value of a word: a number of the block, or a parameter with a sign (`X-P3`), or nothing (`G04 K`, `G74 X`), or a
/// whole number that stands in the shape itself (`G68 ... M2`: the digits after M are no slot).
struct WordValue {
    enum class Kind : std::uint8_t { none, number, parameter, literal } kind = Kind::none;
    bool negative = false;           ///< parameter only: a number carries its own sign
    std::uint16_t slot = 0;          ///< number: the value; parameter: its number; literal: the value itself
};

/// A letter and its value.
struct Word {
    char address = 0;
    WordValue value;
    std::uint16_t token = 0;         ///< the letter's token
    std::uint16_t end_token = 0;     ///< one past the word's last token
};

/// A run of words in the template's word pool.
struct WordRun {
    std::uint16_t first = 0, count = 0;
};

/// A function code of the block (G or M) with the words that are its own.
struct FunctionCall {
    const control::Construct* construct = nullptr;   ///< null: an M code that the control's tables do not name
    std::uint16_t number = 0;
    std::uint16_t token = 0;
    WordRun words;
};

/// An ISO block, sorted by what the executor does with it (docs/order.md).
struct IsoBlock {
    std::vector<FunctionCall> modal;      ///< settings of modal groups, in the order written
    std::vector<FunctionCall> functions;  ///< functions with operands of their own (G92, G04 K, G36 R ...)
    WordRun geometry;                     ///< axis words and I J K R Q L that belong to the motion
    std::optional<Word> feed, speed, tool, offset;
    std::vector<FunctionCall> misc;       ///< M codes in the order written; M19 S, M45 S own their S
    std::vector<Word> misc_by_parameter;  ///< `MP1`: the number comes from a parameter
    std::uint32_t letters = 0;            ///< bit (letter - 'A') for each geometry word
    bool has_axis = false;                ///< a word of an axis, or polar R or Q, that can move
};

/// Where an assignment stores.
struct Target {
    enum class Kind : std::uint8_t { parameter, letter, indirect, variable } kind = Kind::parameter;
    std::uint16_t operand = 0;       ///< letter: 0..25; variable: payload of its token
    std::uint16_t slot = 0;          ///< parameter: the slot that holds its number
    Expression index{};              ///< indirect: the number; variable: the table index, if it has one
    std::uint16_t token = 0;
};

struct Assignment { Target target; Expression value; };

/// Assignments, stored one after the other from left to right (8055 T 12.1).
struct Assign { std::vector<Assignment> list; };

struct Jump { Expression label; };                                    ///< GOTO
struct Repeat { Expression first, last, program; };                   ///< RPT; no program: this one
struct SubroutineBegin { std::uint16_t slot = 0; bool local = false; std::uint16_t token = 0; };  ///< SUB, LSUB: number in `slot`
struct Return {};

struct Call {
    enum class Kind : std::uint8_t { call, local, with_parameters, modal, by_g_code } kind = Kind::call;
    Expression number;
    std::vector<Assignment> arguments;
};
struct EndModal {};                                                   ///< MDOFF

enum class Device : std::uint8_t { memory, disk, serial_pc, ethernet_pc, unknown };
struct Execute { Expression program; Device device = Device::memory; bool modal = false; };   ///< EXEC, MEXEC
struct Open { Expression program; Device device = Device::memory; std::optional<bool> append; std::optional<std::uint16_t> comment_slot; };
struct Write { std::uint16_t text_slot = 0; };
struct ErrorStop { Expression number; std::optional<std::uint16_t> text_slot; };
struct Message { std::uint16_t text_slot = 0; };
struct GraphicZone { Expression z_min, z_max, inner, outer; };        ///< DGWZ
struct Enable { enum class What : std::uint8_t { single_block, stop, feed_hold } what{}; bool on = false; };
struct Probe { Expression cycle; std::vector<Assignment> arguments; };
struct Reposition { std::vector<Axis> axes; };
/// A statement of the customisation language: screen, keys, windows (8055 T 12.9).
struct Screen { Keyword word{}; std::vector<Expression> operands; std::vector<std::uint16_t> text_slots; };

struct Statement;
struct If { Expression condition; std::vector<Statement> then, otherwise; };

using StatementKind = std::variant<Assign, Jump, Repeat, SubroutineBegin, Return, Call, EndModal, Execute, Open, Write,
                                   ErrorStop, Message, GraphicZone, Enable, Probe, Reposition, Screen, If>;

/// One statement of a high-level block, with the tokens that it covers.
struct Statement {
    StatementKind what;
    std::uint16_t token = 0, end_token = 0;
};

}  // namespace fagorc::program
