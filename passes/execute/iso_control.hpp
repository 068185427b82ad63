// The control as ISO blocks see it: the steps of a block in the order of docs/order.md, on what it keeps (IsoState).
// Its members are defined by subject: iso.cpp, iso_words, iso_functions, iso_motion, iso_arc, iso_technology, iso_misc,
// iso_variables.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "passes/execute/iso.hpp"
#include "passes/execute/iso_forms.hpp"
#include "passes/execute/iso_state.hpp"

namespace fagorc::passes {

struct IsoRunner::Control : IsoState {
    explicit Control(Session& session);

    // -- the order of a block (iso.cpp)
    Outcome run(const program::IsoBlock& block);
    /// The state after power-on, except position, tool and offsets (8055 T 5.1).
    void power_on();
    void reset();
    std::optional<std::uint32_t> subroutine_ended();

    // -- words and their values (iso_words.cpp)
    /// The value of a word: of its number or its parameter; 0 with a warning without either.
    double number(const program::Word& word) {
        if (word.value.kind == program::WordValue::Kind::number) [[likely]]
            return session.block->slots[word.value.slot].value;
        return other_number(word);
    }
    double other_number(const program::Word& word);
    /// A coordinate as written: at most four decimals in millimetres, five in inches, within the control's range.
    double coordinate_word(const program::Word& word) {
        double v = 0;
        if (word.value.kind == program::WordValue::Kind::number) [[likely]] {
            const program::Quantity& q = session.block->slots[word.value.slot];
            if (q.decimals > most_decimals) [[unlikely]]
                return rounded(word, q.value);
            v = q.value;
        } else {
            v = other_number(word);
        }
        if (!(v < word_limit && v > -word_limit)) [[unlikely]]
            beyond_format(word, v);
        return v;
    }
    double rounded(const program::Word& word, double value);
    void beyond_format(const program::Word& word, double value);
    /// From the programmed unit to millimetres, X to a radius, by what the operand is.
    double converted(control::Role role, Axis axis, double value) const;
    /// The operand's own range and whole numbers; false: reported.
    bool allowed(const control::Construct& row, const control::Operand& operand, const program::Word& word,
                 double value);
    /// A whole number, not negative (T, D); nothing: reported or unknown.
    std::optional<std::uint32_t> whole(const program::Word& word);
    void units_changed();

    // -- codes (iso_functions.cpp)
    /// Settings and functions of the block; false: reported.
    bool codes(const program::IsoBlock& block);
    bool code(const program::FunctionCall& call);
    void set_group(const program::FunctionCall& call);
    /// The row of a setting of a modal group; null where the control has no code for it.
    const control::Construct* row_of(program::Group group, std::uint8_t setting) const;
    std::optional<program::Function> filled(const program::FunctionCall& call);
    bool act(const program::FunctionCall& call, const program::Function& function);
    void set_plane(Plane plane);
    bool preset(const program::FunctionCall& call, const program::Preset& preset);
    void home(const program::FunctionCall& call, const program::Home& home);
    void home_subroutine(const program::FunctionCall& call);
    void dwell(const program::Dwell& dwell);
    /// Applies a change of the zero offset: nothing moves, so the coordinates of the present point change.
    void origin_changed(const PerAxis<double>& before);

    // -- motion (iso_motion.cpp, iso_arc.cpp)
    void move(const program::IsoBlock& block);
    void plain_line(std::span<const program::Word> words);
    bool gather(std::span<const program::Word> words, MotionWords& out);
    const Spelling* motion_spelling();
    /// Where a word of an axis goes, part coordinates.
    double destination(Axis axis, double value, const program::Word& word);
    double rotary_destination(Axis axis, double value, const program::Word& word);
    bool positioning_rules(const MotionWords& words);
    void line(const MotionWords& words);
    void emit_line(Point start, AxisSet moved);
    std::optional<Point> polar_end(const MotionWords& words);
    std::optional<Point> angle_end(const MotionWords& words);
    void thread(const MotionWords& words);
    bool cutting_allowed();
    void arc(const MotionWords& words);
    std::optional<Point> arc_end(const MotionWords& words);
    std::optional<CentreWords> centre_words(const MotionWords& words);
    std::optional<double> pitch_word(const MotionWords& words, const MotionWords::Centre& centre);
    bool centre_given(const MotionWords& words, Point& centre, std::optional<double>& pitch);
    bool programmed_arc(const MotionWords& words, ArcForm& out);
    bool polar_arc(const MotionWords& words, ArcForm& out);
    bool radius_arc(const MotionWords& words, ArcForm& out);
    bool other_arc(const MotionWords& words, ArcForm& out);
    std::optional<Turn> tangent_turn(Point end);
    std::optional<Turn> three_point_turn(const MotionWords& words, Point end, std::optional<double>& pitch);
    bool exact(ArcForm& form);
    void emit_arc(const ArcForm& form, const MotionWords& words);
    std::optional<int> whole_turns(const ArcForm& form);

    // -- F S T D M (iso_technology.cpp, iso_misc.cpp)
    void set_feed(const program::Word& word);
    void set_speed(const program::Word& word);
    bool surface_speed_known();
    bool speed_within_limits(const program::IsoBlock& block);
    bool change_gear(const program::IsoBlock& block, std::uint8_t gear);
    const control::Construct* gear_row(int gear) const;
    double surface_rpm() const;
    void technology_changed();
    void tool_words(const program::IsoBlock& block);
    void select_tool(std::uint16_t number);
    void select_offset(std::uint16_t number);
    machine::Offset offset_row(std::uint16_t number) const;
    std::optional<std::uint16_t> offset_of(std::uint16_t tool) const;
    void misc(const program::IsoBlock& block, bool before);
    void one_misc(const program::IsoBlock& block, const program::FunctionCall& call, bool before);
    void misc_by_parameter(const program::IsoBlock& block, const program::Word& word, bool before);
    bool misc_company(const program::IsoBlock& block, const program::FunctionCall& call);
    void misc_function(const program::FunctionCall& call);
    void send_misc(std::uint16_t number);
    void call_misc_subroutine(std::uint16_t number, const machine::Misc& row);
    bool in_subroutine_of(std::uint16_t misc) const;
    bool in_tool_subroutine() const;

    // -- output (iso.cpp)
    /// The operation to come, to be filled in place and sent: to copy what was stored a moment ago would wait for it.
    template <class What>
    What& make() {
        return now.what.emplace<What>();
    }
    template <class What>
    void emit(const What& what) {
        now.what = what;
        send();
    }
    void send();
    void emit_event(operation::Event::Kind kind, double value);
    operation::StateId state_id();

    Session& session;
    Outcome outcome;
};

}  // namespace fagorc::passes
