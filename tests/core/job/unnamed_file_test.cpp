// SPDX-License-Identifier: Apache-2.0
#include "core/job/unnamed_file.h"

#include <gtest/gtest.h>

#include "tests/support/files.h"

namespace noctule {
namespace {

TEST(UnnamedFile, GivesBackWhatWasPutAndLeavesNothing) {
    const test::Folder folder;
    {
        auto file = UnnamedFile::make(folder.path(), "numbers", "").value();
        file.put(1.5);
        const int64_t second = file.position();
        file.put(int64_t{7});
        EXPECT_TRUE(folder.names().empty()) << "nothing is left when the program is killed here";
        ASSERT_TRUE(file.good());
        file.seek(second);
        int64_t seven = 0;
        EXPECT_TRUE(file.take(seven));
        EXPECT_EQ(seven, 7);
        EXPECT_FALSE(file.take(seven)) << "the file has ended";
        file.seek(0);
        double number = 0;
        EXPECT_TRUE(file.take(number));
        EXPECT_EQ(number, 1.5);
    }
    EXPECT_TRUE(folder.names().empty());
}

TEST(UnnamedFile, SaysWhatCannotBeKeptWhere) {
    const auto refused = UnnamedFile::make("/no/such/folder", "live results", "Look there");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kDisk);
    EXPECT_NE(refused.error().message.find("/no/such/folder: live results"), std::string::npos);
    EXPECT_EQ(refused.error().remedy, "Look there");
}

}  // namespace
}  // namespace noctule
