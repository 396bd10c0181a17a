// SPDX-License-Identifier: Apache-2.0
// Sizes and behaviour; what is drawn stands in studio_style_draw.cpp and parts_*.cpp.
#include "ui/style/studio_style.h"

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QScrollBar>
#include <QStyleOption>
#include <QStyledItemDelegate>
#include <QTabBar>
#include <algorithm>

#include "ui/style/style_parts.h"

namespace noctule::ui {

namespace {

QRect spinBoxPart(const QStyleOptionSpinBox& spin, QStyle::SubControl part, int button_width) {
    const QRect rect = spin.rect;
    const int width = spin.buttonSymbols == QAbstractSpinBox::NoButtons ? 0 : button_width;
    const QRect buttons(rect.right() - width, rect.top() + 1, width, rect.height() - 2);
    switch (part) {
        case QStyle::SC_SpinBoxUp:
            return buttons.adjusted(0, 0, 0, -(buttons.height() - buttons.height() / 2));
        case QStyle::SC_SpinBoxDown:
            return buttons.adjusted(0, buttons.height() / 2, 0, 0);
        default:
            return rect.adjusted(1, 1, -width - 1, -1);
    }
}

/// No arrows: the groove is everything, the slider as long as the share of the page but never below
/// `shortest`.
QRect scrollBarPart(const QStyleOptionSlider& bar, QStyle::SubControl part, int shortest) {
    const QRect rect = bar.rect;
    const bool vertical = bar.orientation == Qt::Vertical;
    const int length = vertical ? rect.height() : rect.width();
    const qint64 range = static_cast<qint64>(bar.maximum) - bar.minimum;
    const auto share =
        range > 0 ? static_cast<int>(bar.pageStep * static_cast<qint64>(length) / (range + bar.pageStep))
                  : length;
    const int size = std::clamp(share, std::min(shortest, length), length);
    const int start = QStyle::sliderPositionFromValue(bar.minimum, bar.maximum, bar.sliderPosition,
                                                      length - size, bar.upsideDown);
    const auto along = [&](int from, int to) {
        const QRect piece = vertical ? QRect(rect.left(), rect.top() + from, rect.width(), to - from)
                                     : QRect(rect.left() + from, rect.top(), to - from, rect.height());
        return QStyle::visualRect(bar.direction, rect, piece);
    };
    switch (part) {
        case QStyle::SC_ScrollBarSlider:
            return along(start, start + size);
        case QStyle::SC_ScrollBarSubPage:
            return along(0, start);
        case QStyle::SC_ScrollBarAddPage:
            return along(start + size, length);
        case QStyle::SC_ScrollBarGroove:
            return along(0, length);
        default:
            return {};
    }
}

}  // namespace

StudioStyle::StudioStyle(const Theme& theme) : QProxyStyle("Fusion"), theme_(theme) {}

void StudioStyle::polish(QWidget* widget) {
    QProxyStyle::polish(widget);
    if (auto* tabs = qobject_cast<QTabBar*>(widget)) {
        tabs->setExpanding(false);
        tabs->setDrawBase(false);
    }
    // A combo box's own delegate does not ask the style how high a row is.
    auto* combo = qobject_cast<QComboBox*>(widget);
    if (combo && combo->itemDelegate()->inherits("QComboBoxDelegate"))
        combo->setItemDelegate(new QStyledItemDelegate(combo));
    if (qobject_cast<QAbstractButton*>(widget) || qobject_cast<QComboBox*>(widget) ||
        qobject_cast<QAbstractSpinBox*>(widget) || qobject_cast<QScrollBar*>(widget) ||
        qobject_cast<QAbstractSlider*>(widget) || qobject_cast<QTabBar*>(widget) ||
        qobject_cast<QHeaderView*>(widget))
        widget->setAttribute(Qt::WA_Hover);
}

int StudioStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
    switch (metric) {
        case PM_IndicatorWidth:
        case PM_IndicatorHeight:
        case PM_ExclusiveIndicatorWidth:
        case PM_ExclusiveIndicatorHeight:
        case PM_SmallIconSize:
        case PM_ButtonIconSize:
        case PM_ToolBarIconSize:
        case PM_ListViewIconSize:
        case PM_TabBarIconSize:
        case PM_TreeViewIndentation:
        case PM_SliderLength:
        case PM_SliderControlThickness:
            return theme_.px(16);
        case PM_LargeIconSize:
        case PM_MessageBoxIconSize:
            return theme_.px(24);
        case PM_CheckBoxLabelSpacing:
        case PM_RadioButtonLabelSpacing:
        case PM_LayoutHorizontalSpacing:
        case PM_LayoutVerticalSpacing:
        case PM_ToolTipLabelFrameWidth:
            return theme_.px(8);
        case PM_LayoutLeftMargin:
        case PM_LayoutTopMargin:
        case PM_LayoutRightMargin:
        case PM_LayoutBottomMargin:
            return theme_.px(12);
        case PM_ScrollBarExtent:
            return theme_.px(10);
        case PM_ScrollBarSliderMin:
            return theme_.px(32);
        case PM_SliderThickness:
        case PM_HeaderDefaultSectionSizeVertical:
            return theme_.px(28);
        case PM_SplitterWidth:  // Qt widens what the mouse can grab when they are 1 px
        case PM_DockWidgetSeparatorExtent:
        case PM_DefaultFrameWidth:
        case PM_SpinBoxFrameWidth:
        case PM_MenuPanelWidth:
        case PM_TextCursorWidth:
            return 1;
        case PM_MenuVMargin:
        case PM_HeaderMargin:
        case PM_ToolBarItemSpacing:
            return theme_.px(4);
        case PM_MenuHMargin:
        case PM_MenuBarPanelWidth:
        case PM_MenuBarItemSpacing:
        case PM_MenuBarHMargin:
        case PM_MenuBarVMargin:
        case PM_DockWidgetFrameWidth:
        case PM_ToolBarFrameWidth:
        case PM_TabBarTabShiftHorizontal:
        case PM_TabBarTabShiftVertical:
        case PM_TabBarBaseHeight:
        case PM_TabBarBaseOverlap:
        case PM_ButtonShiftHorizontal:
        case PM_ButtonShiftVertical:
        case PM_ScrollView_ScrollBarSpacing:
        case PM_ScrollView_ScrollBarOverlap:
            return 0;
        case PM_DockWidgetTitleMargin:
            return theme_.px(10);
        case PM_DockWidgetTitleBarButtonMargin:
            return theme_.px(6);
        case PM_FocusFrameHMargin:  // Qt adds one: text of cells starts 6 px in
            return theme_.px(5);
        case PM_HeaderDefaultSectionSizeHorizontal:
            return theme_.px(80);
        case PM_HeaderMarkSize:
            return theme_.px(10);
        default:
            return QProxyStyle::pixelMetric(metric, option, widget);
    }
}

int StudioStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                           QStyleHintReturn* returned) const {
    switch (hint) {
        case SH_ComboBox_Popup:  // a list below the box, not a menu over it
        case SH_DrawMenuBarSeparator:
        case SH_EtchDisabledText:
        case SH_UnderlineShortcut:
        case SH_DialogButtonBox_ButtonsHaveIcons:
        case SH_ScrollBar_Transient:
            return 0;
        case SH_ItemView_ShowDecorationSelected:
        case SH_ScrollBar_LeftClickAbsolutePosition:
        case SH_Menu_SupportsSections:
            return 1;
        case SH_Slider_AbsoluteSetButtons:
            return Qt::LeftButton;
        case SH_Widget_Animation_Duration:
            return theme_.motion_ms(120);
        case SH_ComboBox_PopupFrameStyle:
            return static_cast<int>(QFrame::StyledPanel) | static_cast<int>(QFrame::Plain);
        case SH_TabBar_Alignment:
        case SH_FormLayoutLabelAlignment:
            return Qt::AlignLeft;
        case SH_ToolTipLabel_Opacity:
            return 255;
        case SH_ItemView_ArrowKeysNavigateIntoChildren:
            return 1;
        case SH_Table_GridLineColor:
            return static_cast<int>(theme_.tokens().line.rgb());
        default:
            return QProxyStyle::styleHint(hint, option, widget, returned);
    }
}

