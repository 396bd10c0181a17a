// SPDX-License-Identifier: Apache-2.0
// Another maker's recording from the desktop to a take under review: shown as it was understood, corrected,
// imported.
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QMimeData>
#include <QPushButton>
#include <QTimer>

#include "core/recording/take.h"
#include "tests/core/import/example_files.h"
#include "tests/support/files.h"
#include "tests/ui/main_window/studio_fixture.h"
#include "ui/plots/heat_map.h"
#include "ui/views/session/columns_dialog.h"
#include "ui/views/session/recording_dialog.h"
#include "ui/widgets/button.h"

namespace noctule::ui {
namespace {

class ImportRecording : public test::StudioWindow {
protected:
    /// Two sensors of MT Manager whose names say nothing.
    QStringList written() {
        QStringList paths;
        for (const std::string id : {"0001", "0002"}) {
            std::vector<int> counters(400);
            for (size_t i = 0; i < counters.size(); ++i)
                counters[i] = int(i);
            paths.append(folder_.filePath(QString::fromStdString("walk_" + id + ".txt")));
            noctule::test::writeBytes(paths.last().toStdString(),
                                      noctule::test::xsensExample(counters, '\t', true, "\n", id));
        }
        return paths;
    }
    static bool says(const QWidget& dialog, const QString& words) {
        const auto labels = dialog.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
            return label->isVisible() && label->text().contains(words);
        });
    }
    static bool isSettled(const RecordingDialog& dialog) { return !dialog.isBusy() && dialog.segmentOf(0); }
};

TEST_F(ImportRecording, DroppedFilesBecomeATakeUnderReview) {
    const QStringList paths = written();
    bool seen = false;
    QTimer timer;
    timer.start(20);
    QObject::connect(&timer, &QTimer::timeout, window_.get(), [&] {
        auto* dialog = qobject_cast<RecordingDialog*>(QApplication::activeModalWidget());
        if (!dialog || !isSettled(*dialog))
            return;
        timer.stop();
        seen = true;
        EXPECT_EQ(dialog->recording()->sensors.size(), 2u);
        dialog->segmentOf(1)->setCurrentIndex(dialog->segmentOf(1)->findData("LeftForeArm"));
        QTest::mouseClick(dialog->actionButton(), Qt::LeftButton);
    });
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(paths[0]), QUrl::fromLocalFile(paths[1])});
    const QPoint middle = window_->rect().center();
    QDragEnterEvent enter(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    enter.ignore();
    QApplication::sendEvent(window_.get(), &enter);
    ASSERT_TRUE(enter.isAccepted());
    QDropEvent released(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &released);
    ASSERT_TRUE(seen);
    ASSERT_TRUE(waitFor([this] { return studio_->jobs().idle() && studio_->take().isOpen(); }));
    EXPECT_EQ(window_->step(), Step::kReview);
    const auto& takes = studio_->session().session().takes;
    ASSERT_EQ(takes.size(), 1u);
    const auto take = Take::open(studio_->take().path().toStdString());
    ASSERT_TRUE(take);
    const auto suit = take->suit();
    ASSERT_TRUE(suit);
    ASSERT_EQ(suit->boards.size(), 2u);
    EXPECT_EQ(suit->boards[0].segment, "");
    EXPECT_EQ(suit->boards[1].segment, "LeftForeArm");
    EXPECT_FALSE(studio_->take().hasSources());
    const auto maps = window_->findChildren<HeatMap*>();
    EXPECT_FALSE(maps.empty());
    for (const HeatMap* map : maps)
        EXPECT_FALSE(map->isVisible()) << "a suit without sources has no pairs";
}

TEST_F(ImportRecording, ASegmentHoldsOneSensor) {
    RecordingDialog dialog(*studio_, written(), window_.get());
    dialog.show();
    ASSERT_TRUE(waitFor([&] { return isSettled(dialog); }));
    for (const size_t sensor : {0, 1}) {
        QComboBox* box = dialog.segmentOf(sensor);
        box->setCurrentIndex(box->findData("Hips"));
    }
    EXPECT_EQ(dialog.segmentOf(0)->currentIndex(), 0);
    EXPECT_EQ(dialog.recording()->sensors[0].segment, "");
    EXPECT_EQ(dialog.recording()->sensors[1].segment, "Hips");
    dialog.reject();
    EXPECT_FALSE(studio_->session().isOpen()) << "nothing is made before Import";
}

TEST_F(ImportRecording, ARateAndAMapFromTheOperatorAreUsed) {
    const QStringList paths = written();
    const QString map = folder_.filePath("map.json");
    noctule::test::writeBytes(
        map.toStdString(),
        R"({"format":"noctule-import-map","version":1,"sensors":[{"id":"0001","segment":"Head"}]})");
    RecordingDialog dialog(*studio_, paths, window_.get());
    dialog.show();
    ASSERT_TRUE(waitFor([&] { return isSettled(dialog); }));
    dialog.rate->setValue(50);
    QMetaObject::invokeMethod(dialog.rate, "editingFinished");
    ASSERT_TRUE(waitFor([&] { return isSettled(dialog) && dialog.recording(); }));
    EXPECT_EQ(dialog.recording()->sensors[0].samples.rate_hz, 50);
    ASSERT_TRUE(dialog.useMap(map));
    ASSERT_TRUE(waitFor([&] { return isSettled(dialog) && dialog.recording(); }));
    EXPECT_EQ(dialog.segmentOf(0)->currentData().toString(), "Head");
    EXPECT_FALSE(dialog.useMap(paths[0])) << "no map";
}

