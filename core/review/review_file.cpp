// SPDX-License-Identifier: Apache-2.0
#include "core/review/review_file.h"

namespace noctule {

Result<ViewedTake> ViewedTake::open(const TakeView& view) {
    auto take = Take::open(view.path);
    if (!take)
        return take.error();
    auto subjects = take->subjects();
    if (!subjects)
        return subjects.error();
    std::erase_if(*subjects, [](const TakeSubject& subject) { return subject.room; });
    const auto markers = markerClock(*take);
    if (!markers)
        return markers.error();
    const int suit = view.suit == kSuitInView ? markers->suit : view.suit;
    take->view(suit);
    return ViewedTake{std::move(*take), std::move(*subjects), suit, *markers};
}

Result<ReviewFile> ReviewFile::open(const TakeView& view) {
    auto viewed = ViewedTake::open(view);
    if (!viewed)
        return viewed.error();
    const auto rate_hz = viewed->take.sampleRate_hz();
    if (!rate_hz)
        return rate_hz.error();
    const SuitClock clock = viewed->take.suitClock();
    return ReviewFile{std::move(viewed->take), viewed->suit, static_cast<double>(*rate_hz), clock};
}

}  // namespace noctule
