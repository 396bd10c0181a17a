// SPDX-License-Identifier: Apache-2.0
// Reading damaged texts: what is whole survives, the rest is named with its line.
#include <cmath>
#include <random>

#include "tests/core/formats/bvh_texts.h"

namespace noctule {
namespace {

using test::changed, test::kSmall, test::parsed;

struct Salvaged {
    std::string text;
    size_t frames, line;
    const char* phrase;
};

TEST(BvhDamage, CompleteRowsSurvive) {
    const Salvaged cases[] = {
        {changed("Frames: 2", "Frames: 3"), 2, 17, "Frames is 3, but 2 complete rows follow"},
        {changed("Frames: 2", "Frames: 1"), 2, 17, "Frames is 1, but 2 complete rows follow"},
        {changed("Frames: 2", "Frames: 1000000000"), 2, 17, "Frames is 1000000000"},
        {changed(" 51 61\n", "\n"), 1, 20, "only 7 of 9 numbers"},
        {changed(" 51 61\n", " 5"), 1, 20, "only 8 of 9 numbers"},
        {changed(" 51 61\n", " -"), 1, 20, "only 7 of 9 numbers"},
        {changed(" 51 61\n", " 5.1e-"), 1, 20, "only 7 of 9 numbers"},
    };
    for (const Salvaged& c : cases) {
        const BvhDocument document = parsed(c.text);
        EXPECT_EQ(document.frameCount(), c.frames);
        ASSERT_FALSE(document.warnings.empty()) << c.phrase;
        EXPECT_EQ(document.warnings[0].line, c.line);
        EXPECT_NE(document.warnings[0].text.find(c.phrase), std::string::npos) << document.warnings[0].text;
        EXPECT_LT(document.values.capacity(), 1000u);
    }
}

struct Damaged {
    std::string text;
    size_t line;
    const char* phrase;
};

TEST(BvhDamage, DamageIsNamedWithItsLine) {
    const Damaged cases[] = {
        {"", 1, "the file ends where HIERARCHY"},
        {"Kaydara FBX Binary", 1, "\"Kaydara\" where HIERARCHY"},
        {changed("ROOT Hips", "ROOT"), 2, "ROOT has no name"},
        {changed("ROOT Hips", "ROOTHips"), 2, "\"ROOTHips\" where ROOT"},
        {changed("OFFSET 0 90 0", "OFFSET0 90 0"), 4, "\"OFFSET0\""},
        {changed("OFFSET 0 90 0", "OFFSET 0 90"), 4, "has 2 of 3 numbers"},
        {changed("OFFSET 0 90 0", "OFFSET 0 90 0 1"), 4, "more than 3 numbers"},
        {changed("OFFSET 0 90 0", "OFFSET 0 nan 0"), 4, "OFFSET of Hips has \"nan\""},
        {changed("  OFFSET 0 90 0\n", ""), 14, "joint Hips has no OFFSET"},
        {changed("CHANNELS 6 X", "CHANNELS 6X"), 5, "\"6Xposition\" CHANNELS"},
        {changed("CHANNELS 6", "CHANNELS 7"), 5, "\"7\" CHANNELS"},
        {changed("CHANNELS 6", "CHANNELS 5"), 5, "\"Yrotation\" where a keyword"},
        {changed("CHANNELS 3", "CHANNELS 4"), 10, "the channel \"End\""},
        {changed("Xposition", "Xscale"), 5, "the channel \"Xscale\""},
        {changed("Xposition", "Yposition"), 5, "Yposition twice"},
        {changed("  OFFSET 0 90 0\n", "  OFFSET 0 90 0\n  CHANNELS 1 Xrotation\n"), 6, "CHANNELS twice"},
        {changed("JOINT Head\n  {", "JOINT Head\n"), 8, "\"OFFSET\" where { should stand"},
        {changed("JOINT Head", "JOINTHead"), 6, "\"JOINTHead\""},
        {changed("      OFFSET 0 20 0\n", ""), 10, "the End Site of Head has no OFFSET"},
        {changed("  }\n}\n", "  }\n"), 15, "MOTION begins inside joint Hips"},
        {changed("  }\n}\n", "  }\n}\n}\n"), 16, "\"}\" where MOTION"},
        {changed("}\nMOTION", "}\nROOT Other\n{\n}\nMOTION"), 16, "a second ROOT \"Other\""},
        {kSmall.substr(0, kSmall.find("    OFFSET 0 60")), 8, "the file ends inside joint Head"},
        {kSmall.substr(0, kSmall.find("MOTION")), 16, "the file ends where MOTION"},
        {changed("Frames: 2", "Frames: -1"), 17, "Frames is \"-1\""},
        {changed("Frames: 2", "Frames: two"), 17, "Frames is \"two\""},
        {changed("Frames: 2\n", ""), 17, "\"Frame\" where Frames"},
        {changed("Frame Time: 0.01", "Frame Time: 0"), 18, "Frame Time is \"0\""},
        {changed("Frame Time: 0.01", "Frame Time: -0.01"), 18, "Frame Time is \"-0.01\""},
        {changed("Frame Time: 0.01", "Frame Time: 120"), 18, "Frame Time is \"120\""},
        {changed("Frame Time: 0.01", "Frame Time: inf"), 18, "Frame Time is \"inf\""},
        {changed("Frame Time: 0.01", "Frame Time: 0,01"), 18, "Frame Time is \"0,01\""},
        {changed("Frame Time: 0.01\n", ""), 18, "\"1\" where Frame"},
        {changed("1 2 3 10", "1 2 nan 10"), 19, "Zposition of Hips (number 3 of the row) is \"nan\""},
        {changed("40 50", "40 -inf"), 19, "Xrotation of Head (number 8 of the row) is \"-inf\""},
        {changed("40 50", "40 1e999"), 19, "is \"1e999\""},
        {changed("40 50", "40 1e30"), 19, "is \"1e30\""},
        {changed("40 50", "40 -1.#IND"), 19, "is \"-1.#IND\""},
        {changed("40 50", "40-50"), 19, "is \"40-50\""},
        {changed("40 50", "40,50"), 19, "is \"40,50\""},
        {changed("40 50", "40 +-50"), 19, "is \"+-50\""},
        {changed("40 50", "40 0x10"), 19, "is \"0x10\""},
        {changed("40 50 60", "40 50"), 19, "has 8 numbers, but the channels add up to 9"},
        {changed("40 50 60", "40 50 60 70"), 19, "more than 9 numbers"},
        {changed("50 60\n4 5 6", "50\n60 4 5 6"), 19, "has 8 numbers"},
        {kSmall.substr(0, kSmall.find("1 2 3 10")), 17, "no complete row follows"},
        {kSmall.substr(0, kSmall.find("20 30 40")), 17, "no complete row follows"},
        {"HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\n}\nMOTION\nFrames: 1\nFrame Time: 1\n0\n", 9,
         "no joint has CHANNELS"},
    };
    for (const Damaged& c : cases) {
        const Result<BvhDocument> failed = parseBvh(c.text, "test.bvh");
        ASSERT_FALSE(failed.ok()) << c.phrase;
        const Error& error = failed.error();
        EXPECT_EQ(error.kind, ErrorKind::kUnreadable);
        EXPECT_EQ(error.message.find("test.bvh, line " + std::to_string(c.line) + ": "), 0u) << error.text();
        EXPECT_NE(error.message.find(c.phrase), std::string::npos) << error.text();
        EXPECT_FALSE(error.remedy.empty());
    }
}

TEST(BvhDamage, WithoutFramesThereIsAFigureButNoClip) {
    const BvhDocument document =
        parsed(changed("Frames: 2", "Frames: 0", kSmall.substr(0, kSmall.find("1 2 3 10"))));
    EXPECT_EQ(document.joints.size(), 2u);
    EXPECT_EQ(toClip(document).error().kind, ErrorKind::kUnusable);
}

TEST(BvhDamage, AMissingFileIsNamed) {
    const Result<BvhDocument> failed = readBvh("/nowhere/walk.bvh");
    ASSERT_FALSE(failed.ok());
    EXPECT_EQ(failed.error().kind, ErrorKind::kUnreadable);
    EXPECT_NE(failed.error().message.find("/nowhere/walk.bvh"), std::string::npos);
}

/// Whatever comes, the answer is an Error with a remedy or a document whose parts fit together.
void expectSound(const std::string& text) {
    const Result<BvhDocument> read = parseBvh(text, "damaged.bvh");
    if (!read) {
        EXPECT_FALSE(read.error().remedy.empty()) << read.error().message;
        return;
    }
    EXPECT_EQ(read->values.size(), read->frameCount() * read->channel_count);
    for (const double v : read->values)
        ASSERT_TRUE(std::isfinite(v));
    const Result<MotionClip> clip = toClip(*read);
    if (clip) {
        for (const Vector3d& p_m : globalPose(*clip, clip->frames.size() - 1).p_world_joint)
            ASSERT_TRUE(p_m.allFinite());
    }
}

TEST(BvhDamage, NoCutAndNoFlippedByteBreaksTheReader) {
    for (size_t length = 0; length <= kSmall.size(); ++length)
        expectSound(kSmall.substr(0, length));
    std::mt19937 random(7);
    for (int n = 0; n < 6000; ++n) {
        std::string text = kSmall;
        for (int flips = 1 + static_cast<int>(random() % 4); flips > 0; --flips)
            text[random() % text.size()] =
                static_cast<char>(n % 2 ? random() : "0123456789 \n{}-+.eE\t:nX"[random() % 24]);
        expectSound(text);
    }
}

}  // namespace
}  // namespace noctule
