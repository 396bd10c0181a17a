// SPDX-License-Identifier: Apache-2.0
// How TakeDocument loads a part: templates that its two source files share.
#pragma once

#include <algorithm>

#include "ui/language/core_words.h"
#include "ui/models/take_document.h"

namespace noctule::ui {

template <class Key, class T>
std::shared_ptr<const T> TakeDocument::ask(Parts<Key, T>& parts, const Key& key, const QString& title,
                                           Changed changed, Work<T> work) {
    Part<T>& part = parts[key];
    part.asked = ++ticket_;
    if (part.ticket != 0)
        return part.value;
    part.ticket = ticket_;
    part.job = jobs_.start<T>(
        title, std::move(work),
        [document = QPointer(this), &parts, key, ticket = part.ticket, changed](Result<T> result) -> QString {
            if (document)
                document->accept(parts, key, ticket, std::move(result), changed);
            return {};
        },
        Jobs::Loudness::kQuiet);
    return nullptr;
}

template <class Key, class T>
void TakeDocument::accept(Parts<Key, T>& parts, const Key& key, uint64_t ticket, Result<T> result,
                          Changed changed) {
    const auto found = parts.find(key);
    if (found == parts.end() || found->second.ticket != ticket)
        return;
    found->second.ended = true;
    if (result)
        found->second.value = std::make_shared<const T>(std::move(*result));
    else
        problem_ = coreWords(result.error());
    if (!result && result.error().is_damage && !damaged_)
        noteDamage(path_, result.error());
    (this->*changed)();  // a signal
}

template <class Key, class T, class Unwanted>
void TakeDocument::drop(Parts<Key, T>& parts, Unwanted unwanted) {
    std::erase_if(parts, [&](const auto& entry) {
        const bool dropped = unwanted(entry.first);
        if (dropped && entry.second.job && !entry.second.ended)
            entry.second.job->cancel();
        return dropped;
    });
}

template <class Key, class T>
void TakeDocument::keepNewest(Parts<Key, T>& parts) {
    constexpr size_t kMost = 64;
    while (parts.size() > kMost) {
        const auto oldest = std::min_element(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
            return a.second.asked < b.second.asked;
        });
        if (oldest->second.job && !oldest->second.ended)
            oldest->second.job->cancel();
        parts.erase(oldest);
    }
}

}  // namespace noctule::ui
