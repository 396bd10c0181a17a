// SPDX-License-Identifier: Apache-2.0
// A calibration outlives its session: kept by the serial number of the box, taken when the box is connected
// to a session without one, imported and exported.
#include "ui/models/suit_memory.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "core/job/atomic_file.h"
#include "core/processing/outside_files.h"
#include "tests/devices/support/test_box.h"
#include "tests/ui/support/wait.h"
#include "ui/models/studio.h"

namespace noctule::ui {
namespace {

using noctule::test::TestBox;

/// Of the tiny take's suit, as its own calibration would be after all wizards.
Calibration calibratedOn(const std::string& date_utc) {
    const Take take = std::move(Take::open(noctule::test::kTinyTake).value());
    Calibration calibration = take.calibrationInForce()->value;
    calibration.created_utc = date_utc;
    for (SourceCalibration& source : calibration.sources)
        source.made["sources"] = {date_utc, "good"};
    for (BoardCalibration& board : calibration.boards) {
        for (const char* task : {"accelerometers", "gyroscopes", "rest-pose"})
            board.made[task] = {date_utc, "good"};
        board.q_segment_board = Quaterniond(0.5, 0.5, 0.5, 0.5);
    }
    return calibration;
}

class SuitMemoryTest : public testing::Test {
protected:
    void SetUp() override {
        QSettings().clear();
        QSettings().setValue("folders/suits", folder_.filePath("suits"));
        start();
    }
    void start() {
        studio_.reset();
        studio_ = std::make_unique<Studio>(
            StudioParts{"test", [] { return std::string("2026-03-01T10:00:00Z"); }, {}, {}});
    }
    void openSession(const QString& name) {
        ASSERT_TRUE(studio_->session().create(folder_.filePath(name), name));
        ASSERT_TRUE(waitFor([&] { return studio_->session().isOpen(); }));
    }
    bool connectTo(const TestBox& box) {
        studio_->suit().connectTo(QString::fromStdString(box.address()));
        return waitFor([&] { return studio_->suit().phase() == LiveSuit::Phase::kLooking; });
    }
    QString fileOf(const Calibration& calibration) {
        const QString path = folder_.filePath("laboratory.json");
        EXPECT_TRUE(writeFileAtomically(path.toStdString(), toJson(calibration).dump(), true));
        return path;
    }
    CalibrationLack lack() {
        return lackOf(studio_->suit().suit(), studio_->calibrations().inForce().value_or(Calibration{}));
    }

