// SPDX-License-Identifier: Apache-2.0
// A motion file from the desktop to a take under review: shown as it was understood, corrected, imported.
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QMimeData>
#include <QPushButton>
#include <QTimer>

#include "core/job/atomic_file.h"
#include "core/mesh/rig/bone_map.h"
#include "tests/ui/main_window/studio_fixture.h"
#include "ui/style/resources.h"
#include "ui/style/theme.h"
#include "ui/views/export/export_page.h"
#include "ui/views/length_box.h"
#include "ui/views/session/motion_dialog.h"
#include "ui/widgets/button.h"

namespace noctule::ui {
namespace {

class ImportMotion : public test::StudioWindow {
protected:
    /// The sample with a word replaced.
    QString written(const QString& name, const QByteArray& from = {}, const QByteArray& to = {}) {
        QByteArray text = resourceBytes("motions/sample.bvh");
        if (!from.isEmpty())
            text.replace(from, to);
        const QString path = folder_.filePath(name);
        EXPECT_TRUE(writeFileAtomically(path.toStdString(), text.toStdString(), true));
        return path;
    }
    static bool settled(const MotionDialog& dialog) {
        return !dialog.isBusy() && dialog.boneOf("Hips") && dialog.motion();
    }
    /// Does it with the dialog that opens next.
    void withDialog(const std::function<void(MotionDialog&)>& act) {
        auto* timer = new QTimer(window_.get());
        timer->start(20);
        connect(timer, &QTimer::timeout, window_.get(), [timer, act] {
            auto* dialog = qobject_cast<MotionDialog*>(QApplication::activeModalWidget());
            if (!dialog || dialog->isBusy() || !dialog->boneOf("Hips"))
                return;
            timer->deleteLater();
            timer->stop();
            act(*dialog);
        });
    }
    template <class... Arguments>
    static void connect(Arguments&&... arguments) {
        QObject::connect(std::forward<Arguments>(arguments)...);
    }
};

TEST_F(ImportMotion, ADroppedMotionBecomesATakeUnderReview) {
    const QString path = written("dance.bvh");
    bool seen = false;
    withDialog([&](MotionDialog& dialog) {
        seen = true;
        EXPECT_TRUE(dialog.motion());
        EXPECT_EQ(dialog.boneOf("LeftForeArm")->currentText(), "LeftForeArm");
        EXPECT_TRUE(dialog.actionButton()->isEnabled());
        dialog.scenario->setCurrentIndex(dialog.scenario->findData("ideal"));
        QTest::mouseClick(dialog.actionButton(), Qt::LeftButton);
    });
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    const QPoint middle = window_->rect().center();
    QDragEnterEvent enter(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    enter.ignore();
    QApplication::sendEvent(window_.get(), &enter);
    ASSERT_TRUE(enter.isAccepted());
    QDropEvent released(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &released);
    ASSERT_TRUE(seen);
    ASSERT_TRUE(waitFor([this] { return studio_->take().isOpen() && studio_->take().shownRun() >= 0; }));
    EXPECT_EQ(window_->step(), Step::kReview);
    EXPECT_TRUE(QFileInfo(studio_->take().path()).fileName().startsWith("dance"));
    const auto& takes = studio_->session().session().takes;
    ASSERT_EQ(takes.size(), 1u);
    EXPECT_TRUE(takes[0].processed);
    EXPECT_EQ(studio_->settings().value("motions/scenario").toString(), "ideal");

    ASSERT_TRUE(waitFor([this] { return studio_->jobs().idle() && studio_->take().verdict(); }));
    ASSERT_TRUE(studio_->take().verdict()->mean_error_deg) << "its poses are compared with the motion";
    EXPECT_LT(*studio_->take().verdict()->mean_error_deg, 3);
    window_->goTo(Step::kExport);
    auto& page = dynamic_cast<ExportPage&>(window_->page(Step::kExport));
    page.choosePreset("bvh");
    page.write();
    ASSERT_TRUE(waitFor([&] { return page.results().has_value(); }));
    ASSERT_EQ(page.results()->outcomes.size(), 1U);
    EXPECT_TRUE(page.results()->outcomes[0].check.ok());
    EXPECT_TRUE(QFile::exists(QString::fromStdString(page.results()->outcomes[0].path)));
}

TEST_F(ImportMotion, OneClickCorrectsAndIsKeptForTheSameJoints) {
    const QString path = written("odd.bvh");
    {
        MotionDialog dialog(*studio_, path, window_.get());
        dialog.show();
        ASSERT_TRUE(waitFor([&] { return settled(dialog); }));
        const double tall = dialog.motion()->measures.height_m;
        dialog.height->selectAll();
        QTest::keyClicks(dialog.height, "1.95");
        EXPECT_EQ(dialog.hints().height_m, 0) << "nothing is worked out for a number half typed";
        dialog.height->interpretText();
        ASSERT_TRUE(waitFor([&] { return settled(dialog) && dialog.motion()->measures.height_m > 1.9; }));
        EXPECT_NEAR(dialog.motion()->measures.height_m, 1.95, 1e-3);
        EXPECT_LT(tall, 1.9);
        QTest::mouseClick(dialog.exchange_sides, Qt::LeftButton);
        ASSERT_TRUE(waitFor([&] { return settled(dialog) && !dialog.motion()->by_hand.empty(); }));
        EXPECT_EQ(dialog.boneOf("LeftForeArm")->currentText(), "RightForeArm");
        EXPECT_EQ(dialog.boneOf("RightUpLeg")->currentText(), "LeftUpLeg");
        const QString map = folder_.filePath("odd.bones.json");
        ASSERT_TRUE(dialog.saveBones(map));
        const auto saved = readBoneMap(map.toStdString());
        ASSERT_TRUE(saved);
        EXPECT_EQ(saved->node_of_joint.at("LeftHand"), "RightHand");
        dialog.accept();
    }
    ASSERT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
    MotionDialog again(*studio_, path, window_.get());
    again.show();
    ASSERT_TRUE(waitFor([&] { return settled(again) && !again.hints().joints.empty(); }));
    ASSERT_TRUE(waitFor([&] { return settled(again) && !again.motion()->by_hand.empty(); }));
    EXPECT_EQ(again.boneOf("LeftForeArm")->currentText(), "RightForeArm");
    QTest::mouseClick(again.find_again, Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return settled(again) && again.motion()->by_hand.empty(); }));
    EXPECT_EQ(again.boneOf("LeftForeArm")->currentText(), "LeftForeArm");
}

TEST_F(ImportMotion, ABoneIsNamedByHand) {
    MotionDialog dialog(*studio_, written("named.bvh", "JOINT LeftForeArm", "JOINT Wrist2"), window_.get());
    dialog.show();
    ASSERT_TRUE(waitFor([&] { return settled(dialog); }));
    dialog.boneOf("LeftForeArm")->setCurrentText("LeftHand");
    ASSERT_TRUE(waitFor([&] { return !dialog.isBusy() && dialog.hints().joints.size() == 1; }));
    EXPECT_EQ(dialog.hints().joints.at("LeftForeArm"), "LeftHand");
    dialog.boneOf("LeftForeArm")->setCurrentText("Wrist2");
    ASSERT_TRUE(waitFor([&] { return settled(dialog) && !dialog.motion()->by_hand.empty(); }));
    EXPECT_EQ(dialog.hints().joints.at("LeftForeArm"), "Wrist2");
    EXPECT_TRUE(dialog.actionButton()->isEnabled());
}

TEST_F(ImportMotion, WhatIsNoMotionIsSaidInTheDialog) {
    const QString path = folder_.filePath("broken.bvh");
    ASSERT_TRUE(writeFileAtomically(path.toStdString(), "HIERARCHY\nROOT\n", true));
    MotionDialog dialog(*studio_, path, window_.get());
    dialog.show();
    ASSERT_TRUE(waitFor([&] { return !dialog.isBusy(); }));
    EXPECT_FALSE(dialog.actionButton()->isEnabled());
    EXPECT_FALSE(dialog.motion());
    EXPECT_FALSE(studio_->session().isOpen()) << "nothing was made";
}

/// For eyes: NOCTULE_SCREENSHOTS names the folder.
TEST_F(ImportMotion, Pictures) {
    const QString folder = qEnvironmentVariable("NOCTULE_SCREENSHOTS");
    if (folder.isEmpty())
        GTEST_SKIP() << "NOCTULE_SCREENSHOTS names no folder";
    QDir().mkpath(folder);
    const QString path = written("dance.bvh", "JOINT LeftForeArm", "JOINT Wrist2");
    for (const QSize size : {QSize(1440, 900), QSize(1280, 800)})
        for (const Scheme scheme : {Scheme::kDark, Scheme::kLight}) {
            Theme::get().setScheme(scheme);
            window_->resize(size);
            MotionDialog dialog(*studio_, path, window_.get());
            dialog.show();
            ASSERT_TRUE(waitFor([&] { return settled(dialog); }));
            QTest::qWait(300);
            const QString look =
                QStringLiteral("%1-%2").arg(scheme == Scheme::kDark ? "dark" : "light").arg(size.width());
            EXPECT_LE(dialog.height->y(), size.height());
            EXPECT_TRUE(dialog.grab().save(QDir(folder).filePath("import-motion-" + look + ".png")));
            EXPECT_TRUE(window_->grab().save(QDir(folder).filePath("start-with-import-" + look + ".png")));
        }
}

}  // namespace
}  // namespace noctule::ui
