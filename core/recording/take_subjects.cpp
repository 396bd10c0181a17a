// SPDX-License-Identifier: Apache-2.0
// Who is in a take.
#include <algorithm>
#include <set>

#include "core/job/limits.h"
#include "core/job/outside_text.h"
#include "core/math/json.h"
#include "core/recording/take.h"

namespace noctule {
namespace {

Error badSubjects(const std::string& take, const std::string& what) {
    return {ErrorKind::kUnreadable, take + ": meta subjects: " + what,
            "Correct subjects in the take's meta table, or remove it"};
}

}  // namespace

Result<TakeSubject> Take::subjectFrom(const nlohmann::json& entry) const {
    TakeSubject subject;
    subject.name = shortText(json::text(entry, "name").value_or(""), limits::kName);
    subject.room = entry.is_object() && entry.value("room", nlohmann::json(false)) == true;
    const std::string who = subject.room ? "the room" : "subject '" + subject.name + "'";
    const auto suits = entry.is_object() ? entry.find("suits") : entry.end();
    if (suits == entry.end() || !suits->is_array() || suits->empty() ||
        (!subject.room && subject.name.empty()))
        return badSubjects(path(), who + " has no name or no list of suits");
    for (const nlohmann::json& suit : *suits) {
        const int id = suit.is_number_integer() ? suit.get<int>() : 0;
        if (!suits_.contains(id))
            return badSubjects(path(),
                               who + " has suit " + suit.dump() + ", which the take does not describe");
        subject.suits.push_back(id);
    }
    return subject;
}

std::vector<TakeSubject> Take::subjectsByActor(const std::vector<DocumentRow>& actors) const {
    std::vector<TakeSubject> all;
    for (const auto& [id, entry] : suits_) {
        const int suit = id;
        if (std::ranges::any_of(actors, [suit](const DocumentRow& row) { return row.suit == suit; }))
            all.push_back({"suit " + std::to_string(suit), {suit}, false});
    }
    if (suits_.size() <= 1 || all.empty()) {
        const auto performer = meta_.find("performer");
        all = {{performer == meta_.end() ? "" : performer->second, {1}, false}};
        return all;
    }
    for (const auto& [id, entry] : suits_)
        if (entry.suit && entry.suit->isFixed() &&
            std::ranges::none_of(all, [suit = id](const TakeSubject& one) { return one.suit() == suit; }))
            all.push_back({"", {id}, true});
    return all;
}

Result<std::vector<TakeSubject>> Take::subjects() const {
    const auto actors = this->actors();
    if (!actors)
        return actors.error();
    const auto stated = meta_.find("subjects");
    if (stated == meta_.end())
        return subjectsByActor(*actors);
    const json::Json list = json::parse(stated->second);
    if (!list.is_array() || list.empty())
        return badSubjects(path(), "is no list of subjects");
    std::vector<TakeSubject> all;
    std::set<int> suits;
    std::set<std::string> names;
    for (const nlohmann::json& entry : list) {
        auto subject = subjectFrom(entry);
        if (!subject)
            return subject.error();
        for (const int suit : subject->suits)
            if (!suits.insert(suit).second)
                return badSubjects(path(), "suit " + std::to_string(suit) + " is named twice");
        if (!subject->room && !names.insert(subject->name).second)
            return badSubjects(path(), "two subjects are called '" + subject->name + "'");
        const bool has_actor =
            std::ranges::any_of(*actors, [&](const DocumentRow& row) { return row.suit == subject->suit(); });
        if (!subject->room && !has_actor)
            return badSubjects(path(), "subject '" + subject->name + "' has no actor: suit " +
                                           std::to_string(subject->suit()) + " carries none");
        all.push_back(std::move(*subject));
    }
    if (std::ranges::all_of(all, &TakeSubject::room))
        return badSubjects(path(), "names nobody but the room");
    return all;
}

}  // namespace noctule
