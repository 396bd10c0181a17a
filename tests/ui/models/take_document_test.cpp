// SPDX-License-Identifier: Apache-2.0
#include "ui/models/take_document.h"

#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <filesystem>

#include "tests/core/processing/made_take.h"
#include "tests/support/take_files.h"
#include "tests/ui/support/wait.h"

namespace noctule::ui {
namespace {

class TakeDocumentTest : public noctule::test::MadeTake {
protected:
    void SetUp() override {
        MadeTake::SetUp();
        addRuns("first");
        addRuns("second");
        addReference(0.1);
    }

    QString qpath() const { return QString::fromStdString(path()); }
    bool openAndWait() {
        document_.open(qpath());
        return waitFor([this] { return document_.isOpen(); });
    }

    Jobs jobs_;
    TimeCursor time_;
    TakeDocument document_{jobs_, time_};
};

TEST_F(TakeDocumentTest, OpensAndShowsTheNewestRun) {
    QSignalSpy opened(&document_, &TakeDocument::opened);
    ASSERT_TRUE(openAndWait());
    EXPECT_EQ(opened.count(), 1);
    EXPECT_EQ(document_.path(), qpath());
    EXPECT_EQ(document_.shownRun(), 1);
    EXPECT_EQ(document_.comparedRun(), -1);
    EXPECT_DOUBLE_EQ(time_.duration(), 2);
    EXPECT_TRUE(document_.problem().isEmpty());
}

TEST_F(TakeDocumentTest, PartsComeWhenAskedForAndStayTheSame) {
    ASSERT_TRUE(openAndWait());
    EXPECT_EQ(document_.comparedMotion(), nullptr);
    EXPECT_EQ(document_.shownMotion(), nullptr);
    EXPECT_TRUE(document_.isLoading());
    ASSERT_TRUE(waitFor([this] {
        return document_.shownMotion() && document_.reference() && document_.contacts() &&
               document_.ranges() && document_.pairSummaries() && document_.readings() &&
               document_.report() && document_.verdict();
    }));
    EXPECT_EQ(document_.shownMotion().get(), document_.shownMotion().get());
    EXPECT_EQ(document_.shownMotion()->frames.size(), static_cast<size_t>(noctule::test::kFrames));
    EXPECT_EQ(document_.contacts()->size(), 2u);
    EXPECT_EQ(document_.pairSummaries()->window(0, 0, 0, 2).pulses, noctule::test::kPulses);
    EXPECT_EQ(document_.report()->shownRun()->name, "second");
    EXPECT_TRUE(document_.verdict()->mean_error_deg);
    EXPECT_FALSE(document_.isLoading());
    EXPECT_NEAR(time_.frameStep(), 1 / 140.0, 1e-6);
}

TEST_F(TakeDocumentTest, CurvesComeForPairsReadingsAndJoints) {
    ASSERT_TRUE(openAndWait());
    const CurveChoice arm{"RightArm", "x"};
    QSignalSpy curves(&document_, &TakeDocument::curvesChanged);
    ASSERT_TRUE(waitFor([&] {
        return document_.rangeCurve(0, 0, RangeQuantity::kConfidence) && document_.readingCurve(1, 3) &&
               document_.motionCurve(arm) && document_.motionCurve(arm, TakeDocument::Whose::kReference);
    }));
    EXPECT_GE(curves.count(), 4);
    EXPECT_EQ(document_.rangeCurve(0, 0, RangeQuantity::kConfidence)->size(),
              static_cast<size_t>(noctule::test::kPulses));
    EXPECT_EQ(document_.motionCurve(arm)->value.size(), static_cast<size_t>(noctule::test::kFrames));
    EXPECT_EQ(document_.rangeCurve(0, 7, RangeQuantity::kConfidence), nullptr);
    EXPECT_EQ(document_.readingCurve(0, 6), nullptr);
    EXPECT_EQ(document_.motionCurve(arm, TakeDocument::Whose::kCompared), nullptr);
}

TEST_F(TakeDocumentTest, SwitchingRunsKeepsWhatIsStillWatched) {
    ASSERT_TRUE(openAndWait());
    ASSERT_TRUE(waitFor([this] { return document_.shownMotion() && document_.ranges(); }));
    const std::weak_ptr<const TimedMotion> second = document_.shownMotion();
    const std::weak_ptr<const RangeTable> ranges = document_.ranges();
    QSignalSpy runs(&document_, &TakeDocument::runsChanged);
    document_.setComparedRun(0);
    EXPECT_EQ(runs.count(), 1);
    document_.setShownRun(0);  // compared with itself is with none
    EXPECT_EQ(document_.comparedRun(), -1);
    EXPECT_EQ(runs.count(), 2);
    EXPECT_TRUE(second.expired());
    EXPECT_TRUE(ranges.expired());
    ASSERT_TRUE(waitFor([this] { return document_.shownMotion() && document_.report(); }));
    EXPECT_EQ(document_.report()->shownRun()->name, "first");
    document_.setComparedRun(TakeDocument::kReference);
    EXPECT_EQ(document_.comparedRun(), TakeDocument::kReference);
    ASSERT_TRUE(waitFor([this] { return document_.comparedMotion() != nullptr; }));
    EXPECT_EQ(document_.comparedMotion(), document_.reference());
    document_.setShownRun(9);
    document_.setComparedRun(9);
    EXPECT_EQ(document_.shownRun(), 0);
    EXPECT_EQ(document_.comparedRun(), TakeDocument::kReference);
}

TEST_F(TakeDocumentTest, ReloadShowsTheNewRunAndKeepsTheOthersParts) {
    ASSERT_TRUE(openAndWait());
    ASSERT_TRUE(waitFor([this] { return document_.shownMotion() && document_.reference(); }));
    const auto second = document_.shownMotion(), reference = document_.reference();
    addRuns("third");
    document_.reload(false);
    ASSERT_TRUE(waitFor([this] { return document_.overview()->runs.size() == 3; }));
    EXPECT_EQ(document_.shownRun(), 1);
    EXPECT_EQ(document_.shownMotion(), second);
    EXPECT_NE(document_.reference(), reference);  // may have been another one
    time_.setRange(0.5, 1);
    addRuns("fourth");
    document_.reload(true);
    ASSERT_TRUE(waitFor([this] { return document_.overview()->runs.size() == 4; }));
    EXPECT_EQ(document_.shownRun(), 3);
    EXPECT_EQ(time_.in(), 0.5);
}

TEST_F(TakeDocumentTest, AnotherTakeWhileLoadingTakesItsPlace) {
    const std::string other = file("other_001.noctule");
    std::filesystem::copy_file(path(), other);
    QSignalSpy opened(&document_, &TakeDocument::opened);
    document_.open(qpath());
    document_.open(QString::fromStdString(other));
    ASSERT_TRUE(waitFor([this] { return document_.isOpen(); }));
    QTest::qWait(100);
    EXPECT_EQ(opened.count(), 1);
    EXPECT_EQ(document_.overview()->path, other);

    QSignalSpy motion(&document_, &TakeDocument::motionChanged);
    document_.shownMotion();
    document_.open(qpath());
    EXPECT_FALSE(document_.isOpen());
    ASSERT_TRUE(waitFor([this] { return document_.isOpen(); }));
    QTest::qWait(100);
    EXPECT_EQ(motion.count(), 0);  // nobody asked this take for its motion
    EXPECT_EQ(document_.overview()->path, path());
}

TEST_F(TakeDocumentTest, WhatCannotBeReadIsSaid) {
    QSignalSpy failed(&document_, &TakeDocument::failed);
    document_.open(QString::fromStdString(file("none.noctule")));
    ASSERT_TRUE(waitFor([&] { return failed.count() == 1; }));
    EXPECT_FALSE(document_.isOpen());
    EXPECT_TRUE(document_.path().isEmpty());

    ASSERT_TRUE(openAndWait());
    {
        const auto database = Database::open(path(), Access::kReadWrite);
        ASSERT_TRUE(database);
        ASSERT_TRUE(database->execute("DELETE FROM pose"));
    }
    QSignalSpy motion(&document_, &TakeDocument::motionChanged);
    document_.shownMotion();
    ASSERT_TRUE(waitFor([&] { return motion.count() == 1; }));
    EXPECT_EQ(document_.shownMotion(), nullptr);
    EXPECT_FALSE(document_.problem().isEmpty());
    QTest::qWait(50);
    EXPECT_EQ(motion.count(), 1);  // a failure is not tried again and again
}

TEST_F(TakeDocumentTest, APartThatIsTornMakesTheTakeDamaged) {
    noctule::test::damageRowsOf(path(), "pose");
    ASSERT_TRUE(openAndWait());
    EXPECT_FALSE(document_.isDamaged()) << "nobody has looked there yet";
    QSignalSpy torn(&document_, &TakeDocument::torn);
    document_.shownMotion();
    ASSERT_TRUE(waitFor([&] { return torn.count() == 1; }));
    EXPECT_TRUE(document_.isDamaged());
    EXPECT_EQ(torn[0][0].toString(), qpath());
    document_.close();
    EXPECT_FALSE(document_.isDamaged());
}

TEST_F(TakeDocumentTest, DamageIsFoundWhileTheTakeIsOpened) {
    noctule::test::damageRowsOf(path(), "marker");
    QSignalSpy torn(&document_, &TakeDocument::torn);
    ASSERT_TRUE(openAndWait());
    EXPECT_TRUE(document_.isDamaged());
    EXPECT_EQ(torn.count(), 1);
}

TEST_F(TakeDocumentTest, AMendedTakeIsNoLongerDamaged) {
    const QByteArray whole = [this] {
        QFile taken(qpath());
        return taken.open(QFile::ReadOnly) ? taken.readAll() : QByteArray();
    }();
    noctule::test::damageRowsOf(path(), "marker");
    ASSERT_TRUE(openAndWait());
    ASSERT_TRUE(document_.isDamaged());
    const auto reload = [this] {
        QSignalSpy opened(&document_, &TakeDocument::opened);
        document_.reload(false);
        return waitFor([&] { return opened.count() == 1; });
    };
    ASSERT_TRUE(reload());
    EXPECT_TRUE(document_.isDamaged()) << "it still is";
    QFile mended(qpath());
    ASSERT_TRUE(mended.open(QFile::WriteOnly | QFile::Truncate));
    ASSERT_EQ(mended.write(whole), whole.size());
    mended.close();
    ASSERT_TRUE(reload());
    EXPECT_FALSE(document_.isDamaged());
}

TEST_F(TakeDocumentTest, DamageOfAnotherTakeIsToldOnly) {
    ASSERT_TRUE(openAndWait());
    QSignalSpy torn(&document_, &TakeDocument::torn);
    document_.noteDamage("other.noctule", {ErrorKind::kUnreadable, "other: the file is damaged", "", true});
    EXPECT_EQ(torn.count(), 1);
    EXPECT_FALSE(document_.isDamaged());
}

TEST_F(TakeDocumentTest, ClosingForgets) {
    ASSERT_TRUE(openAndWait());
    ASSERT_TRUE(waitFor([this] { return document_.shownMotion() != nullptr; }));
    const std::weak_ptr<const TimedMotion> motion = document_.shownMotion();
    QSignalSpy opened(&document_, &TakeDocument::opened);
    document_.close();
    EXPECT_EQ(opened.count(), 1);
    EXPECT_TRUE(motion.expired());
    EXPECT_EQ(document_.shownMotion(), nullptr);
    EXPECT_EQ(time_.duration(), 0);
    document_.close();
    document_.reload(true);
    EXPECT_EQ(opened.count(), 1);
}

TEST_F(TakeDocumentTest, CanGoWhileItLoads) {
    auto document = std::make_unique<TakeDocument>(jobs_, time_);
    document->open(qpath());
    ASSERT_TRUE(waitFor([&] { return document->isOpen(); }));
    document->ranges();
    document->readings();
    document.reset();
    EXPECT_TRUE(waitFor([this] { return jobs_.running() == 0; }));
}

}  // namespace
}  // namespace noctule::ui
