// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_suit/start_instant.h"

#include <QDateTime>
#include <cmath>

#include "app/virtual_suit/clock.h"

namespace noctule::virtual_suit {

Result<int64_t> startInstant(const std::string& text) {
    const qint64 now_ms = QDateTime::currentMSecsSinceEpoch();
    const int64_t now_ns = nowNs();
    if (text == "now")
        return now_ns;
    const QDateTime instant = QDateTime::fromString(QString::fromStdString(text), Qt::ISODateWithMs);
    if (!instant.isValid() || instant.timeSpec() == Qt::LocalTime)
        return Error{ErrorKind::kUsage, "--start-at " + text + " is no instant of UTC",
                     "Write it as 2026-05-01T10:00:00Z"};
    const qint64 start_ms = instant.toMSecsSinceEpoch();
    if (std::abs(static_cast<double>(now_ms - start_ms)) > kLongestWait_s * 1e3)
        return Error{ErrorKind::kUsage, "--start-at " + text + " is more than a day away",
                     "Give an instant within a day of now, the same for all boxes"};
    return now_ns + (start_ms - now_ms) * 1'000'000;
}

}  // namespace noctule::virtual_suit