QSize StudioStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                                    const QWidget* widget) const {
    const auto at_least = [this](QSize size, int height) {
        return size.expandedTo(QSize(0, theme_.px(height)));
    };
    switch (type) {
        case CT_PushButton: {
            const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
            const QFontMetrics metrics(theme_.font(TextRole::kBody, true));
            int width = button ? metrics.size(Qt::TextShowMnemonic, button->text).width() : contents.width();
            if (button && !button->icon.isNull())
                width += button->iconSize.width() + theme_.px(8);
            if (button && (button->features & QStyleOptionButton::HasMenu))
                width += theme_.px(16);
            return at_least({width + theme_.px(26), contents.height()}, 30);
        }
        case CT_LineEdit:
            return at_least(contents + QSize(theme_.px(16), 0), 30);
        case CT_ComboBox:
            return at_least(contents + QSize(theme_.px(12 + 30), 0), 30);
        case CT_SpinBox:
            return at_least(contents + QSize(theme_.px(12 + 24), 0), 30);
        case CT_CheckBox:
        case CT_RadioButton:
            return at_least(QProxyStyle::sizeFromContents(type, option, contents, widget), 28);
        case CT_ToolButton:
            return at_least(contents + QSize(theme_.px(12), theme_.px(12)), 28);
        case CT_ItemViewItem:
            return at_least(QProxyStyle::sizeFromContents(type, option, contents, widget), 28);
        case CT_MenuBarItem:
            return at_least({contents.width() + theme_.px(18), contents.height()}, 30);
        case CT_MenuItem:
            if (const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option))
                return parts::menuItemSize(*item, theme_).expandedTo({contents.width(), 0});
            break;
        case CT_TabBarTab:
            if (const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option)) {
                const QFontMetrics metrics(theme_.font(TextRole::kBody, true));
                int width = metrics.size(Qt::TextShowMnemonic, tab->text).width() + theme_.px(28);
                width += tab->icon.isNull() ? 0 : theme_.px(24);
                width += tab->rightButtonSize.width() > 0 ? tab->rightButtonSize.width() + theme_.px(4) : 0;
                return at_least({width, contents.height()}, 32);
            }
            break;
        case CT_HeaderSection:
            if (const auto* header = qstyleoption_cast<const QStyleOptionHeader*>(option)) {
                const QFontMetrics metrics(theme_.font(TextRole::kCaption));
                const int arrow = header->sortIndicator == QStyleOptionHeader::None ? 0 : theme_.px(14);
                return at_least({metrics.size(0, header->text).width() + arrow + theme_.px(12), 0}, 28);
            }
            break;
        case CT_ProgressBar:
            return {std::max(contents.width(), theme_.px(60)), theme_.px(12)};
        default:
            break;
    }
    return QProxyStyle::sizeFromContents(type, option, contents, widget);
}

QRect StudioStyle::subElementRect(SubElement element, const QStyleOption* option,
                                  const QWidget* widget) const {
    switch (element) {
        case SE_LineEditContents:
            return option->rect.adjusted(theme_.px(6), 1, -theme_.px(6), -1);
        case SE_ProgressBarGroove:
        case SE_ProgressBarContents:
            return option->rect;
        case SE_DockWidgetTitleBarText:
            return option->rect;
        default:
            return QProxyStyle::subElementRect(element, option, widget);
    }
}

QRect StudioStyle::subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                                  const QWidget* widget) const {
    const QRect rect = option->rect;
    if (control == CC_ComboBox && part == SC_ComboBoxEditField)
        return rect.adjusted(theme_.px(8), 1, -theme_.px(28), -1);
    if (control == CC_ComboBox && part == SC_ComboBoxArrow)
        return {rect.right() - theme_.px(28), rect.top(), theme_.px(28), rect.height()};
    if (const auto* spin = qstyleoption_cast<const QStyleOptionSpinBox*>(option);
        spin && control == CC_SpinBox && part != SC_SpinBoxFrame)
        return spinBoxPart(*spin, part, theme_.px(22));
    if (const auto* bar = qstyleoption_cast<const QStyleOptionSlider*>(option);
        bar && control == CC_ScrollBar)
        return scrollBarPart(*bar, part, theme_.px(32));
    return QProxyStyle::subControlRect(control, option, part, widget);
}

}  // namespace noctule::ui
