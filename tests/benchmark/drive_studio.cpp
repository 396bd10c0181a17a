// SPDX-License-Identifier: Apache-2.0
// Uses the studio as an operator does, without the pauses in between: each round is what is done in a minute,
// and after each round it says what memory the process holds. `drive_studio TAKE TAKE ROUNDS` on a screen;
// `packaging/acceptance.sh studio` starts it and judges the slope.
#include <malloc.h>
#include <unistd.h>

#include <QApplication>
#include <QDialog>
#include <QFile>
#include <QTimer>
#include <cstdio>
#include <random>

#include "tests/benchmark/studio_stage.h"
#include "ui/plots/plot_panel.h"
#include "ui/style/theme.h"
#include "ui/views/export/export_page.h"
#include "ui/views/review/review_page.h"

namespace noctule::ui {
namespace {

constexpr int kPlay_ms = 1500, kScrubSteps = 40, kGlance_ms = 60;
constexpr int kProcessEvery = 6, kExportEvery = 6, kDialogEvery = 5, kScaleEvery = 10;

class Operator {
public:
    explicit Operator(bench::StudioStage& stage) : stage_(stage), studio_(stage.studio()) {}

    bool openSession(const QStringList& takes) {
        if (!studio_.session().create(stage_.folder() + "/hour", "hour"))
            return false;
        studio_.session().importTakes(takes);
        return stage_.until([&] { return studio_.session().session().takes.size() == 2; }) && stage_.settle();
    }

    /// False: something that was asked for did not happen; `failed` says what.
    bool round(int number) {
        return openTake(number % 2) && look(number) && play() && scrub() && visitPages() &&
               (number % kProcessEvery || process(number)) && (number % kExportEvery || exportTake()) &&
               (number % kDialogEvery || readShortcuts()) && changeLook(number);
    }
    const char* failed() const { return failed_; }

private:
    bool expect(bool happened, const char* what) {
        failed_ = happened ? failed_ : what;
        return happened;
    }

    bool openTake(int index) {
        stage_.window().goTo(Step::kReview);
        studio_.session().setCurrentTake(index);
        return expect(stage_.until([&] { return stage_.hasBodyAndPlots(); }) && stage_.settle(),
                      "opening a take");
    }

    /// Another pair, joint and tab, the ghost on and off, a part of the take.
    bool look(int number) {
        studio_.selection().setPair(number % 8, number % 18);
        studio_.selection().setJoint(number % 3 ? "LeftLeg" : "RightForeArm");
        if (auto* plots = stage_.window().findChild<PlotPanel*>())
            plots->setOn(static_cast<PlotTab>(number % kPlotTabs), number % 4 < 2);
        studio_.take().setComparedRun(number % 3 ? TakeDocument::kReference : -1);
        const double length_s = studio_.time().duration();
        studio_.time().setRange(number % 2 ? 0.2 * length_s : 0, length_s);
        return expect(stage_.settle(), "another pair, joint and part");
    }

    bool play() {
        studio_.time().play();
        stage_.run(kPlay_ms);
        studio_.time().pause();
        return true;
    }

    bool scrub() {
        std::uniform_real_distribution<double> any(0, studio_.time().duration());
        bool painted = true;
        for (int i = 0; i < kScrubSteps && painted; ++i)
            painted = stage_.show(any(random_));
        return expect(painted, "painting after the cursor moved");
    }

    bool visitPages() {
        for (const Step step : {Step::kStart, Step::kConnect, Step::kCalibrate, Step::kRecord, Step::kExport,
                                Step::kPerformer, Step::kReview}) {
            stage_.window().goTo(step);
            stage_.run(kGlance_ms);
        }
        return true;
    }

    bool process(int number) {
        ProcessRequest request;
        request.take_path = studio_.take().path().toStdString();
        request.tracker.sensors = {number % 4 == 0, true, true};
        const size_t before = studio_.take().overview()->runs.size();
        dynamic_cast<ReviewPage&>(stage_.window().page(Step::kReview)).process(request);
        return expect(
            stage_.until([&] { return studio_.take().overview()->runs.size() > before; }, 300'000) &&
                stage_.settle(),
            "processing");
    }

    bool exportTake() {
        stage_.window().goTo(Step::kExport);
        auto& page = dynamic_cast<ExportPage&>(stage_.window().page(Step::kExport));
        page.write();
        return expect(
            stage_.until([&] { return page.results() && page.results()->written() > 0; }) && stage_.settle(),
            "exporting");
    }

    bool readShortcuts() {
        QTimer::singleShot(200, qApp, [] {
            if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget()))
                dialog->reject();
        });
        stage_.window().showShortcuts();
        return true;
    }

    bool changeLook(int number) {
        Theme& theme = Theme::get();
        for (const Scheme scheme : {Scheme::kLight, Scheme::kDark}) {
            theme.setScheme(scheme);
            stage_.run(kGlance_ms);
        }
        if (number % kScaleEvery == 0)
            for (const double scale : {1.25, 1.0}) {
                theme.setScale(scale);
                stage_.run(kGlance_ms);
            }
        return true;
    }

    bench::StudioStage& stage_;
    Studio& studio_;
    std::mt19937 random_{1};
    const char* failed_ = "";
};

double resident_mb() {
    QFile file(QStringLiteral("/proc/self/statm"));
    if (!file.open(QIODevice::ReadOnly))
        return 0;
    return file.readAll().split(' ').value(1).toDouble() * static_cast<double>(sysconf(_SC_PAGESIZE)) * 1e-6;
}

/// What has been asked for and not given back, without what the allocator keeps.
double inUse_mb() {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd) * 1e-6;
}

int drive(const QStringList& takes, int rounds) {
    bench::StudioStage stage;
    Operator who(stage);
    if (!who.openSession(takes)) {
        std::fputs("drive_studio: the session does not open\n", stderr);
        return 1;
    }
    for (int number = 1; number <= rounds; ++number) {
        if (!who.round(number)) {
            std::fprintf(stderr, "drive_studio: round %d: %s\n", number, who.failed());
            return 1;
        }
        std::printf("round %d resident_mb %.2f in_use_mb %.2f\n", number, resident_mb(), inUse_mb());
        std::fflush(stdout);
    }
    return 0;
}

}  // namespace
}  // namespace noctule::ui

int main(int argc, char** argv) {
    noctule::ui::bench::prepareApplication();
    QApplication application(argc, argv);
    noctule::ui::bench::dressApplication();
    const QStringList words = application.arguments();
    if (words.size() != 4 || words[3].toInt() < 1) {
        std::fputs("drive_studio TAKE TAKE ROUNDS\n", stderr);
        return 2;
    }
    return noctule::ui::drive({words[1], words[2]}, words[3].toInt());
}
