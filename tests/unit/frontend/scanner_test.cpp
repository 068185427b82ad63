// The lexical rules of the 8055 T (2, 2.1, 11.1 to 11.3).
#include "frontend/scan/scanner.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <string>

#include "tests/unit/frontend/text_side.hpp"

namespace fagorc::frontend {
namespace {

using program::Quantity;
using program::Token;

struct Scanned {
    std::string key;
    std::vector<Quantity> slots;
    std::vector<std::string> texts;  ///< the bytes of each slot
    Scanner::Extent extent;
    std::vector<double> values() const {
        std::vector<double> v;
        for (const Quantity& q : slots) v.push_back(q.value);
        return v;
    }
};

Scanned scan(const std::string& block) {
    static const Scanner scanner(lathe());
    static Scan room(lathe().limits.block_bytes);
    const std::string text = block + "\n";
    Scanned s;
    s.extent = scanner.scan(text.c_str(), room);
    s.key = readable_key(room.key(), lathe());
    s.slots.assign(room.slots(), room.slots() + room.slot_count());
    for (const Quantity& q : s.slots) s.texts.push_back(text.substr(q.at, q.length));

    if (s.extent.too_long) return s;  // its shape is worth nothing

    // The second listener tells the same tokens, each at its own bytes.
    std::string key = room.key().starts_with(static_cast<char>(Token::lower_case)) ? "l" : "";
    std::size_t end = 0;
    for (const program::PlacedToken& t : scanner.tokens(text.c_str(), room)) {
        key += static_cast<char>(t.kind);
        if (program::has_payload(t.kind)) key.append({static_cast<char>(t.payload), static_cast<char>(t.payload >> 8)});
        EXPECT_GE(t.at, end) << block;
        end = t.at + t.length;
        EXPECT_LE(end, block.size()) << block;
    }
    EXPECT_EQ(key, room.key()) << block;
    return s;
}

std::string key(const std::string& block) {
    return scan(block).key;
}
std::vector<double> values(const std::string& block) {
    return scan(block).values();
}
using Values = std::vector<double>;

TEST(Scanner, WordsAreLettersAndQuantities) {
    const Scanned s = scan("N10 G1 X12.5 Z-3 F200 S1000 T2.2 D2 M3");
    EXPECT_EQ(s.key, "N # G1 X # Z # F # S # T # D # M3");
    EXPECT_EQ(s.values(), (Values{10, 12.5, -3, 200, 1000, 2.2, 2}));
    EXPECT_EQ(s.texts, (std::vector<std::string>{"10", "12.5", "-3", "200", "1000", "2.2", "2"}));
}

TEST(Scanner, BlanksMeanNothing) {
    EXPECT_EQ(key("G53X10YP202F800"), key(" G 5 3 X 1 0\tY P 2 0 2 F 8 0 0 "));
    EXPECT_EQ(values("X 3 0"), Values{30});
    EXPECT_EQ(values("X 3 . 2 5 Z - 1"), (Values{3.25, -1}));
    EXPECT_EQ(key("G 0 4 K 5"), "G4 K #");
    EXPECT_EQ(key("M19 S -30"), key("M19S-30"));
    EXPECT_EQ(values("M19 S -30"), Values{-30});
    EXPECT_EQ(key(std::string("G1\0X1\0", 6)), "G1 X #");  // NUL fills up paper tape
    EXPECT_EQ(key(""), "");
    EXPECT_EQ(key(" \t "), "");
}

TEST(Scanner, NumbersHavePointsAnywhereAndSigns) {
    EXPECT_EQ(values("X100. Z.5 I+7 K-.25"), (Values{100, 0.5, 7, -0.25}));
    EXPECT_EQ(scan("X100. Z.5 I+7 K-.25").key, "X # Z # I # K #");
    EXPECT_EQ(values("X-0"), Values{0});
    EXPECT_FALSE(std::signbit(values("X-0").front()));
    EXPECT_EQ(key("X.").back(), '!');  // a point alone is no number
    EXPECT_EQ(scan("X-.").texts, std::vector<std::string>{"-."});
    EXPECT_EQ(key("X1.2.3"), "X # #");
}

TEST(Scanner, DigitsAreCounted) {
    const auto digits = [](const std::string& block) {
        const Quantity q = scan(block).slots.at(0);
        return std::pair<int, int>(q.integer_digits, q.decimals);
    };
    EXPECT_EQ(digits("X12345.6789"), std::pair(5, 4));
    EXPECT_EQ(digits("X0001.50"), std::pair(1, 2));  // leading zeros are no digits of the format
    EXPECT_EQ(digits("X0.00001"), std::pair(0, 5));
    EXPECT_EQ(digits("X.5"), std::pair(0, 1));
    EXPECT_EQ(digits("X5."), std::pair(1, 0));
    EXPECT_EQ(digits("X" + std::string(300, '9')), std::pair(255, 0));
    EXPECT_EQ(digits("X." + std::string(300, '0')), std::pair(0, 127));
}

TEST(Scanner, CodesNameSomethingAndStayInTheKey) {
    EXPECT_EQ(key("G01 G90 M08"), "G1 G90 M8");
    EXPECT_EQ(key("G"), "G0");
    EXPECT_EQ(key("GX10"), "G0 X #");
    EXPECT_EQ(key("M"), "M0");
    EXPECT_EQ(key("M;stop"), "M0");
    EXPECT_EQ(key("G04K"), "G4 K");
    EXPECT_EQ(key("GP1"), "G P #");  // bound when the parameter is known
    EXPECT_EQ(key("G P1 X2"), "G P # X #");
    EXPECT_EQ(key("MP10"), "M P #");
    EXPECT_EQ(key("G99999999"), "G65535");  // beyond every table
}

TEST(Scanner, ParametersStandForNumbers) {
    EXPECT_EQ(key("XP3"), "X P #");
    EXPECT_EQ(key("X P3"), "X P #");
    EXPECT_EQ(key("X-P3"), "X - P #");
    EXPECT_EQ(key("X - P3"), "X - P #");
    EXPECT_EQ(values("X-P3"), Values{3});
    EXPECT_EQ(key("G180 P2=3 A-1"), "G180 P # = # A #");
}

TEST(Scanner, HeaderAndEndOfABlock) {
    EXPECT_EQ(key("/ N5 X1"), "/1 N # X #");
    EXPECT_EQ(key("/1/2/3N0010X1"), "/1 /2 /3 N # X #");
    EXPECT_EQ(values("N0010"), Values{10});
    EXPECT_EQ(key("N30 (RPT N10, N20) N3"), "N # ( RPT N # , N # ) N #");
    EXPECT_EQ(key("X1 ; then Y2 (\"P3\")"), "X #");
    EXPECT_EQ(key("; a remark"), "");
    EXPECT_EQ(key("N600;"), "N #");
    EXPECT_EQ(key("%"), "%");
    EXPECT_EQ(key("% anything, \"at all"), "%");
}

TEST(Scanner, WordsOfTheHighLevelAreFoundByLongestPrefix) {
    EXPECT_EQ(key("(P8EQ12.8)"), "( P # EQ # )");
    EXPECT_EQ(key("(P1=ASINX)"), "( P # = ASINX )");
    EXPECT_EQ(key("(P1=ASIN X)"), "( P # = ASIN X )");
    EXPECT_EQ(key("(P1=ASINS)"), "( P # = ASINS )");
    EXPECT_EQ(key("(LL9505)"), "( LL # )");
    EXPECT_EQ(key("(LSUB9505)"), "( LSUB # )");
    EXPECT_EQ(key("(CALL3)"), "( CALL # )");
    EXPECT_EQ(key("(P1=ORGX54)"), "( P # = ORGX # )");
    EXPECT_EQ(key("(P1=ORGX 54)"), key("(P1=ORGX54)"));
    EXPECT_EQ(key("(DWH2=1,DWB3=2,DW1=3)"), "( DWH # = # , DWB # = # , DW # = # )");
    EXPECT_EQ(key("(P1=PLCMSG,P2=PLCMM1,P3=PLCM1)"), "( P # = PLCMSG , P # = PLCMM # , P # = PLCM # )");
    EXPECT_EQ(key("(IF(P1GEP2)GOTON60ELSEGOTON70)"), "( IF ( P # GE P # ) GOTO N # ELSE GOTO N # )");
    EXPECT_EQ(key("(IFAEQBM10)"), "( IF A EQ B M # )");  // letters are local parameters: M10 assigns
    EXPECT_EQ(key("(P100=P(P8+SIN(P8*20)))"), "( P # = P ( P # + SIN ( P # * # ) ) )");
    EXPECT_EQ(key("(P1=P2/-3)"), "( P # = P # / - # )");
    EXPECT_EQ(key("(EXEC P1,DNC2)"), "( EXEC P # , DNC2 )");
}

TEST(Scanner, LettersOfAnIsoBlockAreNoWords) {
    EXPECT_EQ(key("IF1"), "I F #");
    EXPECT_EQ(key("(RET)G1"), "( RET ) G1");
}

TEST(Scanner, HexadecimalConstantsBelongToTheHighLevel) {
    const Scanned s = scan("(TIMER=$5F5E100)");
    EXPECT_EQ(s.values(), Values{100000000});
    EXPECT_EQ(s.slots[0].hexadecimal, 1);
    EXPECT_EQ(values("(P1=$FFFFFFFF)"), (Values{1, 4294967295.0}));
    EXPECT_EQ(key("(IF P1 AND $FC00 GOTO N1)"), "( IF P # AND # GOTO N # )");
    EXPECT_EQ(values("(P1=$123456789)"), (Values{1, 0x12345678, 9}));  // eight digits and no more
    EXPECT_EQ(values("(P1=$fc)"), (Values{1, 0xfc}));
    EXPECT_EQ(key("(P1=$fc)").front(), 'l');
    EXPECT_EQ(key("(P1=$)"), "( P # = ! )");
    EXPECT_EQ(key("X$10"), "X ! #");  // 8055 T 11.3: not in an ISO block
}

TEST(Scanner, TextsHoldAnything) {
    const Scanned s = scan("(MSG \"a;b)c(d, l'été\")");
    EXPECT_EQ(s.key, "( MSG $ )");
    EXPECT_EQ(s.texts, std::vector<std::string>{"a;b)c(d, l'été"});
    EXPECT_EQ(scan("(ERROR 5,\"\")").texts, (std::vector<std::string>{"5", ""}));
    EXPECT_EQ(key("(MSG \"open)"), "( MSG !");
    EXPECT_EQ(scan("(MSG \"open)").texts, std::vector<std::string>{"\"open)"});
}

TEST(Scanner, WriteTakesTheRestOfItsBlock) {
    EXPECT_EQ(scan("(WRITE N10 G1 X$P1 ;(a) \"b)\" )").texts, std::vector<std::string>{"N10 G1 X$P1 ;(a) \"b)\" "});
    EXPECT_EQ(key("(WRITE (P1=SIN(P2))) ; done"), "( WRITE $ )");
    EXPECT_EQ(scan("(WRITE (P1=SIN(P2)))").texts, std::vector<std::string>{"(P1=SIN(P2))"});
    EXPECT_EQ(scan("(WRITE)").texts, std::vector<std::string>{""});
    EXPECT_EQ(key("(WRITE G1 X(2)"), "( WRITE $");  // never closed
}

TEST(Scanner, LowerCaseIsMarkedOutsideTextsAndComments) {
    EXPECT_EQ(key("x-1.9"), "l X #");
    EXPECT_EQ(key("g01 X1"), "l G1 X #");
    EXPECT_EQ(key("(goto N60)"), "l ( GOTO N # )");
    EXPECT_EQ(key("(p1=2)"), "l ( P # = # )");
    EXPECT_EQ(key("(MSG \"abc\")"), "( MSG $ )");
    EXPECT_EQ(key("X1 ;abc"), "X #");
}

TEST(Scanner, StrangeCharactersAreTokensOfTheirOwn) {
    EXPECT_EQ(scan("X\xC2\xA0"
                   "1")
                  .texts,
              (std::vector<std::string>{"\xC2\xA0", "1"}));  // UTF-8 no-break space
    EXPECT_EQ(scan("X\xA0"
                   "1")
                  .texts,
              (std::vector<std::string>{"\xA0", "1"}));  // Latin-1
    EXPECT_EQ(scan("X\xE2\x88\x92"
                   "5")
                  .texts,
              (std::vector<std::string>{"\xE2\x88\x92", "5"}));
    EXPECT_EQ(scan("X\xEF\xBC\x91").texts, std::vector<std::string>{"\xEF\xBC\x91"});  // fullwidth 1
    EXPECT_EQ(scan("X\xE2\x88").texts, (std::vector<std::string>{"\xE2", "\x88"}));    // a cut sequence
    EXPECT_EQ(key("[X1]"), "! X # !");
    EXPECT_EQ(key("#1=2"), "! # = #");
}

TEST(Scanner, BlocksEndAtCrLfOrBoth) {
    static const Scanner scanner(lathe());
    Scan room(lathe().limits.block_bytes);
    const auto extent = [&](const char* text) {
        const Scanner::Extent e = scanner.scan(text, room);
        return std::pair(e.length, e.next);
    };
    EXPECT_EQ(extent("X1\nX2\n"), (std::pair<std::size_t, std::size_t>(2, 3)));
    EXPECT_EQ(extent("X1\rX2\n"), (std::pair<std::size_t, std::size_t>(2, 3)));
    EXPECT_EQ(extent("X1\r\nX2\n"), (std::pair<std::size_t, std::size_t>(2, 4)));
    EXPECT_EQ(extent("X1 ;c\r\nX2\n"), (std::pair<std::size_t, std::size_t>(5, 7)));
    EXPECT_EQ(extent("(MSG \"a\nX2\n"), (std::pair<std::size_t, std::size_t>(7, 8)));
}

TEST(Scanner, TheLimitOfABlockIsExact) {
    const std::size_t limit = lathe().limits.block_bytes;
    for (const char* piece : {"X", "G", "1 ", "(", "\xC3\xA9", "\"\"", ";", " ", "SIN"}) {
        std::string block;
        while (block.size() < limit) block += piece;
        block.resize(limit);
        EXPECT_FALSE(scan(block).extent.too_long) << piece;
        block += "X";
        const Scanned s = scan(block + piece);
        EXPECT_TRUE(s.extent.too_long) << piece;
        EXPECT_EQ(s.extent.next, block.size() + std::string(piece).size() + 1) << piece;
    }
}

// The double nearest to the decimal number, as strtod of the C library rounds it (IEEE 754, to nearest).
TEST(Scanner, ValuesAreRoundedCorrectly) {
    std::mt19937_64 random(8055);
    const auto below = [&](std::uint64_t n) { return random() % n; };
    for (int i = 0; i < 50'000; ++i) {
        std::string digits;
        for (std::uint64_t n = below(i % 4 ? 7 : 25); n > 0; --n) digits += static_cast<char>('0' + below(10));
        digits += '.';
        for (std::uint64_t n = below(i % 4 ? 6 : 40); n > 0; --n) digits += static_cast<char>('0' + below(10));
        if (digits == ".") continue;
        const Scanned s = scan("X" + digits);
        ASSERT_EQ(s.values(), Values{std::strtod(digits.c_str(), nullptr)}) << digits;
        ASSERT_EQ(s.texts.front(), digits);
    }
}

}  // namespace
}  // namespace fagorc::frontend
