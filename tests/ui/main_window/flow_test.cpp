// SPDX-License-Identifier: Apache-2.0
// The way of a take through the studio: start page, virtual suit, Review, processing with gyroscopes only,
// comparison, export; and the file is byte for byte the one that the program writes without a screen.
#include <filesystem>

#include "core/job/atomic_file.h"
#include "tests/support/program_run.h"
#include "tests/ui/main_window/studio_fixture.h"
#include "ui/views/export/export_page.h"
#include "ui/views/review/choice_row.h"
#include "ui/views/review/reprocess_dialog.h"
#include "ui/views/review/review_page.h"
#include "ui/widgets/button.h"

namespace noctule::ui {
namespace {

class Flow : public test::StudioWindow {
protected:
    const TakeOverview& overview() { return *studio_->take().overview(); }

    /// Fills in the dialog of "Reprocess" and hands its request on, as the page does after Enter.
    ProcessRequest processWithGyroscopesOnly() {
        ReprocessDialog dialog(*studio_, overview(), window_.get());
        dialog.accelerometers->setChecked(false);
        dialog.distances->setChecked(false);
        const ProcessRequest request = dialog.request();
        dynamic_cast<ReviewPage&>(window_->page(Step::kReview)).process(request);
        return request;
    }

    /// The same two jobs done by `noctule --batch` to another copy of the take.
    static std::string exportedByProgram(const std::string& take, const ProcessRequest& process,
                                         const ExportRequest& studio, const std::string& bvh) {
        using noctule::test::batch;
        const noctule::test::Ran processed =
            batch({"process", take, "--sensors", "G", "--root", process.tracker.root_given ? "given" : "free",
                   "--smooth", smootherName(process.tracker.smoother)});
        EXPECT_EQ(processed.exit_code, 0) << processed.err;
        std::vector<std::string> words{"export", take, "--bvh", bvh};
        words.insert(words.end(), {"--fps", std::to_string(studio.frames_per_second)});
        const noctule::test::Ran exported = batch(words);
        EXPECT_EQ(exported.exit_code, 0) << exported.err;
        const auto written = readWholeFile(bvh);
        return written ? *written : written.error().text();
    }
};

TEST_F(Flow, FromTheStartPageToAnExportedFile) {
    openSampleTake();
    ASSERT_TRUE(studio_->session().isOpen());
    ASSERT_EQ(overview().runs.size(), 1U);
    ASSERT_TRUE(waitFor([this] { return studio_->take().shownMotion() != nullptr; }));
    EXPECT_GT(studio_->take().shownMotion()->frames.size(), 300U);

    const std::string unprocessed = folder_.filePath("unprocessed.noctule").toStdString();
    std::filesystem::copy_file(overview().path, unprocessed);
    const ProcessRequest process = processWithGyroscopesOnly();
    ASSERT_TRUE(waitFor([this] { return overview().runs.size() == 2; }));
    EXPECT_EQ(overview().runs[0].settings.sensors, "AGD");
    EXPECT_EQ(overview().runs[1].settings.sensors, "G");
    EXPECT_TRUE(
        waitFor([this] { return studio_->take().shownRun() == 1 && studio_->take().comparedRun() == 0; }));
    ASSERT_TRUE(waitFor([this] { return studio_->take().comparedMotion() != nullptr; }));

    QTest::keyClick(window_.get(), Qt::Key_E, Qt::ControlModifier);
    ASSERT_EQ(window_->step(), Step::kExport);
    auto& page = dynamic_cast<ExportPage&>(window_->page(Step::kExport));
    page.choosePreset("bvh");
    const auto plan = page.plan();
    ASSERT_TRUE(plan) << plan.error().text();
    ASSERT_EQ(plan->size(), 1U);
    QTest::mouseClick(page.writeButton(), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return page.results().has_value(); }));
    ASSERT_EQ(page.results()->written(), 1);
    EXPECT_EQ(page.results()->faulty(), 0);

    const ExportRequest& request = plan->front().request;
    const auto in_studio = readWholeFile(request.bvh_path);
    ASSERT_TRUE(in_studio) << in_studio.error().text();
    EXPECT_GT(in_studio->size(), 100'000U);
    EXPECT_EQ(*in_studio,
              exportedByProgram(unprocessed, process, request, folder_.filePath("batch.bvh").toStdString()));
}

TEST_F(Flow, ATakeWhoseFullReportWasReadCanBeLeft) {
    openSampleTake();
    ASSERT_TRUE(waitFor([this] { return studio_->take().report() && studio_->jobs().idle(); }));
    studio_->session().setCurrentTake(-1);
    EXPECT_FALSE(studio_->take().isOpen());
}

TEST_F(Flow, TwoClicksFromTheStartToAMovingBody) {
    openSampleTake();  // the first click
    ASSERT_TRUE(waitFor([this] { return studio_->take().shownMotion() != nullptr; }));
    const double before = studio_->time().time();
    if (!studio_->time().isPlaying())
        studio_->time().play();  // what the second click does
    QTest::qWait(300);
    EXPECT_GT(studio_->time().time(), before);
}

}  // namespace
}  // namespace noctule::ui
