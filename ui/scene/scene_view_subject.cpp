// SPDX-License-Identifier: Apache-2.0
// What a 3D view shows: the take under review, a performer at rest, or a suit that is worn right now.
#include <algorithm>
#include <utility>

#include "ui/scene/scene_parts.h"
#include "ui/scene/scene_words.h"

namespace noctule::ui {

QString SceneView::whyNoBody() const {
    return parts_->live ? whyEmpty(*parts_->live) : whyEmpty(review_);
}

/// Null: nothing is shown that has one.
const Suit* SceneView::shownSuit() const {
    if (parts_->live)
        return &parts_->live->wearer().suit;
    return review_.take().pairSuit().get();
}

std::optional<SceneCallout> SceneView::callout() const {
    const Suit* suit = shownSuit();
    // Pairs are composed with the shown result only.
    const bool has_ranges =
        parts_->live || (parts_->composed.subject == SceneSubject::kShown && review_.take().ranges());
    return suit ? partCallout(*suit, review_.selection(), parts_->composed, has_ranges) : std::nullopt;
}

void SceneView::setFigure(const Actor& actor, const Suit& suit) {
    if (parts_->figure) {
        parts_->figure->setFigure(actor, suit);
    } else {
        parts_->figure.emplace(actor, suit);
        parts_->tools->setOffered(
            {SceneLayer::kMesh, SceneLayer::kSkeleton, SceneLayer::kBoards, SceneLayer::kGrid}, false);
        layOut();
    }
    updateMessage();
    refresh();
}

void SceneView::setSubject(SceneSubject subject) {
    parts_->take.setSubject(subject);
    refresh();
}

void SceneView::setBesideOther(bool beside) {
    parts_->beside_other = beside;
    refresh();
}

void SceneView::clearFigure() {
    parts_->figure.reset();
    parts_->tools->setOffered(
        {SceneLayer::kMesh, SceneLayer::kSkeleton, SceneLayer::kBoards, SceneLayer::kRays,
         SceneLayer::kTrails, SceneLayer::kContacts, SceneLayer::kGhost, SceneLayer::kGrid},
        true);
    layOut();
    updateMessage();
    refresh();
}

void SceneView::setLive(LiveWearer wearer) {
    if (!parts_->live) {
        parts_->live.emplace();
        parts_->tools->setOffered({SceneLayer::kMesh, SceneLayer::kSkeleton, SceneLayer::kBoards,
                                   SceneLayer::kRays, SceneLayer::kGrid},
                                  true);
        layOut();
    }
    parts_->live->setWearer(std::move(wearer));
    updateMessage();
    refresh();
}

void SceneView::setCompany(int performer, std::vector<LiveCompanion> others) {
    if (!parts_->live)
        return;
    const bool changes = others.size() != static_cast<size_t>(parts_->company);
    parts_->company = static_cast<int>(others.size());
    parts_->live->setCompany(performer, std::move(others));
    if (changes && parts_->untouched)
        parts_->framed.clear();
}

void SceneView::showFrame(std::shared_ptr<const LiveFrame> frame, bool is_lost, const FloorMove& floor) {
    if (!parts_->live || !parts_->canvas)
        return;
    if (frame)
        parts_->since_frame.start();
    const auto& before = parts_->live->frame();
    const bool begins_anew = frame && before && frame->sample < before->sample;  // another stream
    if (parts_->untouched && (begins_anew || !(floor == parts_->live->floor())))
        parts_->framed.clear();  // the body is where it began
    parts_->live->setFrame(std::move(frame), is_lost, floor);
    parts_->canvas->refresh(true);
}

void SceneView::noteShown(quint64 number) {
    Parts& parts = *parts_;
    const auto found = parts.asked.find(number);
    const Parts::Asked asked = found == parts.asked.end() ? Parts::Asked{} : found->second;
    parts.asked.erase(parts.asked.begin(), parts.asked.upper_bound(number));
    if (!parts.live || !asked.frame || asked.frame == parts.on_screen)
        return;
    parts.on_screen = asked.frame;
    parts.frame_delays.add(asked.since_frame.nsecsElapsed());
    emit frameDrawn(asked.frame);
}

const LatencyHistogram& SceneView::frameDelays() const {
    return parts_->frame_delays;
}

SuitPart SceneView::chosenPart() const {
    return parts_->figure ? parts_->figure->chosen() : SuitPart{};
}

void SceneView::setChosenPart(SuitPart part) {
    if (!parts_->figure)
        return;
    parts_->figure->choose(part);
    refresh();
}

void SceneView::extendByMotion(Eigen::AlignedBox3d& box) const {
    constexpr size_t kLooks = 200;
    constexpr double kFarthest_m = 4;  // over a longer way the body would be a dot
    const auto motion = review_.take().shownMotion();
    if (!motion)
        return;
    Eigen::AlignedBox3d reached;
    const size_t step = std::max<size_t>(1, motion->frames.size() / kLooks);
    for (size_t i = 0; i < motion->frames.size(); i += step)
        if (motion->frames[i].pose)
            reached.extend(placeBody(motion->skeleton, *motion->frames[i].pose, {}, nullptr).box());
    if (reached.isEmpty())
        return;
    const Vector3d way_m = reached.sizes(), centre_m = box.center();
    if (std::max(way_m.x(), way_m.z()) <= kFarthest_m)
        box.extend(reached);
    else
        box.extend(Vector3d(centre_m.x(), reached.max().y(), centre_m.z()));
}

}  // namespace noctule::ui
