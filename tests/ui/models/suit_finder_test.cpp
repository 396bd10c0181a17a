// SPDX-License-Identifier: Apache-2.0
#include "ui/models/suit_finder.h"

#include <gtest/gtest.h>

#include "tests/devices/support/answerer.h"
#include "tests/devices/support/test_box.h"
#include "tests/ui/support/speak.h"
#include "tests/ui/support/wait.h"

namespace noctule::ui {
namespace {

using noctule::test::Answerer;
using noctule::test::testAnnouncement;

class SuitFinderTest : public testing::Test {
protected:
    void SetUp() override { settings_.clear(); }

    QSettings settings_;
};

TEST_F(SuitFinderTest, ABoxHasTheSameNameAndColourAtEveryMeeting) {
    Answerer box(testAnnouncement());
    int colour = -1;
    {
        SuitFinder finder(settings_);
        finder.start({box.port(), false});
        ASSERT_TRUE(waitFor([&] { return finder.suits().size() == 1; }));
        const KnownSuit suit = finder.suits()[0];
        EXPECT_EQ(suit.name, "Blue suit");
        EXPECT_TRUE(suit.present);
        colour = suit.colour;
        EXPECT_GE(colour, 0);
        EXPECT_EQ(finder.at(QString::fromStdString(suit.device.address)), &finder.suits()[0]);
        finder.rename("NB-000777", "Stage left");
        EXPECT_EQ(finder.suits()[0].name, "Stage left");
        auto other = testAnnouncement("NB-000778");
        other.tcp_port = 50124;
        box.announce(other);
        ASSERT_TRUE(waitFor([&] { return finder.suits().size() == 2; }));
        EXPECT_NE(finder.suits()[0].colour, finder.suits()[1].colour);
        box.announce(testAnnouncement());
    }
    SuitFinder finder(settings_);
    finder.start({box.port(), false});
    ASSERT_TRUE(waitFor([&] { return finder.suits().size() == 1; }));
    EXPECT_EQ(finder.suits()[0].name, "Stage left");
    EXPECT_EQ(finder.suits()[0].colour, colour);
    finder.rename("NB-000777", "");
    EXPECT_EQ(finder.suits()[0].name, "Blue suit");
}

TEST_F(SuitFinderTest, TheNameThatABoxGivesItselfIsInTheLanguageOfTheStudio) {
    KnownSuit suit;
    suit.device.serial = "NB-000777";
    suit.name = "Suit NB-000777";
    KnownSuit named = suit;
    named.name = "Suit of Ada";
    EXPECT_EQ(suit.shownName(), "Suit NB-000777");
    test::speak("de");
    EXPECT_EQ(suit.shownName(), "Anzug NB-000777");
    EXPECT_EQ(named.shownName(), "Suit of Ada") << "as the operator calls it";
    EXPECT_EQ(KnownSuit{}.shownName(), "");
    test::speak("en");
}

TEST_F(SuitFinderTest, ABoxOfAnchorsIsKnownAgain) {
    Answerer box(testAnnouncement());
    SuitFinder finder(settings_);
    finder.start({box.port(), false});
    ASSERT_TRUE(waitFor([&] { return finder.suits().size() == 1; }));
    EXPECT_FALSE(finder.suits()[0].is_room);
    finder.remember("NB-000777", true);
    EXPECT_TRUE(finder.suits()[0].is_room);
    finder.remember("NB-000777");
    EXPECT_FALSE(finder.suits()[0].is_room) << "somebody wears it now";
}

TEST_F(SuitFinderTest, OneThatWasConnectedIsShownWhenItIsAway) {
    Answerer box(testAnnouncement());
    {
        SuitFinder finder(settings_);
        finder.start({box.port(), false});
        ASSERT_TRUE(waitFor([&] { return finder.suits().size() == 1; }));
        finder.remember("NB-000777");
        box.answers(false);
        finder.lookAgain();
        ASSERT_EQ(finder.suits().size(), 1u);
        EXPECT_FALSE(finder.suits()[0].present);
        EXPECT_EQ(finder.suits()[0].device.boards, 18);
    }
    SuitFinder finder(settings_);
    ASSERT_EQ(finder.suits().size(), 1u) << "also before it looks";
    EXPECT_EQ(finder.suits()[0].name, "Blue suit");
    finder.forget("NB-000777");
    EXPECT_TRUE(finder.suits().empty());
}

TEST_F(SuitFinderTest, NoneMovesBecauseAnotherOneGoes) {
    Answerer box(testAnnouncement());
    SuitFinder finder(settings_);
    finder.start({box.port(), false});
    ASSERT_TRUE(waitFor([&] { return finder.suits().size() == 1; }));
    finder.remember("NB-000777");
    finder.remember("NB-000778");
    auto other = testAnnouncement("NB-000778");
    other.tcp_port = 50124;
    box.announce(other);
    ASSERT_TRUE(waitFor([&] { return finder.suits().size() == 2 && finder.suits()[1].present; }));
    finder.lookAgain();
    ASSERT_TRUE(waitFor([&] { return finder.suits().size() == 2 && finder.suits()[1].present; }));
    EXPECT_FALSE(finder.suits()[0].present);
    EXPECT_EQ(finder.suits()[0].device.serial, "NB-000777") << "it came first and stays there";
}

TEST_F(SuitFinderTest, AnAddressIsAskedAndAWrongOneSaysWhatIsWrong) {
    const noctule::test::TestBox box({});
    SuitFinder finder(settings_);
    EXPECT_NE(finder.probe("box"), "");
    EXPECT_EQ(finder.probe(QString::fromStdString(box.address())), "");
    const auto contact = [&] {
        const KnownSuit* suit = finder.at(QString::fromStdString(box.address()));
        return suit ? std::optional(suit->device.contact) : std::nullopt;
    };
    ASSERT_TRUE(waitFor([&] { return contact() == FoundDevice::Contact::kAnswers; }));
    EXPECT_EQ(finder.at(QString::fromStdString(box.address()))->device.serial, "NB-000777");
    EXPECT_EQ(finder.probe("tcp://127.0.0.1:9"), "");
    ASSERT_TRUE(waitFor([&] {
        const KnownSuit* suit = finder.at("tcp://127.0.0.1:9");
        return suit && suit->device.contact == FoundDevice::Contact::kSilent;
    }));
    EXPECT_EQ(finder.at("tcp://127.0.0.1:9")->colour, -1);
}

}  // namespace
}  // namespace noctule::ui
