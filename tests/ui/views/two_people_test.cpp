// SPDX-License-Identifier: Apache-2.0
// A take of two performers in Review and Export: the operator chooses who is shown, sees both bodies and the
// distances between them, and gets a file of each.
#include <sqlite3.h>

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <atomic>

#include "tests/core/simulation/swaying_pair.h"
#include "tests/ui/views/reviewed_session.h"
#include "ui/plots/heard_switch.h"
#include "ui/plots/plot_panel.h"
#include "ui/scene/scene_view.h"
#include "ui/scene/scene_words.h"
#include "ui/scene/take_scene.h"
#include "ui/style/words.h"
#include "ui/views/export/export_form.h"
#include "ui/views/export/export_page.h"
#include "ui/views/report/full_report.h"
#include "ui/views/report/report_panel.h"
#include "ui/views/review/performer_switch.h"
#include "ui/views/review/reference_panel.h"
#include "ui/views/review/reprocess_dialog.h"
#include "ui/views/review/review_center.h"
#include "ui/views/review/review_page.h"
#include "ui/views/review/review_sidebar.h"
#include "ui/views/review/run_list.h"
#include "ui/views/review/run_row.h"
#include "ui/widgets/button.h"

namespace noctule::ui {
namespace {

/// Made once for all tests.
const std::string& processedPair() {
    static const QTemporaryDir folder;
    static const std::string path = [] {
        const std::string made = folder.filePath("pair.noctule").toStdString();
        const Status written = noctule::test::writeProcessedPair(made);
        EXPECT_TRUE(written) << written.error().text();
        return made;
    }();
    return path;
}

/// While it lives.
class OpenedDatabases {
public:
    OpenedDatabases() {
        opened() = 0;
        sqlite3_auto_extension(reinterpret_cast<void (*)()>(note));
    }
    ~OpenedDatabases() { sqlite3_cancel_auto_extension(reinterpret_cast<void (*)()>(note)); }
    int count() const { return opened(); }

private:
    static std::atomic<int>& opened() {
        static std::atomic<int> count;
        return count;
    }
    static int note(sqlite3*, const char**, const void*) {
        ++opened();
        return SQLITE_OK;
    }
};

class TwoPeopleTest : public test::ReviewedSession {
protected:
    void SetUp() override {
        ReviewedSession::SetUp();
        if (HasFatalFailure())
            return;
        studio_->session().importTakes({QString::fromStdString(processedPair())});
        ASSERT_TRUE(
            waitFor([this] { return studio_->session().session().takes.size() == 2 && jobsAreDone(); }));
        window_ = std::make_unique<QWidget>();
        page_ = new ReviewPage(*studio_);
        auto* row = new QHBoxLayout(window_.get());
        for (QWidget* part : {page_->leftDock(), static_cast<QWidget*>(page_), page_->rightDock()}) {
            row->addWidget(part);
            part->show();
        }
        window_->resize(1440, 860);
        window_->show();
        page_->enter();
        openTake("pair");
    }
    void TearDown() override {
        waitFor([this] { return jobsAreDone(); });
        window_.reset();
        ReviewedSession::TearDown();
    }

    void show(int performer) {
        const auto& buttons = page_->center().performers().buttons();
        ASSERT_GT(buttons.size(), static_cast<size_t>(performer));
        QTest::mouseClick(buttons[static_cast<size_t>(performer)], Qt::LeftButton);
        ASSERT_TRUE(waitFor([&] {
            return studio_->take().subject() == performer && studio_->take().verdict() && jobsAreDone();
        })) << studio_->take().problem().toStdString();
    }
    bool reportSays(const QString& words) const {
        for (const QLabel* label : page_->reportPanel().findChildren<QLabel*>())
            if (label->isVisible() && label->text().contains(words))
                return true;
        return false;
    }

