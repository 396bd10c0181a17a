// SPDX-License-Identifier: Apache-2.0
// How the picture of a mesh and its landmarks looks.
#include <QPainter>
#include <algorithm>

#include "ui/style/paint.h"
#include "ui/style/theme.h"
#include "ui/views/performer/landmark_picture.h"

namespace noctule::ui {
namespace {

constexpr double kPoint_px = 4, kChosen_px = 5.5, kLine_px = 1.5, kBone_px = 1;
constexpr int kTagInset = 8, kTag = 22;

}  // namespace

void LandmarkPicture::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), Theme::get().tokens().line);
    for (Pane& pane : panes_) {
        painter.setClipRect(pane.rect);
        paintPane(painter, pane);
    }
    painter.setClipping(false);
    const QString words[] = {tr("From the front"), tr("From its left")};
    painter.setFont(Theme::get().font(TextRole::kCaption));
    painter.setPen(Theme::get().tokens().t2);
    const int inset = Theme::get().px(kTagInset);
    for (size_t p = 0; p < panes_.size(); ++p)
        painter.drawText(panes_[p].rect.adjusted(inset, inset, -inset, -inset), Qt::AlignLeft | Qt::AlignTop,
                         words[p]);
    painter.drawText(panes_[kFront].rect.adjusted(inset, inset, -inset, -inset),
                     Qt::AlignRight | Qt::AlignTop, tr("its left"));
}

void LandmarkPicture::paintPane(QPainter& painter, Pane& pane) {
    const Tokens& tokens = Theme::get().tokens();
    if (pane.drawn.isNull() && surface_)
        pane.drawn = painter_.draw(surface_, pane.camera, pane.size(), devicePixelRatioF());
    if (pane.drawn.isNull())
        painter.fillRect(pane.rect, tokens.view);
    else
        painter.drawImage(pane.rect.topLeft(), pane.drawn);
    painter.setPen(QPen(tokens.t2, kBone_px));
    for (const auto& [from, to] : landmarkBones())
        if (places_.contains(from) && places_.contains(to))
            painter.drawLine(onScreen(pane, places_.at(from)), onScreen(pane, places_.at(to)));
    const Vector3d towards_viewer = pane.camera.axes().col(2);
    std::vector<std::string> names;
    for (const auto& [name, p_m] : places_)
        names.push_back(name);
    std::ranges::stable_sort(names, {},
                             [&](const std::string& name) { return towards_viewer.dot(places_.at(name)); });
    for (const std::string& name : names)
        paintPoint(painter, pane, name, places_.at(name));
    for (const std::string& name : {twin_, chosen_})  // above the others
        if (places_.contains(name))
            paintPoint(painter, pane, name, places_.at(name));
    const bool is_touched = &pane == &panes_[last_pane_];
    if (is_touched && places_.contains(hovered_) && hovered_ != chosen_)
        paintName(painter, pane, hovered_);
    else if (is_touched && places_.contains(chosen_))
        paintName(painter, pane, chosen_);
}

/// The chosen one is full, the other side's a thicker ring.
void LandmarkPicture::paintPoint(QPainter& painter, const Pane& pane, const std::string& landmark,
                                 const Vector3d& p_m) {
    const Theme& theme = Theme::get();
    const bool is_chosen = landmark == chosen_, is_hovered = landmark == hovered_;
    const double radius =
        theme.scale() * (is_chosen || is_hovered || landmark == twin_ ? kChosen_px : kPoint_px);
    const Tokens& tokens = theme.tokens();
    painter.setBrush(is_chosen ? tokens.acc : tokens.panel);
    painter.setPen(QPen(is_chosen ? tokens.onacc : tokens.acc, landmark == twin_ ? 2 * kLine_px : kLine_px));
    painter.drawEllipse(onScreen(pane, p_m), radius, radius);
}

/// Above its point (at the top edge below it), where it hides least.
void LandmarkPicture::paintName(QPainter& painter, const Pane& pane, const std::string& landmark) {
    const Theme& theme = Theme::get();
    painter.setFont(theme.font(TextRole::kSecondary));
    const QString name = landmarkName(landmark);
    const int inset = theme.px(kTagInset), height = theme.px(kTag);
    const QPointF at = onScreen(pane, places_.at(landmark));
    QRect tag(0, 0, painter.fontMetrics().horizontalAdvance(name) + 2 * inset, height);
    tag.moveCenter(at.toPoint());
    tag.moveLeft(std::max(std::min(tag.left(), pane.rect.right() - tag.width()), pane.rect.left()));
    const int above = tag.top() - height / 2 - inset - static_cast<int>(kChosen_px);
    tag.moveTop(above >= pane.rect.top() ? above
                                         : tag.top() + height / 2 + inset + static_cast<int>(kChosen_px));
    paintBox(painter, tag, theme.px(4), theme.tokens().raised, theme.tokens().line);
    painter.setPen(theme.tokens().t1);
    painter.drawText(tag, Qt::AlignCenter, name);
}

}  // namespace noctule::ui
