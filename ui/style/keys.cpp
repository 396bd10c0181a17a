// SPDX-License-Identifier: Apache-2.0
#include "ui/style/keys.h"

#include <QSettings>
#include <algorithm>

namespace noctule::ui {
namespace {

constexpr const char* kGroup = "keys";

QString settingOf(const QString& name) {
    return QLatin1String(kGroup) + QLatin1Char('/') + name;
}

QString roomOf(const QString& name) {
    return name.section('/', 0, 0);
}

bool meet(const QString& name, const QString& other) {
    return roomOf(name) == roomOf(other) || Keys::actsEverywhere(name) || Keys::actsEverywhere(other);
}

QKeySequence chosenFor(const QString& name) {
    return {QSettings().value(settingOf(name)).toString(), QKeySequence::PortableText};
}

/// What the operator chose goes before a usual key, which may be new in this version.
QList<QKeySequence> keysInForce(const QString& name, QList<QKeySequence> usual) {
    if (const QKeySequence chosen = chosenFor(name); !chosen.isEmpty())
        return {chosen};
    QSettings settings;
    settings.beginGroup(kGroup);
    for (const QString& other : settings.allKeys())
        if (meet(name, other))
            usual.removeAll(QKeySequence(settings.value(other).toString(), QKeySequence::PortableText));
    return usual;
}

}  // namespace

Keys& Keys::get() {
    static Keys keys;
    return keys;
}

bool Keys::actsEverywhere(const QString& name) {
    return roomOf(name) == QLatin1String("window");
}

void Keys::adopt(QAction& action, const QString& name, const QList<QKeySequence>& usual) {
    adopted_.erase(
        std::remove_if(adopted_.begin(), adopted_.end(), [](const Adopted& one) { return !one.action; }),
        adopted_.end());
    adopted_.push_back({&action, name, usual, {}});
    apply(adopted_.back());
}

void Keys::setUsual(QAction& action, const QList<QKeySequence>& usual) {
    for (Adopted& one : adopted_)
        if (one.action == &action) {
            one.usual = usual;
            apply(one);
        }
}

void Keys::restrict(QAction& action, std::function<bool(const QKeySequence&)> acts) {
    for (Adopted& one : adopted_)
        if (one.action == &action) {
            one.acts = std::move(acts);
            return apply(one);
        }
}

void Keys::apply(const Adopted& one) {
    QList<QKeySequence> keys = keysInForce(one.name, one.usual);
    if (one.acts)
        keys.erase(std::remove_if(keys.begin(), keys.end(), std::not_fn(one.acts)), keys.end());
    one.action->setShortcuts(keys);
}

const Keys::Adopted* Keys::find(const QAction& action) const {
    const auto found = std::find_if(adopted_.begin(), adopted_.end(),
                                    [&](const Adopted& one) { return one.action == &action; });
    return found == adopted_.end() ? nullptr : &*found;
}

QString Keys::nameOf(const QAction& action) const {
    const Adopted* found = find(action);
    return found ? found->name : QString();
}

QKeySequence Keys::keyOf(const QString& name, const QKeySequence& usual) {
    return keysInForce(name, {usual}).value(0);
}

bool Keys::isUsual(const QKeySequence& key, const QString& name) const {
    return std::any_of(adopted_.begin(), adopted_.end(), [&](const Adopted& one) {
        return one.action && one.name == name && one.usual.contains(key);
    });
}

QAction* Keys::holderOf(const QKeySequence& key, const QString& name) const {
    const bool is_own = isUsual(key, name);
    for (const Adopted& other : adopted_) {
        if (!other.action || other.name == name || !meet(name, other.name))
            continue;
        const bool is_shared = is_own && other.usual.contains(key) && chosenFor(other.name) != key;
        if (!is_shared && keysInForce(other.name, other.usual).contains(key))
            return other.action;
    }
    return nullptr;
}

void Keys::choose(const QString& name, const QKeySequence& key) {
    const bool is_usual = std::any_of(adopted_.begin(), adopted_.end(), [&](const Adopted& one) {
        return one.action && one.name == name && one.usual.value(0) == key;
    });
    if (is_usual)
        QSettings().remove(settingOf(name));
    else
        QSettings().setValue(settingOf(name), key.toString(QKeySequence::PortableText));
    applyAll();
}

void Keys::restoreUsual() {
    QSettings().remove(kGroup);
    applyAll();
}

void Keys::applyAll() {
    for (const Adopted& one : adopted_)
        if (one.action)
            apply(one);
    emit changed();
}

void followKey(QObject& owner, const QString& name, const QKeySequence& usual,
               const std::function<void(const QKeySequence&)>& show) {
    show(Keys::keyOf(name, usual));
    QObject::connect(&Keys::get(), &Keys::changed, &owner, [=] { show(Keys::keyOf(name, usual)); });
}

}  // namespace noctule::ui