    std::unique_ptr<QWidget> window_;
    ReviewPage* page_ = nullptr;
};

TEST_F(TwoPeopleTest, TheOperatorChoosesWhoIsShown) {
    const auto& buttons = page_->center().performers().buttons();
    ASSERT_EQ(buttons.size(), 2u);
    EXPECT_TRUE(page_->center().performers().isVisible());
    EXPECT_EQ(buttons[0]->text(), "Ada");
    EXPECT_TRUE(buttons[0]->isChecked() && !buttons[1]->isChecked());
    const auto of_ada = studio_->take().shownMotion();
    show(1);
    EXPECT_TRUE(!buttons[0]->isChecked() && buttons[1]->isChecked());
    const auto of_bea = studio_->take().shownMotion();
    ASSERT_TRUE(of_ada && of_bea);
    EXPECT_LT(of_ada->frames.back().pose->p_world_root.z(), 0);
    EXPECT_GT(of_bea->frames.back().pose->p_world_root.z(), 0);
    QTest::mouseClick(buttons[1], Qt::LeftButton);
    EXPECT_TRUE(buttons[1]->isChecked()) << "one is always shown";
    QTest::keyClick(&page_->reportPanel(), Qt::Key_P, Qt::ShiftModifier);
    EXPECT_TRUE(waitFor([this] { return studio_->take().subject() == 0; })) << "Shift+P shows the next";
    openTake("swing_001");
    EXPECT_FALSE(page_->center().performers().isVisible()) << "there is one performer only";
}

TEST_F(TwoPeopleTest, TheProcessDialogAndTheResultSayWhoIsProcessedAndHow) {
    ReprocessDialog dialog(*studio_, *studio_->take().overview());
    dialog.not_smoothed->setChecked(true);
    dialog.root_free->setChecked(true);
    EXPECT_TRUE(dialog.people().startsWith("Ada, Bea: all suits are processed together"));
    dialog.smoothed_whole->setChecked(true);
    EXPECT_TRUE(dialog.people().startsWith("Ada, Bea: each suit is processed alone, since smoothing"));
    const auto labels = dialog.findChildren<QLabel*>();
    EXPECT_TRUE(std::ranges::any_of(
        labels, [&](const QLabel* label) { return label->text().contains("since smoothing"); }));
    const QString detail = page_->sidebar().runs().row(0)->detail();
    EXPECT_TRUE(detail.contains("Ada, Bea: together, with ranges")) << detail.toStdString();
}

TEST_F(TwoPeopleTest, TheListOfResultsAndTheFullReportAreOfWhomIsShown) {
    FullReport report(*studio_);
    const auto mean_deg = [&] {
        report.need();
        EXPECT_TRUE(waitFor([&] { return report.data() && jobsAreDone(); }));
        return report.meanError_deg(studio_->take().shownRun());
    };
    const auto of_ada = mean_deg();
    show(1);
    const auto of_bea = mean_deg();
    ASSERT_TRUE(of_ada && of_bea && studio_->take().verdict()->mean_error_deg);
    EXPECT_NE(*of_ada, *of_bea);
    EXPECT_NEAR(*of_bea, *studio_->take().verdict()->mean_error_deg, 1e-9) << "as her own verdict has it";
    const QString detail = page_->sidebar().runs().row(studio_->take().shownRun())->detail();
    EXPECT_TRUE(detail.contains(degreesText(radians(*of_bea)))) << detail.toStdString();
}

TEST_F(TwoPeopleTest, BothBodiesStandInThePictureWithTheirLetters) {
    TakeScene scene(*studio_);
    SceneLayers layers;
    studio_->time().setTime(2);
    ASSERT_TRUE(waitFor([&] { return scene.compose(layers).tags.size() == 2 && jobsAreDone(); }));
    const ComposedScene composed = scene.compose(layers);
    std::set<int> letters;
    for (const ComposedScene::Tag& tag : composed.tags) {
        letters.insert(tag.performer);
        EXPECT_GT(tag.p_m.y(), 1.5);
        EXPECT_LT(tag.p_m.z() * (tag.performer == 0 ? 1 : -1), 0) << "each over the own head";
    }
    EXPECT_EQ(letters, (std::set<int>{0, 1}));
    EXPECT_GE(composed.scene.bodies.size() + composed.scene.discs.size(), 2u);
    EXPECT_GT(composed.others.center().z(), 0);
    ASSERT_TRUE(composed.distance);
    EXPECT_LT(composed.distance->distance_m, 1.5);
    EXPECT_LT(std::abs(composed.distance->middle_m.z()), 0.6) << "between them";
    ASSERT_TRUE(waitFor([&] { return scene.compose(layers).distance->sigma_m.has_value(); }));
    EXPECT_LT(*scene.compose(layers).distance->sigma_m, 0.1);
    const auto tracks = studio_->take().betweenTracks(0, 1);
    const BetweenTrack* plotted = nearestHands(*tracks);
    ASSERT_TRUE(plotted);
    const SeriesPyramid& curve = plotted->distance.value;
    EXPECT_NEAR(composed.distance->distance_m, double{curve.series().value[curve.indexAt(2)]}, 0.02)
        << "the pair of the plot";
    EXPECT_TRUE(pairOfDistance(*composed.distance).contains("of A to "));
}

TEST_F(TwoPeopleTest, DistancesAreAPlotAndAPartOfTheReport) {
    PlotPanel& plots = page_->center().plots();
    plots.setOn(PlotTab::kBetween, true);
    TakeDocument& take = studio_->take();
    ASSERT_TRUE(waitFor([&] {
        return take.betweenTracks(0, 1) && take.betweenTracks(0, 1, TakeDocument::Whose::kReference);
    }));
    ASSERT_TRUE(waitFor([&] { return plots.csv().find("Pelvis of A to pelvis of B") != std::string::npos; }))
        << plots.csv().substr(0, 400);
    EXPECT_TRUE(plots.csv().find("reference") != std::string::npos);
    const auto between = take.between();
    ASSERT_TRUE(between);
    EXPECT_EQ(between->size(), 5u);
    EXPECT_TRUE(reportSays("Between Ada and Bea"));
    EXPECT_TRUE(reportSays("Facing each other"));
    show(1);
    EXPECT_TRUE(reportSays("Between Ada and Bea")) << "whoever is shown";
    for (const Button* button : page_->sidebar().reference().findChildren<Button*>())
        if (button->text() == "Replace") {
            EXPECT_FALSE(button->isEnabled()) << "it would go to Ada";
            EXPECT_TRUE(button->toolTip().contains("Ada"));
        }
}

TEST_F(TwoPeopleTest, PairsAndRaysMayComeFromTheOtherOrFromTheRoom) {
    TakeDocument& take = studio_->take();
    const auto* heard = page_->center().findChild<HeardSwitch*>();
    ASSERT_TRUE(heard);
    EXPECT_FALSE(heard->isHidden());
    ASSERT_EQ(heard->buttons().size(), 3u);
    EXPECT_EQ(heard->buttons()[0]->text(), "Own");
    EXPECT_TRUE(heard->buttons()[0]->isChecked());
    EXPECT_EQ(heard->buttons()[1]->text(), "B to A");
    EXPECT_EQ(heard->buttons()[2]->text(), "Room to A");
    studio_->time().setTime(2);
    TakeScene scene(*studio_);
    SceneLayers layers;
    const auto rayBegins = [&](int party) {
        QTest::mouseClick(heard->buttons()[static_cast<size_t>(party)], Qt::LeftButton);
        EXPECT_TRUE(waitFor([&] { return !scene.compose(layers).pairs.empty() && jobsAreDone(); }));
        EXPECT_EQ(take.sourcesOf(), party);
        std::vector<float> z_m;
        for (const SceneLine& ray : scene.compose(layers).scene.rays)
            z_m.push_back(ray.from_m.z());
        EXPECT_GT(z_m.size(), 5u);
        return z_m;
    };
    EXPECT_TRUE(std::ranges::all_of(rayBegins(0), [](float z_m) { return z_m < 0; })) << "Ada's own";
    EXPECT_TRUE(std::ranges::all_of(rayBegins(1), [](float z_m) { return z_m > 0; })) << "Bea's";
    EXPECT_EQ(take.ranges()->source_count, 5);
    EXPECT_TRUE(std::ranges::all_of(rayBegins(2), [](float z_m) { return std::abs(z_m) > 1.4F; }))
        << "the corners'";
    EXPECT_EQ(take.ranges()->source_count, 4);
    studio_->selection().setPair(0, 1);
    PlotPanel& plots = page_->center().plots();
    plots.setOn(PlotTab::kConfidence, true);
    EXPECT_TRUE(waitFor([&] { return plots.csv().find("Room to A: ") != std::string::npos; }))
        << plots.csv().substr(0, 400);
    show(1);
    EXPECT_EQ(take.sourcesOf(), 1) << "her own at first";
    EXPECT_EQ(heard->buttons()[0]->text(), "A to B");
    openTake("swing_001");
    EXPECT_TRUE(heard->isHidden()) << "there is nobody else";
}

TEST_F(TwoPeopleTest, ExportWritesAFileOfEach) {
    ExportPage page(*studio_);
    page.resize(1000, 700);
    page.show();
    page.choosePreset("bvh");
    page.enter();
    ASSERT_EQ(page.form().takes(), QStringList{"pair"});
    const auto written = [&] {
        QTest::mouseClick(page.writeButton(), Qt::LeftButton);
        EXPECT_TRUE(waitFor([&] { return page.results().has_value() && jobsAreDone(); }));
        std::set<std::string> files;
        for (const ExportOutcome& outcome : page.results()->outcomes) {
            EXPECT_FALSE(outcome.error) << outcome.error->text();
            EXPECT_TRUE(outcome.check.ok());
            files.insert(std::filesystem::path(outcome.path).filename().string());
        }
        return files;
    };
    EXPECT_EQ(page.form().preview(), "pair_120_Ada.bvh\npair_120_Bea.bvh");
    EXPECT_EQ(written(), (std::set<std::string>{"pair_120_Ada.bvh", "pair_120_Bea.bvh"}));
    EXPECT_EQ(page.form().preview(), "pair_120_Ada_2.bvh\npair_120_Bea_2.bvh");
    EXPECT_EQ(written(), (std::set<std::string>{"pair_120_Ada_2.bvh", "pair_120_Bea_2.bvh"}))
        << "nothing is overwritten";
    {
        const OpenedDatabases opened;
        page.form().name_pattern->setFocus();
        QTest::keyClicks(page.form().name_pattern, "{take}_x");
        EXPECT_TRUE(page.form().preview().contains("_x_Ada.bvh")) << page.form().preview().toStdString();
        EXPECT_TRUE(waitFor([&] { return jobsAreDone(); }));
        EXPECT_EQ(opened.count(), 0) << "who is in a take is known";
        page.form().name_pattern->clear();
    }
    EXPECT_TRUE(page.writeButton()->text().contains('2')) << page.writeButton()->text().toStdString();

    page.choosePreset("blender");
    page.form().one_file->setChecked(true);
    EXPECT_TRUE(page.writeButton()->text().contains('1')) << page.writeButton()->text().toStdString();
    EXPECT_EQ(written().size(), 1U);
    ASSERT_EQ(page.results()->outcomes.size(), 2U) << "each character is checked";
    EXPECT_TRUE(page.results()->outcomes[1].take.contains("Bea"));
    EXPECT_EQ(page.results()->written(), 1);
    page.choosePreset("web");
    page.form().one_file->setChecked(true);
    EXPECT_EQ(written().size(), 1U) << "and in one GLB file";
    ASSERT_EQ(page.results()->outcomes.size(), 2U);
}

}  // namespace
}  // namespace noctule::ui
