// SPDX-License-Identifier: Apache-2.0
// Another system's recording comes into the take through the screen.
#include "ui/views/review/reference_panel.h"

#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <algorithm>

#include "core/processing/export_take.h"
#include "core/recording/take.h"
#include "tests/ui/views/reviewed_session.h"
#include "ui/views/review/attach_dialog.h"
#include "ui/views/review/choice_row.h"
#include "ui/widgets/button.h"

namespace noctule::ui {
namespace {

class ReferencePanelTest : public test::ReviewedSession {
protected:
    void SetUp() override {
        ReviewedSession::SetUp();
        if (HasFatalFailure())
            return;
        panel_ = std::make_unique<ReferencePanel>(*studio_);
        panel_->resize(248, 160);
        panel_->show();
        openTake("swing_001");
        ExportRequest request;
        request.take_path = takePath("swing_001").toStdString();
        request.bvh_path = outsideFile("optical.bvh").toStdString();
        request.from_s = 1;
        ASSERT_TRUE(exportTake(request, {}));
    }
    void TearDown() override {
        waitFor([this] { return jobsAreDone(); });
        panel_.reset();
        ReviewedSession::TearDown();
    }

    /// Drops the file and answers the dialog that it opens.
    void drop(const QString& path, const std::function<void(AttachDialog&)>& answer) {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        QDragEnterEvent enter(QPoint(20, 20), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(panel_.get(), &enter);
        ASSERT_TRUE(enter.isAccepted());
        QDropEvent event(QPoint(20, 20), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QTimer waiting;
        bool answered = false;
        QObject::connect(&waiting, &QTimer::timeout, [&] {
            if (auto* dialog = qobject_cast<AttachDialog*>(QApplication::activeModalWidget())) {
                waiting.stop();
                answered = true;
                answer(*dialog);
            }
        });
        waiting.start(20);
        QApplication::sendEvent(panel_.get(), &event);
        ASSERT_TRUE(waitFor([&] { return answered; }));
        ASSERT_TRUE(waitFor([this] { return jobsAreDone(); }));
    }
    bool says(const QString& words) const {
        for (const QLabel* label : panel_->findChildren<QLabel*>())
            if (label->isVisible() && label->text().contains(words))
                return true;
        return false;
    }

    std::unique_ptr<ReferencePanel> panel_;
};

TEST_F(ReferencePanelTest, ADroppedMotionIsAlignedByItsMovements) {
    EXPECT_EQ(studio_->take().overview()->reference_kind, "simulated");
    drop(outsideFile("optical.bvh"), [](AttachDialog& dialog) {
        EXPECT_TRUE(dialog.as_reference->isChecked());
        EXPECT_TRUE(dialog.align_auto->isChecked());
        EXPECT_EQ(dialog.actionButton()->text(), "Replace") << "the take has one already";
        QTest::mouseClick(dialog.actionButton(), Qt::LeftButton);
    });
    ASSERT_TRUE(waitFor([this] { return says("aligned by"); }));
    EXPECT_TRUE(says("optical"));
    EXPECT_TRUE(says("joints matched"));
    EXPECT_NE(studio_->take().overview()->reference_kind, "simulated");
}

TEST_F(ReferencePanelTest, ItMayBeginAtATimeThatIsGiven) {
    drop(outsideFile("optical.bvh"), [](AttachDialog& dialog) {
        dialog.align_given->setChecked(true);
        dialog.milliseconds->setValue(1000);
        QTest::mouseClick(dialog.actionButton(), Qt::LeftButton);
    });
    EXPECT_TRUE(waitFor([this] { return says("aligned by 1.000"); }));
}

TEST_F(ReferencePanelTest, ReplacingAReferenceCanBeUndoneAndDoneAgain) {
    const auto reference = [this] {
        const auto take = Take::open(takePath("swing_001").toStdString());
        return take ? take->reference()->frames : std::vector<TimedPose>();
    };
    const auto before = reference();
    UndoHistory& undo = studio_->session().undoStack();
    const int steps = undo.count();
    drop(outsideFile("optical.bvh"),
         [](AttachDialog& dialog) { QTest::mouseClick(dialog.actionButton(), Qt::LeftButton); });
    ASSERT_EQ(undo.count(), steps + 1);
    EXPECT_EQ(undo.undoText(), "Attach optical.bvh to swing_001");
    const size_t attached = reference().size();
    ASSERT_NE(attached, before.size());

    undo.undo();
    ASSERT_TRUE(waitFor([this] { return studio_->take().overview()->reference_kind == "simulated"; }));
    ASSERT_TRUE(waitFor([this] { return jobsAreDone(); }));
    const auto again = reference();
    ASSERT_EQ(again.size(), before.size());
    EXPECT_EQ(again.back().pose->p_world_root, before.back().pose->p_world_root);
    EXPECT_EQ(again.back().pose->q_parent_joint.back().coeffs(),
              before.back().pose->q_parent_joint.back().coeffs());
    EXPECT_TRUE(waitFor([this] { return says("Truth of the simulation"); }));

    undo.redo();
    ASSERT_TRUE(waitFor([this] { return says("aligned by"); }));
    EXPECT_EQ(reference().size(), attached);
}

TEST_F(ReferencePanelTest, OneMotionIsAttachedAtATime) {
    const auto buttons = panel_->findChildren<Button*>();
    const auto found = std::ranges::find_if(
        buttons, [this](const Button* button) { return button->isVisibleTo(panel_.get()); });
    ASSERT_NE(found, buttons.end());
    const Button* attach = *found;
    ASSERT_TRUE(attach->isEnabled());
    AttachChoice choice;
    choice.path = outsideFile("optical.bvh");
    choice.overwrite = true;
    panel_->attach(choice);
    EXPECT_FALSE(attach->isEnabled()) << "the way back of a second one would not be known";
    ASSERT_TRUE(waitFor([this] { return jobsAreDone(); }));
    EXPECT_TRUE(waitFor([&] { return attach->isEnabled(); }));
}

TEST_F(ReferencePanelTest, ADialogThatIsLeftChangesNothing) {
    const auto before = studio_->take().overview();
    drop(outsideFile("optical.bvh"), [](AttachDialog& dialog) { dialog.reject(); });
    EXPECT_EQ(studio_->take().overview(), before);
}

}  // namespace
}  // namespace noctule::ui
