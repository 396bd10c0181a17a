// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmark/studio_stage.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QSettings>
#include <QStandardPaths>
#include <QTimer>
#include <QWindow>
#include <algorithm>
#include <clocale>

#include "core/job/heap.h"
#include "ui/plots/plot_panel.h"
#include "ui/scene/scene_canvas.h"
#include "ui/style/theme.h"

namespace noctule::ui::bench {
namespace {

template <class Widget>
std::vector<Widget*> visibleOnes(QWidget& window) {
    std::vector<Widget*> found;
    for (Widget* widget : window.findChildren<Widget*>())
        if (widget->isVisible())
            found.push_back(widget);
    return found;
}

}  // namespace

/// Quits a loop when the plots and every 3D view that is seen have been painted.
class StudioStage::Painted : public QObject {
public:
    Painted(QWidget& window, QEventLoop& loop) : loop_(loop) {
        for (SceneCanvas* canvas : visibleOnes<SceneCanvas>(window)) {
            missing_.push_back(canvas);
            connect(canvas, &SceneCanvas::shown, this,
                    [this, canvas, before = canvas->lastAsked()](quint64 number) {
                        if (number > before)
                            came(canvas);
                    });
        }
        for (LaneStack* stack : visibleOnes<LaneStack>(window)) {
            missing_.push_back(stack);
            for (QObject* child : stack->children())
                child->installEventFilter(this);
        }
    }

    bool eventFilter(QObject* object, QEvent* event) override {
        if (event->type() == QEvent::Paint)
            came(object->parent());
        return false;
    }

private:
    void came(QObject* what) {
        std::erase(missing_, what);
        if (missing_.empty())  // painting ends with what follows on the screen: after it
            QTimer::singleShot(0, &loop_, &QEventLoop::quit);
    }

    QEventLoop& loop_;
    std::vector<QObject*> missing_;
};

void prepareApplication() {
    shareHeaps();
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
    QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
}

void dressApplication() {
    std::setlocale(LC_NUMERIC, "C");
    QApplication::setOrganizationName("Noctule");
    QApplication::setApplicationName("noctule-bench");
    QSettings::setDefaultFormat(QSettings::IniFormat);
    Theme::install(*qApp);
}

StudioStage::StudioStage(StudioParts parts) {
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.filePath("settings"));
    QSettings().setValue("folders/sessions", folder_.filePath("sessions"));
    parts.software = "noctule 0.1.0";
    parts.utc_now = [] { return std::string("2026-01-01T00:00:00Z"); };
    studio_ = std::make_unique<Studio>(std::move(parts));
    window_ = std::make_unique<MainWindow>(*studio_);
    window_->show();
    until([this] { return window_->windowHandle()->isExposed(); });
    run(200);
}

StudioStage::~StudioStage() {
    window_.reset();
    studio_.reset();
}

bool StudioStage::until(const std::function<bool()>& done, int timeout_ms) {
    QElapsedTimer clock;
    clock.start();
    QTimer beat;  // jobs report by themselves; this only lets the clock be seen
    beat.start(5);
    while (!done()) {
        if (clock.hasExpired(timeout_ms))
            return false;
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    return true;
}

void StudioStage::run(int ms) {
    QEventLoop loop;
    QTimer::singleShot(ms, &loop, &QEventLoop::quit);
    loop.exec();
}

bool StudioStage::settle() {
    const bool idle = until([this] { return studio_->jobs().idle() && !studio_->take().isLoading(); });
    run(100);
    return idle;
}

bool StudioStage::hasBodyAndPlots() {
    TakeDocument& take = studio_->take();
    const auto panels = visibleOnes<PlotPanel>(*window_);
    if (!take.isOpen() || !take.shownMotion() || panels.empty() || panels.front()->lanes().empty())
        return false;
    const auto& lanes = panels.front()->lanes();
    const bool reads = take.isLoading();
    return std::all_of(lanes.begin(), lanes.end(), [reads](PlotLane* lane) {
        const auto& curves = lane->content().curves;
        if (curves.empty())  // there are none in the take, or they come yet
            return !reads;
        return std::all_of(curves.begin(), curves.end(), [](const LaneCurve& curve) { return curve.value; });
    });
}

bool StudioStage::show(double t_s) {
    constexpr int kPatience_ms = 10'000;
    QEventLoop loop;
    Painted painted(*window_, loop);
    bool in_time = true;
    QTimer::singleShot(kPatience_ms, &loop, [&] {
        in_time = false;
        loop.quit();
    });
    studio_->time().setTime(t_s);
    loop.exec();
    return in_time;
}

}  // namespace noctule::ui::bench