    QTemporaryDir folder_;
    std::unique_ptr<Studio> studio_;
};

TEST_F(SuitMemoryTest, KeepsSensorsAndForgetsTheWearing) {
    const SuitMemory memory(folder_.filePath("kept"));
    EXPECT_FALSE(memory.latest("NB-1"));
    ASSERT_TRUE(memory.keep("NB-1", calibratedOn("2026-02-01T10:00:00Z")));
    ASSERT_TRUE(memory.keep("NB-1", calibratedOn("2026-01-01T10:00:00Z")));
    ASSERT_TRUE(memory.keep("NB-1", Calibration{}));
    const auto latest = memory.latest("NB-1");
    ASSERT_TRUE(latest);
    EXPECT_EQ(latest->created_utc, "2026-02-01T10:00:00Z") << "whichever was kept last";
    EXPECT_FALSE(latest->boards[0].q_segment_board);
    EXPECT_TRUE(latest->boards[0].made.contains("gyroscopes"));
    EXPECT_FALSE(memory.latest("NB-2"));
    EXPECT_FALSE(memory.latest(""));
    ASSERT_TRUE(memory.keep("../odd serial", calibratedOn("2026-02-01T10:00:00Z")));
    EXPECT_TRUE(memory.latest("../odd serial"));
    EXPECT_FALSE(QFile::exists(folder_.filePath("odd serial"))) << "it stays in its folder";
    QFile broken(folder_.filePath("kept/NB-1/2027-01-01.json"));
    ASSERT_TRUE(broken.open(QFile::WriteOnly));
    broken.write("{");
    broken.close();
    EXPECT_TRUE(memory.latest("NB-1")) << "a damaged file does not hide the others";
}

TEST_F(SuitMemoryTest, ANewSessionKnowsTheSuitAndNotTheRestPose) {
    TestBox box({.loops = true});
    openSession("first");
    ASSERT_TRUE(connectTo(box));
    EXPECT_TRUE(lack().isTotal());
    EXPECT_EQ(studio_->calibrations().importFile(fileOf(calibratedOn("2026-02-01T10:00:00Z"))), "");
    EXPECT_TRUE(lack().isNone());
    EXPECT_FALSE(studio_->calibrations().remembered());

    QSignalSpy said(studio_.get(), &Studio::said);
    openSession("second");
    ASSERT_TRUE(waitFor([&] { return studio_->calibrations().remembered().has_value(); }));
    EXPECT_EQ(lackInWords(lack()), "rest pose") << "that belongs to a wearing";
    ASSERT_FALSE(said.isEmpty());
    EXPECT_TRUE(said.back()[0].toString().contains("NB-000777")) << said.back()[0].toString().toStdString();

    start();
    openSession("third, another day");
    ASSERT_TRUE(connectTo(box));
    ASSERT_TRUE(waitFor([&] { return studio_->calibrations().remembered().has_value(); }));
    EXPECT_EQ(lackInWords(lack()), "rest pose");
    studio_->suit().disconnectSuit();
    EXPECT_FALSE(studio_->calibrations().remembered());
}

TEST_F(SuitMemoryTest, WhatWasUndoneDoesNotComeBackFromTheMemory) {
    TestBox box({.loops = true});
    openSession("first");
    ASSERT_EQ(studio_->calibrations().importFile(fileOf(calibratedOn("2026-01-01T10:00:00Z"))), "");
    openSession("second");
    ASSERT_TRUE(connectTo(box));
    EXPECT_TRUE(lack().isTotal()) << "nothing was connected when the first was imported";
    ASSERT_EQ(studio_->calibrations().importFile(fileOf(calibratedOn("2026-02-01T10:00:00Z"))), "");
    EXPECT_TRUE(lack().isNone());
    studio_->session().undoStack().undo();
    EXPECT_TRUE(lack().isTotal());
    EXPECT_FALSE(studio_->calibrations().remembered());
    studio_->session().undoStack().redo();
    EXPECT_TRUE(lack().isNone());
}

TEST_F(SuitMemoryTest, NewerValuesOfAnotherSessionAreOfferedNotForced) {
    TestBox box({.loops = true});
    openSession("first");
    ASSERT_TRUE(connectTo(box));
    ASSERT_EQ(studio_->calibrations().importFile(fileOf(calibratedOn("2026-01-01T10:00:00Z"))), "");
    openSession("second");
    ASSERT_EQ(studio_->calibrations().importFile(fileOf(calibratedOn("2026-02-01T10:00:00Z"))), "");
    studio_->session().open(folder_.filePath("first"));
    ASSERT_TRUE(waitFor([&] { return studio_->calibrations().newer().has_value(); }));
    EXPECT_EQ(studio_->calibrations().inForce()->created_utc, "2026-01-01T10:00:00Z");
    EXPECT_EQ(studio_->calibrations().useNewer(), "");
    const Calibration now = studio_->calibrations().inForce().value();
    EXPECT_EQ(now.boards[0].made.at("gyroscopes").created_utc, "2026-02-01T10:00:00Z");
    EXPECT_EQ(now.boards[0].made.at("rest-pose").created_utc, "2026-01-01T10:00:00Z");
    EXPECT_FALSE(studio_->calibrations().newer());
}

TEST_F(SuitMemoryTest, FilesComeAndGo) {
    openSession("first");
    const QString out = folder_.filePath("out.json");
    EXPECT_NE(studio_->calibrations().exportFile(out), "") << "there is nothing yet";
    EXPECT_FALSE(QFile::exists(out));
    const Calibration calibration = calibratedOn("2026-02-01T10:00:00Z");
    ASSERT_EQ(studio_->calibrations().importFile(fileOf(calibration)), "");
    EXPECT_EQ(studio_->calibrations().exportFile(out), "");
    const auto read = readCalibrationFile(out.toStdString());
    ASSERT_TRUE(read);
    EXPECT_EQ(toJson(*read), toJson(calibration));
    studio_->session().undoStack().undo();
    EXPECT_EQ(studio_->calibrations().fileInForce(), "");

    TestBox box({.loops = true});
    ASSERT_TRUE(connectTo(box));
    Calibration foreign = calibration;
    for (BoardCalibration& board : foreign.boards)
        board.id += "_of_another_suit";
    EXPECT_TRUE(studio_->calibrations().importFile(fileOf(foreign)).contains("knows none of the boards"));
    EXPECT_EQ(studio_->calibrations().fileInForce(), "");
    QFile broken(folder_.filePath("broken.json"));
    ASSERT_TRUE(broken.open(QFile::WriteOnly));
    broken.write("{\"format\": 3");
    broken.close();
    EXPECT_TRUE(studio_->calibrations().importFile(broken.fileName()).contains("broken.json"));
}

TEST_F(SuitMemoryTest, FilesOfAnotherSuitAreToldAndNotRememberedForThisOne) {
    TestBox box({.loops = true});
    openSession("first");
    ASSERT_TRUE(connectTo(box));
    Calibration unknown = calibratedOn("2026-01-01T10:00:00Z"), other = calibratedOn("2026-02-01T10:00:00Z");
    EXPECT_EQ(studio_->calibrations().otherSuitOf(fileOf(unknown)), "") << "of an older program";
    ASSERT_EQ(studio_->calibrations().importFile(fileOf(unknown)), "");
    const QString file_of_unknown = studio_->calibrations().fileInForce();
    other.box_serial = "NB-000001";
    EXPECT_EQ(studio_->calibrations().otherSuitOf(fileOf(other)), "NB-000001");
    QSignalSpy warned(&studio_->calibrations(), &CalibrationShelf::warned);
    ASSERT_EQ(studio_->calibrations().importFile(fileOf(other)), "") << "the operator has decided";
    EXPECT_EQ(studio_->calibrations().inForce()->box_serial, "NB-000001");
    ASSERT_EQ(warned.count(), 1);
    EXPECT_TRUE(warned[0][0].toString().contains("was made for another suit, NB-000001"))
        << warned[0][0].toString().toStdString();
    const auto kept = SuitMemory(folder_.filePath("suits")).latest("NB-000777");
    ASSERT_TRUE(kept);
    EXPECT_EQ(kept->created_utc, unknown.created_utc);

    studio_->calibrations().use(file_of_unknown, "back");
    ASSERT_EQ(studio_->calibrations().all().size(), 2u);
    for (const ShelvedCalibration& shelved : studio_->calibrations().all())
        EXPECT_EQ(studio_->calibrations().isOfAnotherSuit(shelved), shelved.file != file_of_unknown);
}

TEST_F(SuitMemoryTest, TheCalibrationOfTheSessionStaysWithItsSuit) {
    const TestBox practised({.loops = true, .serial = "NB-900001"}), worn({.loops = true});
    openSession("first");
    ASSERT_TRUE(connectTo(practised));
    CalibrationResult found;
    found.calibration = calibratedOn("2026-02-01T10:00:00Z");
    ASSERT_EQ(studio_->calibrations().save(found, "rest-pose"), "");
    const QString file = studio_->calibrations().fileInForce();
    const auto is_given = [&] {
        const auto& given = studio_->suit().calibration();
        return given && given->created_utc == found.calibration.created_utc;
    };
    EXPECT_TRUE(is_given());

    QSignalSpy warned(&studio_->calibrations(), &CalibrationShelf::warned);
    ASSERT_TRUE(connectTo(worn));
    EXPECT_FALSE(is_given());
    EXPECT_FALSE(studio_->calibrations().inForce());
    EXPECT_EQ(warned.count(), 0);
    studio_->calibrations().use(file, "all the same");
    EXPECT_TRUE(is_given()) << "the operator has decided";
    studio_->session().undoStack().undo();
    EXPECT_FALSE(is_given());

    ASSERT_TRUE(connectTo(practised));
    EXPECT_TRUE(is_given()) << "it is this suit's";
}

TEST_F(SuitMemoryTest, WhatIsSavedOrExportedNamesItsBox) {
    TestBox box({.loops = true});
    openSession("first");
    ASSERT_TRUE(connectTo(box));
    studio_->suit().setCalibration(calibratedOn("2026-02-01T10:00:00Z"));
    const QString out = folder_.filePath("out.json");
    ASSERT_EQ(studio_->calibrations().exportFile(out), "");
    EXPECT_EQ(readCalibrationFile(out.toStdString())->box_serial, "NB-000777");
    CalibrationResult found;
    found.calibration = calibratedOn("2026-03-01T10:00:00Z");
    ASSERT_EQ(studio_->calibrations().save(found, "gyroscopes"), "");
    EXPECT_EQ(studio_->calibrations().inForce()->box_serial, "NB-000777");
}

TEST_F(SuitMemoryTest, ACalibrationIsPutAsideAndComesBackWithItsReport) {
    openSession("aside");
    CalibrationShelf& shelf = studio_->calibrations();
    CalibrationResult found;
    found.calibration = calibratedOn("2026-03-01T09:00:00Z");
    ASSERT_EQ(shelf.save(found, "gyroscopes"), "");
    ASSERT_EQ(shelf.save(found, "sources"), "");
    const QString in_use = shelf.fileInForce();
    QString other;
    for (const ShelvedCalibration& one : shelf.all())
        if (one.file != in_use)
            other = one.file;
    SessionModel& session = studio_->session();
    const QDir folder(QString::fromStdString(session.session().calibrationFolder().string()));
    const QDir aside(folder.filePath("put aside"));
    const QString report = QString(other).replace(".json", ".html");
    const auto expectAside = [&](bool is_aside) {
        EXPECT_EQ(shelf.all().size(), is_aside ? 1u : 2u);
        for (const QString& name : {other, report}) {
            EXPECT_EQ(folder.exists(name), !is_aside) << name.toStdString();
            EXPECT_EQ(aside.exists(name), is_aside) << name.toStdString();
        }
    };
    session.open(QString::fromStdString(session.session().folder.string()));  // it is of an earlier opening
    ASSERT_TRUE(waitFor([&] { return session.isOpen() && session.undoStack().count() == 0; }));
    EXPECT_EQ(session.whyNotAside(other), "");
    EXPECT_TRUE(session.putCalibrationAside(other));
    expectAside(true);
    EXPECT_NE(shelf.nextName("gyroscopes") + ".json", other) << "its name stays its own";
    EXPECT_FALSE(shelf.nextName(QString(300, 'x')).isEmpty()) << "longer than a file's name may be";
    session.undoStack().undo();
    expectAside(false);
    session.undoStack().redo();
    expectAside(true);

    QSignalSpy failed(&session, &SessionModel::failed);
    const int steps = session.undoStack().count();
    EXPECT_FALSE(session.whyNotAside(in_use).isEmpty());
    EXPECT_FALSE(session.putCalibrationAside(in_use));
    ASSERT_EQ(failed.count(), 1);
    EXPECT_TRUE(failed[0][0].toString().contains("Use another calibration")) << "what to do instead";
    EXPECT_EQ(session.undoStack().count(), steps);
    EXPECT_TRUE(folder.exists(in_use));
}

TEST_F(SuitMemoryTest, ACalibrationThatIsGoneIsNotPutAside) {
    openSession("gone");
    SessionModel& session = studio_->session();
    QSignalSpy failed(&session, &SessionModel::failed);
    EXPECT_FALSE(session.putCalibrationAside("gyroscopes-2026-03-01.json"));
    EXPECT_EQ(failed.count(), 1);
    EXPECT_EQ(session.undoStack().count(), 0);
    EXPECT_FALSE(std::filesystem::exists(session.session().asideFolder())) << "nothing is made for it";
}

}  // namespace
}  // namespace noctule::ui
