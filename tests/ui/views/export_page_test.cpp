// SPDX-License-Identifier: Apache-2.0
// What the Export page offers and sends out.
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QSet>
#include <set>

#include "core/job/atomic_file.h"
#include "tests/ui/views/export_page_fixture.h"
#include "ui/style/theme.h"
#include "ui/views/export/export_take_list.h"

namespace noctule::ui {
namespace {

using test::ExportPageTest;

TEST_F(ExportPageTest, WritesTheFileThatTheBatchProgramWrites) {
    EXPECT_EQ(page_->form().takes(), QStringList{"swing_001"}) << "the open take is ticked";
    write();
    const ExportResults& results = *page_->results();
    ASSERT_EQ(results.outcomes.size(), 1U);
    ASSERT_FALSE(results.outcomes[0].error) << results.outcomes[0].error->text();
    EXPECT_TRUE(results.outcomes[0].check.ok()) << results.outcomes[0].check.faults[0];
    EXPECT_EQ(results.outcomes[0].path, exported("swing_001_120.bvh"));

    ExportRequest batch;  // of `noctule --batch export swing_001.noctule --bvh F`
    batch.take_path = takePath("swing_001").toStdString();
    batch.bvh_path = outsideFile("batch.bvh").toStdString();
    ASSERT_TRUE(exportTake(batch, {}));
    const auto ours = readWholeFile(exported("swing_001_120.bvh")), theirs = readWholeFile(batch.bvh_path);
    ASSERT_TRUE(ours && theirs);
    EXPECT_GT(ours->size(), 10000U);
    EXPECT_TRUE(*ours == *theirs) << "byte for byte";
    EXPECT_EQ(page_->resultsPanel().cardCount(), 1);
}

TEST_F(ExportPageTest, PicturesAndFilmsAreWrittenAndChecked) {
    studio_->session().setTakeRange(0, 1, 1.4);
    for (const char* preset : {"film", "picture"}) {
        page_->choosePreset(preset);
        page_->form().size->setCurrentIndex(0);
        page_->form().camera->setCurrentIndex(1);
        EXPECT_TRUE(page_->form().size->isVisible());
        write();
        const ExportOutcome& outcome = page_->results()->outcomes.front();
        ASSERT_FALSE(outcome.error) << outcome.error->text();
        EXPECT_TRUE(outcome.check.ok()) << outcome.check.faults.front();
        EXPECT_TRUE(outcome.check.is_picture);
        EXPECT_EQ(outcome.check.size.width_px, 1280);
        EXPECT_EQ(outcome.check.frames, outcome.path.ends_with(".mp4") ? 13U : 1U);
        EXPECT_TRUE(checkAsText(*page_->results()).contains("1280"));
    }
    page_->choosePreset("bvh");
    EXPECT_FALSE(page_->form().size->isVisible());
}

TEST_F(ExportPageTest, TheSessionsBodyGoesOut) {
    SessionBody body;
    body.mesh = writtenFigure(JointNames::kHumanIk).toStdString();
    studio_->session().setBody(body);
    page_->choosePreset("web");
    page_->form().body->setCurrentIndex(2);
    ASSERT_TRUE(waitFor([this] { return studio_->shownBody().worn() && jobsAreDone(); }));
    ASSERT_TRUE(page_->plan());
    EXPECT_EQ(page_->plan()->front().request.worn, studio_->shownBody().worn());
    write();
    ASSERT_FALSE(page_->results()->outcomes[0].error) << page_->results()->outcomes[0].error->text();
    EXPECT_TRUE(page_->results()->outcomes[0].check.ok());
    body.mesh = outsideFile("gone.glb").toStdString();
    studio_->session().setBody(body);
    ASSERT_TRUE(waitFor([this] { return studio_->shownBody().problem() && jobsAreDone(); }));
    EXPECT_FALSE(page_->plan()) << "it is not there";
}

TEST_F(ExportPageTest, AllTakesGoIntoOneFile) {
    addTake("kick_002");
    studio_->session().setTakeRange(studio_->session().session().findTake("kick_002"), 1, 2);
    page_->choosePreset("blender");
    page_->form().setTakes({"swing_001", "kick_002"});
    EXPECT_EQ(fileCount(*page_->plan()), 2);
    page_->form().one_file->setChecked(true);
    ASSERT_TRUE(page_->plan());
    EXPECT_EQ(fileCount(*page_->plan()), 1);
    EXPECT_TRUE(page_->writeButton()->text().contains('1'));
    write();
    const ExportResults& results = *page_->results();
    ASSERT_EQ(results.outcomes.size(), 2U);
    EXPECT_EQ(results.written(), 1);
    EXPECT_EQ(results.faulty(), 0);
    for (const ExportOutcome& outcome : results.outcomes) {
        ASSERT_FALSE(outcome.error) << outcome.error->text();
        EXPECT_TRUE(outcome.check.ok()) << outcome.check.faults.front();
        EXPECT_EQ(outcome.check.frames,
                  outcome.take == "kick_002" ? 61U : 269U);  // of 4.5 s, up to the last readings
        EXPECT_EQ(outcome.path, exported("Stage tests_60.fbx"));
    }
    EXPECT_EQ(page_->resultsPanel().cardCount(), 2);
    page_->choosePreset("web");
    page_->form().one_file->setChecked(true);
    EXPECT_FALSE(page_->form().one_file->isHidden());
    EXPECT_EQ(fileCount(*page_->plan()), 1) << "glTF holds several too";
    page_->form().also[ExportFormat::kFbx]->setChecked(true);
    EXPECT_EQ(fileCount(*page_->plan()), 2) << "one of each kind";
    write();
    ASSERT_EQ(page_->results()->outcomes.size(), 4U);
    EXPECT_EQ(page_->results()->written(), 2);
    EXPECT_EQ(page_->results()->faulty(), 0);
    page_->choosePreset("bvh");
    EXPECT_TRUE(page_->form().one_file->isHidden());
    EXPECT_EQ(fileCount(*page_->plan()), 2) << "BVH holds one";
}

TEST_F(ExportPageTest, FeetAreOnTheFloorOnlyWhereTheFileHasThemThere) {
    ExportResults results;
    results.outcomes.push_back({"swing_001", outsideFile("swing.bvh").toStdString(), {}, {}, false});
    ExportCheck& check = results.outcomes.front().check;
    check.has_figure = true;
    check.height_m = 1.78;
    check.held_by = HeldBy::kNothing;
    const auto says = [](const ExportResultsPanel& panel, const QString& words) {
        const auto labels = panel.findChildren<QLabel*>();
        return std::ranges::any_of(labels,
                                   [&](const QLabel* label) { return label->text().contains(words); });
    };
    const auto shown = [&](double lowest_m) {
        check.lowest_m = lowest_m;
        auto panel = std::make_unique<ExportResultsPanel>();
        panel->setResults(results, false);
        return panel;
    };
    EXPECT_TRUE(says(*shown(-0.01), "feet on the floor"));
    EXPECT_FALSE(says(*shown(-0.01), "something you should know"));
    const auto below = shown(-0.029);
    EXPECT_FALSE(says(*below, "feet on the floor"));
    EXPECT_TRUE(says(*below, "below the floor"));
    EXPECT_TRUE(says(*below, "something you should know")) << "no tick";
    EXPECT_TRUE(says(*below, "Level floor")) << "nothing held the feet";
    EXPECT_TRUE(checkAsText(results).contains("below the floor"));
    check.held_by = HeldBy::kLevelFloor;
    EXPECT_FALSE(says(*shown(-0.029), "something you should know")) << "a hop on a level floor";
    check.usual_lowest_m = -0.04;
    EXPECT_TRUE(says(*shown(-0.05), "Move the motion up"));
    check.held_by = HeldBy::kOtherSystem;
    EXPECT_TRUE(says(*shown(-0.05), "that of the other system"));
    check.held_by = HeldBy::kRoom;
    EXPECT_TRUE(says(*shown(-0.05), "that of the anchors"));
    check.held_by = HeldBy::kUnevenGround;
    EXPECT_TRUE(says(*shown(-0.05), "as it may on uneven ground"));
    check.has_figure = false;  // a table of angles
    const auto unknown = shown(0);
    EXPECT_FALSE(says(*unknown, "feet on the floor"));
    EXPECT_FALSE(checkAsText(results).contains("feet on the floor"));
}

TEST_F(ExportPageTest, SeveralFormatsAndResultsGoOutAtOnce) {
    ProcessRequest gyroscopes_only;
    gyroscopes_only.take_path = takePath("swing_001").toStdString();
    gyroscopes_only.tracker.sensors = {false, true, false};
    studio_->process(gyroscopes_only);
    ASSERT_TRUE(waitFor([this] { return studio_->take().overview()->runs.size() == 2 && jobsAreDone(); }));
    studio_->session().setTakeRange(0, 1, 2);
    page_->choosePreset("blender");
    page_->form().also[ExportFormat::kBvh]->setChecked(true);
    page_->form().also[ExportFormat::kGlb]->setChecked(true);
    page_->form().run->setCurrentIndex(3);  // all of each take
    ASSERT_TRUE(waitFor([this] { return page_->plan() && fileCount(*page_->plan()) == 6; }));
    EXPECT_TRUE(page_->writeButton()->text().contains('6'));
    write();
    const ExportResults& results = *page_->results();
    ASSERT_EQ(results.outcomes.size(), 6U);
    EXPECT_EQ(results.faulty(), 0);
    std::set<std::string> kinds;
    QSet<QString> titles;
    for (const ExportOutcome& outcome : results.outcomes) {
        kinds.insert(outcome.path.substr(outcome.path.size() - 4));
        titles.insert(outcome.result);
    }
    EXPECT_EQ(kinds, (std::set<std::string>{".bvh", ".fbx", ".glb"}));
    EXPECT_EQ(titles.size(), 2);
    EXPECT_TRUE(titles.contains("2: Gyroscopes only"));
}

TEST_F(ExportPageTest, WhatReviewShowsGoesOut) {
    const std::string first = studio_->take().overview()->runs[0].run.name;
    ProcessRequest gyroscopes_only;
    gyroscopes_only.take_path = takePath("swing_001").toStdString();
    gyroscopes_only.tracker.sensors = {false, true, false};
    studio_->process(gyroscopes_only);
    ASSERT_TRUE(waitFor([this] { return studio_->take().overview()->runs.size() == 2 && jobsAreDone(); }));
    studio_->take().setShownRun(0);
    EXPECT_EQ(page_->plan()->front().request.run, first) << "not the trial after it";
    studio_->take().setShownRun(1);
    write();
    EXPECT_EQ(page_->results()->outcomes[0].result, "2: Gyroscopes only");
}

TEST_F(ExportPageTest, InToOutOfTheTakeIsExported) {
    studio_->session().setTakeRange(0, 1, 2);
    page_->form().frames->setCurrentIndex(page_->form().frames->findData(60.0));
    write();
    EXPECT_EQ(page_->results()->outcomes[0].check.frames, 61U);
    EXPECT_TRUE(page_->results()->outcomes[0].check.ok());
}

TEST_F(ExportPageTest, EveryTakeMayGoOutWithAResultOfItsOwn) {
    ProcessRequest gyroscopes_only;
    gyroscopes_only.take_path = takePath("swing_001").toStdString();
    gyroscopes_only.tracker.sensors = {false, true, false};
    studio_->process(gyroscopes_only);
    ASSERT_TRUE(waitFor([this] { return studio_->take().overview()->runs.size() == 2 && jobsAreDone(); }));
    const std::string first = studio_->take().overview()->runs[0].run.name;

    page_->form().run->setCurrentIndex(2);  // chosen for each take
    ExportTakeList& takes = page_->form().takeList();
    ASSERT_TRUE(waitFor([&] { return takes.resultsOf("swing_001") != nullptr; }));
    EXPECT_EQ(page_->plan()->front().request.run, "") << "the last";
    takes.resultsOf("swing_001")->setCurrentIndex(0);
    EXPECT_EQ(page_->plan()->front().request.run, first);
    const QPointer<QComboBox> box = takes.resultsOf("swing_001");
    studio_->take().setShownRun(0);
    ASSERT_TRUE(waitFor([&] { return jobsAreDone(); }));
    EXPECT_TRUE(box) << "what is known is not read again";
    studio_->session().renameTake(0, "kick");
    ASSERT_TRUE(page_->plan()) << "it stays ticked: " << page_->plan().error().text();
    EXPECT_EQ(page_->plan()->front().request.run, first) << "and its result chosen";
    write();
    ASSERT_FALSE(page_->results()->outcomes[0].error);
    EXPECT_EQ(page_->results()->outcomes[0].check.run, first);
}

TEST_F(ExportPageTest, SaysWhatIsInTheWay) {
    page_->form().name_pattern->setText("{what}");
    EXPECT_FALSE(page_->plan());
    EXPECT_NE(page_->plan().error().text().find("{what}"), std::string::npos);
    EXPECT_TRUE(page_->writeButton()->toolTip().contains("{what}"));
    page_->form().name_pattern->setText("{take}");
    EXPECT_TRUE(page_->plan());
    page_->form().setTakes({});
    EXPECT_FALSE(page_->plan());
}

TEST_F(ExportPageTest, TablesWithAnglesAreChecked) {
    page_->choosePreset("angles");
    write();
    const ExportCheck& check = page_->results()->outcomes[0].check;
    EXPECT_TRUE(check.ok()) << check.faults[0];
    EXPECT_TRUE(check.has_angles);
    EXPECT_TRUE(checkAsText(*page_->results()).contains("Largest difference"));
}

TEST_F(ExportPageTest, EveryPresetWritesAFileThatHoldsTheTake) {
    const std::pair<const char*, const char*> presets[] = {{"motionbuilder", "swing_001_120.fbx"},
                                                           {"blender", "swing_001_60.fbx"},
                                                           {"unity", "swing_001_60_2.fbx"},
                                                           {"unreal", "swing_001_60_3.fbx"},
                                                           {"web", "swing_001_60.glb"},
                                                           {"opensim", "swing_001_120.mot"}};
    studio_->session().setTakeRange(0, 1, 2);
    for (const auto& [preset, name] : presets) {
        page_->choosePreset(preset);
        page_->enter();
        write();
        ASSERT_EQ(page_->results()->outcomes.size(), 1U);
        const ExportOutcome& outcome = page_->results()->outcomes[0];
        ASSERT_FALSE(outcome.error) << outcome.error->text();
        EXPECT_TRUE(outcome.check.ok()) << preset << ": " << outcome.check.faults[0];
        EXPECT_EQ(outcome.path, exported(name));
    }
}

TEST_F(ExportPageTest, TheFormOffersWhatTheFormatHas) {
    ExportForm& form = page_->form();
    const auto choose = [&](ExportFormat format) {
        form.format->setCurrentIndex(form.format->findData(static_cast<int>(format)));
    };
    choose(ExportFormat::kFbx);
    EXPECT_TRUE(form.unit->isEnabled() && form.names->isEnabled() && form.body->isEnabled());
    form.body->setCurrentIndex(form.body->findData(static_cast<int>(ExportBody::kSkeleton)));
    form.names->setCurrentIndex(1);
    EXPECT_FALSE(page_->plan()->front().request.with_body);
    EXPECT_EQ(page_->plan()->front().request.names, JointNames::kHumanIk);
    EXPECT_EQ(page_->plan()->front().request.bvh_path, "");
    choose(ExportFormat::kGlb);
    EXPECT_FALSE(form.unit->isEnabled());
    EXPECT_EQ(form.unit->currentData().toDouble(), 1) << "always metres";
    choose(ExportFormat::kSto);
    EXPECT_FALSE(form.names->isEnabled() || form.body->isEnabled());
    EXPECT_TRUE(form.names->toolTip().contains("OpenSim"));
    EXPECT_TRUE(form.angles->isHidden());
    choose(ExportFormat::kFbx);
    EXPECT_EQ(form.unit->currentData().toDouble(), 0.01) << "as it was";
}

TEST_F(ExportPageTest, ATypedFileNameStaysUntilItIsCleared) {
    QLineEdit& name = *page_->form().name_pattern;
    const QString of_preset = name.text();
    const auto file = [this] { return page_->plan().value().front().path(); };
    name.selectAll();
    QTest::keyClicks(&name, "{take}_final");
    page_->choosePreset("web");
    EXPECT_EQ(name.text(), "{take}_final");
    EXPECT_EQ(file(), exported("swing_001_final.glb"));
    page_ = std::make_unique<ExportPage>(*studio_);
    page_->form().setTakes({"swing_001"});
    page_->choosePreset("blender");
    EXPECT_EQ(page_->form().name_pattern->text(), "{take}_final") << "also after a new start";
    page_->form().name_pattern->clear();
    EXPECT_TRUE(page_->plan()) << "the preset has a name of its own";
    EXPECT_EQ(page_->form().name_pattern->placeholderText(), of_preset);
    for (const char* preset : {"web", "bvh", "blender"}) {
        page_->choosePreset(preset);
        EXPECT_EQ(page_->form().name_pattern->text(), of_preset) << preset;
    }
}

/// Its window stays as large as it is.
TEST_F(ExportPageTest, SmallerTextHasRoomForBothSides) {
    const auto besideTakes = [&] { return page_->form().takesPart()->mapTo(page_.get(), QPoint()).x() > 0; };
    page_->resize(700, 700);
    ASSERT_TRUE(waitFor([&] { return !besideTakes(); }));
    Theme::get().setScale(0.75);
    EXPECT_TRUE(QTest::qWaitFor(besideTakes, 1000));
    Theme::get().setScale(1);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !besideTakes(); }, 1000));
}

}  // namespace
}  // namespace noctule::ui
