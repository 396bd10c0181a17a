// SPDX-License-Identifier: Apache-2.0
#include "devices/driver_box/discovery.h"

#include "tests/devices/driver_box/link_simulation.h"

namespace noctule::link {
namespace {

TEST(Discovery, TheQuestionIsSixteenBytes) {
    EXPECT_EQ(kDiscoveryQuestion.size(), 16u);
    EXPECT_TRUE(isDiscoveryQuestion(bytesOf("NOCTULE-DISCOVER")));
    EXPECT_FALSE(isDiscoveryQuestion(bytesOf("NOCTULE-DISCOVER\n")));
    EXPECT_FALSE(isDiscoveryQuestion(bytesOf("NOCTULE-DISCOVEr")));
    EXPECT_FALSE(isDiscoveryQuestion({}));
}

TEST(Discovery, AnAnswerIsOneFrame) {
    const auto golden = readAnnouncementDatagram(goldenFrame(Type::kAnnounce).bytes, "lan");
    // The golden frame has its number among others; a box numbers its answer 0, readers do not care.
    ASSERT_TRUE(golden);
    EXPECT_EQ(golden->serial, "NB-000777");
    const Announcement own = announcementOf(testHello("NB-1"), 4242, true);
    EXPECT_EQ(own.boards, 2);
    EXPECT_EQ(own.sources, 1);
    EXPECT_EQ(readAnnouncementDatagram(announcementDatagram(own), "lan"), own);
}

TEST(Discovery, OtherDatagramsAreIgnored) {
    const Bytes good = announcementDatagram(announcementOf(testHello(), 1, false));
    Bytes twice = good, damaged = good, longer = good;
    append(twice, good);
    damaged[40] ^= 1;
    longer.push_back(0);
    for (const Bytes& bytes :
         {twice, damaged, longer, Bytes{}, bytesOf("NOCTULE-DISCOVER"), goldenFrame(Type::kHello).bytes,
          encodeFrame(static_cast<uint8_t>(Type::kAnnounce), 0, bytesOf("{}"))})
        EXPECT_FALSE(readAnnouncementDatagram(bytes, "lan"));
}

}  // namespace
}  // namespace noctule::link
