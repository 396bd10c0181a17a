// SPDX-License-Identifier: Apache-2.0
// The wizard of the magnetometers to its end: a small suit in a bag that the virtual suit rolls.
#include <QPainter>
#include <tuple>

#include "tests/ui/wizards/wizard_flow.h"
#include "ui/wizards/field_live.h"
#include "ui/wizards/field_sensors.h"

namespace noctule::ui {
namespace {

using namespace test;

class MagnetometerFlow : public WizardFlow {
protected:
    /// The first boards of the default suit; `magnetometers` of them have one.
    QString suitInBag(int boards, int magnetometers) {
        const QString path = QString::fromStdString(smallSuit(folder_, boards));
        std::ifstream in(path.toStdString());
        nlohmann::json suit = nlohmann::json::parse(in);
        for (int board = 0; board < magnetometers; ++board)
            suit["boards"][static_cast<size_t>(board)]["stream"] = "imu9";
        std::ofstream(path.toStdString()) << suit.dump();
        return path;
    }
    void connectBag(const QString& suit, const QString& rig = "bag") {
        rig_ = std::make_unique<RigProgram>(
            QStringList{"--suit", suit, "--speed", "2", "--seed", "3", "--rig", rig});
        ASSERT_TRUE(rig_->isThere());
        connectAgain();
    }
    std::string said() { return page_->wizard().field().sentence().toStdString(); }
    const FieldGuide& guide() { return *run().fieldGuide(); }
    /// Rail, page and sensors side by side, as in the window; only where pictures are asked for.
    void picture(const QString& name) {
        const QString folder = qEnvironmentVariable("NOCTULE_SCREENSHOTS");
        if (folder.isEmpty())
            return;
        for (const auto& [look, scheme, scale] :
             {std::tuple("dark", Scheme::kDark, 1.0), std::tuple("light", Scheme::kLight, 1.0),
              std::tuple("dark-150", Scheme::kDark, 1.5)}) {
            Theme::get().setScheme(scheme);
            Theme::get().setScale(scale);
            const QSize size = scale > 1 ? QSize(1280, 740) : QSize(1440, 820);
            const int left = Theme::get().px(248), right = Theme::get().px(scale > 1 ? 300 : 376);
            page_->leftDock()->resize(left, size.height());
            page_->rightDock()->resize(right, size.height());
            page_->resize(size.width() - left - right, size.height());
            QTest::qWait(300);
            QImage image(size, QImage::Format_RGB32);
            image.fill(Theme::get().tokens().panel);
            QPainter painter(&image);
            painter.drawPixmap(0, 0, page_->leftDock()->grab());
            painter.drawPixmap(left, 0, page_->grab());
            painter.drawPixmap(size.width() - right, 0, page_->rightDock()->grab());
            painter.end();
            image.save(QString("%1/%2-%3.png").arg(folder, name, look));
        }
        Theme::get().setScheme(Scheme::kDark);
        Theme::get().setScale(1);
    }
};

TEST_F(MagnetometerFlow, WalksThrough) {
    connectBag(suitInBag(4, 4));
    ASSERT_TRUE(page_->startButton(WizardTask::kMagnetometers)->isVisible());
    picture("magnetometers-overview");
    open(WizardTask::kMagnetometers);
    ASSERT_TRUE(waitLong([this] { return guide().isDone(FieldGuide::kSpot); })) << said();
    operate("roll 600");
    ASSERT_TRUE(waitLong([this] { return guide().leastShare() > 0.5; })) << said();
    EXPECT_FALSE(page_->wizard().field().instruction().isEmpty());
    picture("magnetometers-half");
    ASSERT_TRUE(reach(Phase::kResult)) << said() << " " << guide().leastShare();
    picture("magnetometers-result");
    EXPECT_NE(run().result()->grade(), Grade::kNotUsable) << whatWasFound();
    save();
    EXPECT_LE(clicks_, 4);
    for (const BoardCalibration& board : inForce().boards) {
        EXPECT_TRUE(board.made.contains("magnetometers")) << board.id;
        ASSERT_TRUE(board.mag) << board.id;
        // Whatever way it is turned, the field is as strong.
        EXPECT_GT(board.mag->matrix.determinant(), 0) << board.id;
    }
}

TEST_F(MagnetometerFlow, UsesThoseThatAreDone) {
    connectBag(suitInBag(3, 2));
    open(WizardTask::kMagnetometers);
    EXPECT_TRUE(guide().isSkipped(2)) << "it has no magnetometer";
    ASSERT_TRUE(waitLong([this] { return guide().isDone(FieldGuide::kSpot); })) << said();
    operate("roll 600");
    ASSERT_TRUE(waitLong([this] { return guide().enoughBoards() > 0 || run().phase() == Phase::kResult; }));
    if (run().phase() == Phase::kGuiding)
        click(page_->wizard().fieldSensors().enoughButton());
    ASSERT_TRUE(reach(Phase::kResult)) << said();
    save();
    EXPECT_FALSE(inForce().boards[2].mag);
}

TEST_F(MagnetometerFlow, IsAbsentWithoutMagnetometers) {
    connectBag(suitInBag(2, 0));
    EXPECT_FALSE(page_->startButton(WizardTask::kMagnetometers)->isVisible());
    page_->open(WizardTask::kMagnetometers);
    EXPECT_EQ(run().whyNotBegin(), "No board of this suit has a magnetometer.");
}

}  // namespace
}  // namespace noctule::ui
