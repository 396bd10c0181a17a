// SPDX-License-Identifier: Apache-2.0
// Which of the parts draws which of Qt's elements.
#include <QComboBox>
#include <QFrame>
#include <QTextEdit>
#include <QWidget>

#include "ui/style/icons.h"
#include "ui/style/paint.h"
#include "ui/style/studio_style.h"
#include "ui/style/style_parts.h"

namespace noctule::ui {

namespace {

QString arrowIcon(QStyle::PrimitiveElement element) {
    switch (element) {
        case QStyle::PE_IndicatorArrowUp:
            return "up";
        case QStyle::PE_IndicatorArrowRight:
            return "chevron";
        default:
            return "down";
    }
}

bool isTextField(const QWidget* widget) {
    return widget && (widget->inherits("QTextEdit") || widget->inherits("QPlainTextEdit"));
}

bool isInTextField(const QWidget* scroll_bar) {
    const QWidget* container = scroll_bar ? scroll_bar->parentWidget() : nullptr;
    return container && isTextField(container->parentWidget());
}

}  // namespace

void StudioStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                const QWidget* widget) const {
    const Tokens& tokens = theme_.tokens();
    switch (element) {
        case PE_FrameFocusRect:  // FocusRing draws it
        case PE_FrameTabBarBase:
        case PE_FrameTabWidget:
        case PE_FrameStatusBarItem:
        case PE_IndicatorDockWidgetResizeHandle:
        case PE_PanelMenuBar:
            return;
        case PE_IndicatorCheckBox:
        case PE_IndicatorItemViewItemCheck:
            return parts::paintCheckBox(*option, *painter, theme_);
        case PE_IndicatorRadioButton:
            return parts::paintRadioButton(*option, *painter, theme_);
        case PE_PanelLineEdit:
            if (const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option);
                frame && frame->lineWidth > 0)
                parts::paintEdit(*option, *painter, theme_);
            return;
        case PE_FrameLineEdit:
            return;
        case PE_Frame:
            if (widget && widget->inherits("QComboBoxPrivateContainer"))
                return paintBox(*painter, option->rect, 0, {}, tokens.edge);
            if (isTextField(widget))
                return paintBox(*painter, option->rect, 1, {},
                                option->state & State_HasFocus ? tokens.acc : tokens.edge);
            return paintBox(*painter, option->rect, 0, {}, tokens.line);
        case PE_PanelMenu:
        case PE_FrameMenu:
            return paintBox(*painter, option->rect, 0, tokens.raised, tokens.line);
        case PE_PanelTipLabel:
            return paintBox(*painter, option->rect, 0, tokens.raised, tokens.edge);
        case PE_FrameGroupBox:
            return paintBox(*painter, option->rect, theme_.px(8), {}, tokens.line);
        case PE_PanelButtonCommand:
            if (const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option))
                return parts::paintPushButton(*button, *painter, theme_);
            break;
        case PE_PanelButtonTool:
            return parts::paintToolButtonPanel(*option, *painter, theme_);
        case PE_PanelItemViewItem:
        case PE_PanelItemViewRow:
            if (const auto* item = qstyleoption_cast<const QStyleOptionViewItem*>(option))
                return parts::paintItem(*item, *painter, theme_);
            break;
        case PE_IndicatorArrowUp:
        case PE_IndicatorArrowDown:
        case PE_IndicatorArrowRight:
            return paintIcon(*painter, option->rect, arrowIcon(element), theme_.px(14), tokens.t2);
        case PE_IndicatorBranch:
            if (option->state & State_Children)
                paintIcon(*painter, option->rect, option->state & State_Open ? "down" : "chevron",
                          theme_.px(12), tokens.t2);
            return;
        case PE_IndicatorTabClose:
            return paintIcon(*painter, option->rect, "close", theme_.px(12),
                             option->state & State_MouseOver ? tokens.t1 : tokens.t3);
        case PE_IndicatorToolBarSeparator:
            painter->fillRect(QRect(option->rect.center().x(), option->rect.top() + theme_.px(4), 1,
                                    option->rect.height() - theme_.px(8)),
                              tokens.line);
            return;
        default:
            break;
    }
    QProxyStyle::drawPrimitive(element, option, painter, widget);
}

void StudioStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                              const QWidget* widget) const {
    const Tokens& tokens = theme_.tokens();
    switch (element) {
        case CE_PushButtonLabel:
            if (const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option)) {
                QStyleOptionButton label(*button);
                const bool filled = (button->features & QStyleOptionButton::DefaultButton) &&
                                    !(button->features & QStyleOptionButton::Flat);
                if (button->state & State_Enabled)
                    label.palette.setColor(QPalette::ButtonText, filled ? tokens.onacc : tokens.t1);
                painter->setFont(theme_.font(TextRole::kBody, true));
                return QProxyStyle::drawControl(element, &label, painter, widget);
            }
            break;
        case CE_MenuItem:
            if (const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option))
                return parts::paintMenuItem(*item, *painter, theme_);
            break;
        case CE_MenuBarItem:
            if (const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option))
                return parts::paintMenuBarItem(*item, *painter, theme_);
            break;
        case CE_MenuBarEmptyArea:
        case CE_SizeGrip:
        case CE_ProgressBarLabel:  // the words stand beside the bar
            return;
        case CE_TabBarTabShape:
            if (const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option))
                return parts::paintTab(*tab, *painter, theme_);
            break;
        case CE_TabBarTabLabel:
            if (const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option))
                return parts::paintTabLabel(*tab, *painter, theme_);
            break;
        case CE_HeaderSection:
        case CE_HeaderEmptyArea: {
            QStyleOptionHeader header;
            header.QStyleOption::operator=(*option);
            return parts::paintHeaderSection(header, *painter, theme_);
        }
        case CE_HeaderLabel:
            if (const auto* header = qstyleoption_cast<const QStyleOptionHeader*>(option)) {
                QStyleOptionHeader whole(*header);
                return parts::paintHeaderLabel(whole, *painter, theme_);
            }
            break;
        case CE_ProgressBarGroove:
            if (const auto* bar = qstyleoption_cast<const QStyleOptionProgressBar*>(option))
                return parts::paintProgressGroove(*bar, *painter, theme_);
            break;
        case CE_ProgressBarContents:
            if (const auto* bar = qstyleoption_cast<const QStyleOptionProgressBar*>(option))
                return parts::paintProgress(*bar, *painter, theme_);
            break;
        case CE_Splitter:
            painter->fillRect(option->rect, tokens.line);
            return;
        case CE_DockWidgetTitle:
            if (const auto* dock = qstyleoption_cast<const QStyleOptionDockWidget*>(option))
                return parts::paintDockTitle(*dock, *painter, theme_);
            break;
        case CE_RubberBand:
            painter->fillRect(option->rect,
                              QColor(tokens.acc.red(), tokens.acc.green(), tokens.acc.blue(), 50));
            return paintBox(*painter, option->rect, 0, {}, tokens.acc);
        case CE_ToolBar:
            painter->fillRect(option->rect, tokens.panel);
            return;
        default:
            break;
    }
    QProxyStyle::drawControl(element, option, painter, widget);
}

void StudioStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                     QPainter* painter, const QWidget* widget) const {
    const auto part = [&](SubControl sub) { return proxy()->subControlRect(control, option, sub, widget); };
    if (control == CC_ComboBox) {
        if (const auto* combo = qstyleoption_cast<const QStyleOptionComboBox*>(option))
            return parts::paintComboBox(*combo, *painter, theme_);
    } else if (control == CC_SpinBox) {
        if (const auto* spin = qstyleoption_cast<const QStyleOptionSpinBox*>(option))
            return parts::paintSpinBox(*spin, part(SC_SpinBoxUp), part(SC_SpinBoxDown), *painter, theme_);
    } else if (control == CC_ScrollBar) {
        if (isInTextField(widget))
            painter->fillRect(option->rect, theme_.tokens().raised);
        if (const auto* bar = qstyleoption_cast<const QStyleOptionSlider*>(option))
            return parts::paintScrollBar(*bar, part(SC_ScrollBarSlider), *painter, theme_);
    } else if (control == CC_Slider) {
        const auto* slider = qstyleoption_cast<const QStyleOptionSlider*>(option);
        if (slider && slider->tickPosition == QSlider::NoTicks)
            return parts::paintSlider(*slider, part(SC_SliderGroove), part(SC_SliderHandle), *painter,
                                      theme_);
    }
    QProxyStyle::drawComplexControl(control, option, painter, widget);
}

QIcon StudioStyle::standardIcon(StandardPixmap icon, const QStyleOption* option,
                                const QWidget* widget) const {
    switch (icon) {
        case SP_TitleBarCloseButton:
        case SP_DockWidgetCloseButton:
        case SP_LineEditClearButton:
            return theme_.icon("close");
        case SP_TitleBarNormalButton:
            return theme_.icon("fullscreen");
        case SP_MessageBoxWarning:
            return theme_.icon("warn", theme_.tokens().warn);
        case SP_MessageBoxCritical:
            return theme_.icon("error", theme_.tokens().err);
        case SP_MessageBoxInformation:
            return theme_.icon("info", theme_.tokens().acc);
        case SP_MessageBoxQuestion:
            return theme_.icon("help", theme_.tokens().acc);
        case SP_ToolBarHorizontalExtensionButton:
        case SP_ToolBarVerticalExtensionButton:
            return theme_.icon("more");
        default:
            return QProxyStyle::standardIcon(icon, option, widget);
    }
}

}  // namespace noctule::ui
