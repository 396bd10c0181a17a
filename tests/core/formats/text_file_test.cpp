// SPDX-License-Identifier: Apache-2.0
// Text as spreadsheets and other systems write it: UTF-16, decimal commas, other units of time. The inputs of
// the field lie beside the repository (../shared/data/field); their test skips without them.
#include "core/formats/text_file.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/formats/bvh.h"
#include "core/formats/positions_csv.h"
#include "core/job/atomic_file.h"

namespace noctule::test {
namespace {

const std::string kField = NOCTULE_SOURCE_DIR "/../shared/data/field/";

std::string utf16(const std::u16string& text, bool big, bool mark) {
    std::string bytes;
    for (const char16_t unit : (mark ? u"\xFEFF" : u"") + text) {
        const char high = static_cast<char>(unit >> 8), low = static_cast<char>(unit & 0xFF);
        bytes += big ? high : low;
        bytes += big ? low : high;
    }
    return bytes;
}

std::u16string widened(const std::string& ascii) {
    return {ascii.begin(), ascii.end()};
}

TEST(TextFile, Utf16BecomesUtf8) {
    for (const bool big : {false, true})
        for (const bool mark : {false, true}) {
            EXPECT_EQ(fromUtf16(utf16(u"time_s;\x5DE6\x8155;\xD83D\xDE00", big, mark)),
                      "time_s;\xE5\xB7\xA6\xE8\x85\x95;\xF0\x9F\x98\x80");
            EXPECT_EQ(fromUtf16(utf16(u"lone: \xD83D.", big, mark)), "lone: \xEF\xBF\xBD.");
        }
    EXPECT_FALSE(fromUtf16("HIERARCHY"));
    EXPECT_FALSE(fromUtf16(std::string(100, '\0')));
    EXPECT_FALSE(fromUtf16(""));
}

TEST(TextFile, BvhInUtf16IsTheSameMotion) {
    const std::string text =
        "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\nEnd Site\n{\n"
        "OFFSET 0 10 0\n}\n}\nMOTION\nFrames: 2\nFrame Time: 0.01\n0 1 2\n3 4 5\n";
    const std::vector<double> expected = parseBvh(text, "m.bvh")->values;
    for (const bool big : {false, true})
        for (const bool mark : {false, true}) {
            const auto document = parseBvh(utf16(widened(text), big, mark), "m.bvh");
            ASSERT_TRUE(document) << document.error().text();
            EXPECT_EQ(document->values, expected);
        }
}

TEST(TextFile, TablesInOtherWritings) {
    const char* const rows[] = {
        "time_s;A.x;A.y;A.z\n0;0,25;-1,5;3\n0,5;1;2;3\n",
        "Time [ms]\tA.x\tA.y\tA.z\n0\t0,25\t-1,5\t3\n500\t1\t2\t3\n",
        "\"TIME_MS\",\"A.x\",\"A.y\",\"A.z\"\n\"0\",\"0,25\",\"-1,5\",\"3\"\n\"500\",\"1\",\"2\",\"3\"\n",
        "time_us,A.x,A.y,A.z\r0,0.25,-1.5,3\r500000,1,2,3\r",
        "A.x;A.y;A.z;time (s);note\n0.25;-1.5;3;0;a, b\n1;2;3;0.5;\n"};
    for (const char* text : rows)
        for (const bool wide : {false, true}) {
            const auto table = parsePositionsCsv(wide ? utf16(widened(text), false, true) : text, "t.csv");
            ASSERT_TRUE(table) << text << table.error().text();
            EXPECT_EQ(table->time_s, (std::vector<double>{0, 0.5})) << text;
            EXPECT_EQ(table->at(0, 0), Vector3d(0.25, -1.5, 3)) << text;
        }
}

TEST(TextFile, AmbiguousTablesAreRefused) {
    const auto cut = parsePositionsCsv("time_s,A.x,A.y,A.z\n0,0,1,5,3,25,7\n", "t.csv");
    ASSERT_FALSE(cut);
    EXPECT_NE(cut.error().remedy.find("semicolons"), std::string::npos);
    EXPECT_FALSE(parsePositionsCsv("time,A.x,A.y,A.z\n0,1,2,3\n", "t.csv")) << "no unit";
    EXPECT_FALSE(parsePositionsCsv("time_s,time_ms,A.x,A.y,A.z\n0,0,1,2,3\n", "t.csv")) << "two times";
}

TEST(TextFile, ClocksThatJumpAreCounted) {
    std::string forward = "time_s,A.x,A.y,A.z\n", back = forward;
    for (int i = 0; i < 30; ++i) {
        forward += std::to_string(i * 0.01 + (i >= 10) * 3.0 + (i >= 20) * 60.0) + ",1,2,3\n";
        back += std::to_string((i % 10) * 0.01) + ",1,2,3\n";
    }
    const auto table = parsePositionsCsv(forward, "t.csv");
    ASSERT_TRUE(table);
    ASSERT_EQ(table->warnings.size(), 1u);
    EXPECT_EQ(table->warnings[0], "t.csv: the clock jumps at 2 of 30 rows, first by 3.010 s in line 12.");
    const auto refused = parsePositionsCsv(back, "t.csv");
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("line 12: time_s does not rise (0.000000), nor in 1 other rows"),
              std::string::npos)
        << refused.error().message;
}

TEST(TextFile, EndlessAndLargeInputsEnd) {
    const auto endless = readTextFile("/dev/zero");
    ASSERT_FALSE(endless);
    EXPECT_EQ(endless.error().kind, ErrorKind::kUnreadable);
    EXPECT_NE(endless.error().message.find("more than 256 MB"), std::string::npos);
    const std::string path = testing::TempDir() + "noctule_large.csv";
    ASSERT_TRUE(writeFileAtomically(path, std::string(5000, 'x'), true));
    const ReadOptions options{4999, 0, nullptr};
    EXPECT_FALSE(readWholeFile(path, options));
    EXPECT_EQ(readWholeFile(path)->size(), 5000u);
}

TEST(TextFile, FieldTableInUtf16) {
    if (!std::filesystem::exists(kField + "positions_utf16.csv"))
        GTEST_SKIP() << "needs ../shared/data/field";
    const auto wide = readPositionsCsv(kField + "positions_utf16.csv");
    ASSERT_TRUE(wide) << wide.error().text();
    EXPECT_EQ(wide->joints, (std::vector<std::string>{"Hips", "LeftUpLeg", "RightUpLeg"}));
    EXPECT_EQ(wide->time_s.size(), 60u);
    EXPECT_NEAR(wide->time_s.back(), 2.95, 1e-9);
}

}  // namespace
}  // namespace noctule::test
