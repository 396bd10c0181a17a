// SPDX-License-Identifier: Apache-2.0
// The answer of a screen, at top right: icon, verdict ("Good take"), and one or two sentences why.
#pragma once

#include <QWidget>

#include "ui/style/ink.h"
#include "ui/style/theme.h"

class QBoxLayout;

namespace noctule::ui {

class IconLabel;
class Label;

class VerdictHeader : public QWidget {
    Q_OBJECT
public:
    explicit VerdictHeader(QWidget* parent = nullptr);

    void setVerdict(Tone tone, const QString& verdict, const QString& text);
    /// 20 px in docks (the default), 15 px in cards that hold one of several verdicts, 26 px on result pages.
    void setRole(TextRole role);
    void setCompact(bool compact) { setRole(compact ? TextRole::kSection : TextRole::kPage); }

private:
    void restyle();

    Tone tone_ = Tone::kNeutral;
    TextRole role_ = TextRole::kPage;
    QBoxLayout* head_;
    IconLabel* icon_;
    Label* verdict_;
    Label* text_;
};

}  // namespace noctule::ui