TEST_F(ImportRecording, TheColumnsOfATableAreSaidOnce) {
    std::string text = "stamp,A ax,A ay,A az,A gx,A gy,A gz\n";
    for (int i = 0; i < 300; ++i)
        text += std::to_string(10 * i) + ",0,0,1.0,0,0," + std::to_string(i % 90) + "\n";
    const QString path = folder_.filePath("shimmer.csv");
    noctule::test::writeBytes(path.toStdString(), text);
    {
        RecordingDialog dialog(*studio_, {path}, window_.get());
        dialog.show();
        ASSERT_TRUE(waitFor([&] { return !dialog.isBusy() && dialog.columns(); }));
        EXPECT_FALSE(dialog.recording()) << "nobody has said what they are";
        EXPECT_TRUE(says(dialog, "Nobody has said yet"));
        EXPECT_FALSE(says(dialog, "--map")) << "that is for the command line";
        EXPECT_TRUE(dialog.say_columns->isVisible() && dialog.say_columns->isEnabled());
        ColumnsDialog columns("shimmer.csv", *dialog.columns(), &dialog);
        columns.show();
        EXPECT_FALSE(columns.actionButton()->isEnabled()) << "the time is not known";
        columns.meaningOf(0)->setCurrentText("time");
        EXPECT_TRUE(columns.actionButton()->isEnabled());
        EXPECT_EQ(columns.accel_unit->currentText(), "g");
        columns.time_unit->setCurrentText("ms");
        columns.accept();
        dialog.useColumns(columns.table(), columns.map());
        ASSERT_TRUE(waitFor([&] { return isSettled(dialog) && dialog.recording(); }));
        EXPECT_NEAR(dialog.recording()->sensors[0].samples.rate_hz, 100, 1e-6);
        EXPECT_EQ(dialog.recording()->sensors[0].id, "a");
        EXPECT_TRUE(dialog.say_columns->isVisible()) << "it can be said again";
    }
    RecordingDialog again(*studio_, {path}, window_.get());
    again.show();
    EXPECT_TRUE(waitFor([&] { return isSettled(again) && again.recording(); })) << "tables like it are known";
    EXPECT_TRUE(says(again, "last table with this header")) << "nothing is converted silently";
}

/// Two tables of numbers may be anything.
TEST_F(ImportRecording, ColumnsWithoutNamesAreSaidEachTime) {
    std::string text;
    for (int i = 0; i < 300; ++i)
        text += std::to_string(10 * i) + ",0,0,9.8\n";
    const QString path = folder_.filePath("numbers.csv");
    noctule::test::writeBytes(path.toStdString(), text);
    for (int time = 0; time < 2; ++time) {
        RecordingDialog dialog(*studio_, {path}, window_.get());
        dialog.show();
        ASSERT_TRUE(waitFor([&] { return !dialog.isBusy() && dialog.columns(); }));
        EXPECT_FALSE(dialog.recording());
        TableColumns table = *dialog.columns();
        table.columns[0].quantity = TableQuantity::kTime;
        for (size_t axis = 0; axis < 3; ++axis) {
            TableColumn& column = table.columns[axis + 1];
            column.quantity = TableQuantity::kAccel;
            column.axis = axis;
            column.sensor = "a";
        }
        table.time_unit = "ms";
        dialog.useColumns(table, mapOfColumns(table, 0).value());
        EXPECT_TRUE(waitFor([&] { return isSettled(dialog) && dialog.recording(); }));
    }
}

TEST_F(ImportRecording, AHeaderWithoutRowsIsSaid) {
    const QString path = folder_.filePath("empty.csv");
    noctule::test::writeBytes(path.toStdString(), "t,ax,ay,az\n");
    RecordingDialog dialog(*studio_, {path}, window_.get());
    dialog.show();
    EXPECT_TRUE(waitFor([&] { return says(dialog, "no row below"); }));
    EXPECT_FALSE(dialog.actionButton()->isEnabled());
}

TEST_F(ImportRecording, FilesThatAreNoneAreRefusedInPlace) {
    const QString path = folder_.filePath("notes.txt");
    noctule::test::writeBytes(path.toStdString(), "no table");
    RecordingDialog dialog(*studio_, {path}, window_.get());
    dialog.show();
    ASSERT_TRUE(waitFor([&] { return !dialog.isBusy(); }));
    EXPECT_FALSE(dialog.recording());
    EXPECT_FALSE(dialog.actionButton()->isEnabled());
}

}  // namespace
}  // namespace noctule::ui
