// SPDX-License-Identifier: Apache-2.0
#include "ui/views/review/take_range.h"

#include <QScopedValueRollback>
#include <cmath>

#include "ui/style/words.h"
#include "ui/views/open_take.h"

namespace noctule::ui {

namespace {

constexpr int kRangePause_ms = 400;
constexpr double kSame_s = 1e-4;

bool same(double a_s, double b_s) {
    return std::abs(a_s - b_s) < kSame_s;
}

}  // namespace

TakeRange::TakeRange(ReviewContext& review, QObject* parent) : QObject(parent), review_(review) {
    pause_.setSingleShot(true);
    pause_.setInterval(kRangePause_ms);
    connect(&pause_, &QTimer::timeout, this, &TakeRange::writeDragged);
    connect(&review.time(), &TimeCursor::rangeChanged, this, [this] {
        if (!reading_)
            pause_.start();
    });
    connect(&review.time(), &TimeCursor::choosingRange, this, [this] {
        if (pause_.isActive())
            writeDragged();
    });
    connect(&review.time(), &TimeCursor::rangeChosen, this, &TakeRange::choose);
    connect(&review.take(), &TakeDocument::opened, this, [this] {
        pause_.stop();  // the new take's whole extent is no choice of the operator
        read();
    });
    connect(&review.shared().session(), &SessionModel::changed, this, &TakeRange::read);
    read();
}

void TakeRange::read() {
    const int index = openTakeIndex(review_);
    if (index < 0 || pause_.isActive())
        return;
    const SessionTake& take = review_.shared().session().session().takes[static_cast<size_t>(index)];
    TimeCursor& time = review_.time();
    const double out_s = take.out_s > 0 ? take.out_s : time.duration();
    const QScopedValueRollback<bool> quiet(reading_, true);
    if (!same(take.in_s, time.in()) || !same(out_s, time.out()))
        time.setRange(take.in_s, out_s);
}

/// A step of its own, which can be taken back at once, and is told.
void TakeRange::choose() {
    pause_.stop();
    write();
    const TimeCursor& time = review_.time();
    review_.shared().say(tr("In is at %1, out at %2.").arg(timeText(time.in(), 2), timeText(time.out(), 2)));
}

/// A drag that rests in between is one step all the same.
void TakeRange::writeDragged() {
    pause_.stop();
    const int index = openTakeIndex(review_);
    if (index < 0)
        return;
    const SessionTake& take = review_.shared().session().session().takes[static_cast<size_t>(index)];
    write(QString("range/%1/%2")
              .arg(same(take.in_s, review_.time().in()) ? "out" : "in", QString::fromStdString(take.name)));
}

void TakeRange::write(const QString& merge_key) {
    const int index = openTakeIndex(review_);
    if (index < 0)
        return;
    const SessionTake& take = review_.shared().session().session().takes[static_cast<size_t>(index)];
    const TimeCursor& time = review_.time();
    const double out_s = same(time.out(), time.duration()) ? 0 : time.out();
    if (!same(take.in_s, time.in()) || !same(take.out_s, out_s))
        review_.shared().session().setTakeRange(index, time.in(), out_s, merge_key);
}

}  // namespace noctule::ui
