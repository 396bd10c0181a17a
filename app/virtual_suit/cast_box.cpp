// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_suit/cast_box.h"

#include <QDateTime>
#include <cmath>

#include "app/batch/cast_request.h"
#include "app/virtual_suit/clock.h"
#include "app/virtual_suit/simulated_source.h"

namespace noctule::virtual_suit {
namespace {

constexpr double kLongestCast_s = 86400;

/// On the clock of nowNs().
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
    if (std::abs(static_cast<double>(now_ms - start_ms)) > kLongestCast_s * 1e3)
        return Error{ErrorKind::kUsage, "--start-at " + text + " is more than a day away",
                     "Give an instant within a day of now, the same for all boxes"};
    return now_ns + (start_ms - now_ms) * 1'000'000;
}

std::string namesIn(const simulation::Cast& cast) {
    std::vector<std::string> names;
    for (const simulation::CastSuit& suit : cast.suits)
        names.push_back(suit.isRoom() ? "room" : suit.name);
    return batch::listed(names);
}

}  // namespace

Result<SoundOfSuit> openCastBox(const Options& options) {
    const auto start_ns = startInstant(options.arguments.text("start-at"));
    if (!start_ns)
        return start_ns.error();
    batch::Console console(false, false);
    auto request = batch::castRequest(options.arguments.text("cast"), options.arguments, console, 0);
    if (!request)
        return request.error();
    if (options.loop())
        request->comes_back_s = kLongestCast_s;
    auto cast = prepareCast(*request);
    if (!cast)
        return cast.error();
    const std::string name = options.arguments.text("subject");
    const int suit = cast->find(name);
    if (suit < 0)
        return Error{ErrorKind::kUsage,
                     options.arguments.text("cast") + ": nobody in the cast is called " + name,
                     "Give --subject " + namesIn(*cast)};
    return makeCastSource(std::move(*cast), static_cast<size_t>(suit), *start_ns);
}

}  // namespace noctule::virtual_suit
