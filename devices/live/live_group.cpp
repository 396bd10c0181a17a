// SPDX-License-Identifier: Apache-2.0
#include "devices/live/live_group.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "devices/live/live_plans.h"
#include "devices/machine/clock.h"

namespace noctule {
namespace {

std::string suitName(size_t index) {
    return "suit " + std::to_string(index + 1);
}

std::string asSentence(std::string text) {
    if (!text.empty() && text.front() >= 'a' && text.front() <= 'z')
        text.front() = static_cast<char>(text.front() - 'a' + 'A');
    return text;
}

/// Empty when nobody has a name: readers then take every suit with an actor for a subject.
std::string subjectsJson(const GroupRequest& request, const std::vector<bool>& rooms) {
    if (std::ranges::all_of(request.suits, [](const GroupSuit& suit) { return suit.subject.empty(); }))
        return "";
    nlohmann::json subjects = nlohmann::json::array();
    for (size_t i = 0; i < request.suits.size(); ++i) {
        nlohmann::json subject{{"suits", {i + 1}}};
        if (rooms[i])
            subject["room"] = true;
        else
            subject["name"] = request.suits[i].subject.empty() ? suitName(i) : request.suits[i].subject;
        subjects.push_back(std::move(subject));
    }
    return subjects.dump();
}

}  // namespace

LiveGroup::LiveGroup(std::vector<std::unique_ptr<Device>> devices) {
    require(!devices.empty(), "a group needs a device");
    for (auto& device : devices) {
        const std::string address = device->address();
        members_.push_back({address, suitName(members_.size()) + " (" + address + ")",
                            std::make_shared<LiveSession>(std::move(device))});
    }
}

LiveGroup::LiveGroup(std::vector<Connected> connected) {
    require(!connected.empty(), "a group needs a session");
    for (Connected& one : connected)
        members_.push_back({one.name, one.name, std::move(one.session)});
}

void LiveGroup::connect() {
    for (const Member& member : members_)
        member.session->connect();
}

Result<std::vector<SuitVoice>> LiveGroup::greetedVoices() const {
    std::vector<SuitVoice> voices;
    for (size_t i = 0; i < size(); ++i) {
        const auto now = session(i).status();
        if (now->link != LinkState::kReady || !now->hello)
            return Error{ErrorKind::kDevice, members_[i].address + ": is not ready to start",
                         "Wait until all driver boxes have answered and the take before has ended"};
        voices.push_back({nameOf(i), *now->hello});
    }
    const Status told_apart = checkVoices(voices);
    return told_apart ? Result<std::vector<SuitVoice>>(voices) : told_apart.error();
}

/// The suit as it is worn; whether it hangs in the room instead is known from then on.
Result<Suit> LiveGroup::wornSuit(const GroupSuit& wish, size_t index) {
    const link::Hello& hello = *session(index).status()->hello;
    auto suit = wish.suit ? link::placedBySerial(hello.suit, *wish.suit) : Result<Suit>(hello.suit);
    if (!suit)
        return suit;
    members_[index].is_room = (wish.suit || hello.suit_is_placed) && suit->isFixed();
    if (isRoom(index) && wish.actor)
        return Error{ErrorKind::kUsage,
                     nameOf(index) + ": all of it is fixed in the room, so nobody wears it, and " +
                         wish.actor->name + " is given as its performer",
                     "Write `none` in place of this device's actor"};
    return suit;
}

StreamRequest LiveGroup::requestOf(const GroupRequest& request, size_t index) const {
    const GroupSuit& wish = request.suits[index];
    StreamRequest of = request.all;
    of.suit = wish.suit;
    of.calibration = wish.calibration;
    of.actor = wish.actor;
    of.process = wish.process && !isRoom(index);
    of.rest_s = wish.rest_s.value_or(of.rest_s);
    if (wish.pose_listener)
        of.pose_listener = wish.pose_listener;
    if (isRoom(index))
        of.rest_s = 0;
    else if (!of.actor)
        of.actor = defaultActor();
    if (of.actor)
        of.take->meta["actor_name"] = of.actor->name;
    return of;
}

Result<LiveGroup::Prepared> LiveGroup::prepare(const GroupRequest& request,
                                               const std::vector<SuitVoice>& voices) {
    Prepared prepared;
    std::vector<bool> rooms;
    for (size_t i = 0; i < size(); ++i) {
        const auto suit = wornSuit(request.suits[i], i);
        if (!suit)
            return suit.error();
        const link::Hello& hello = voices[i].hello;
        prepared.requests.push_back(requestOf(request, i));
        prepared.plans.push_back(
            takePlanOf(prepared.requests[i], hello, i == 0 ? *suit : withVoice(*suit, hello), 0));
        rooms.push_back(isRoom(i));
    }
    if (std::ranges::all_of(rooms, [](bool room) { return room; }))
        return Error{ErrorKind::kUsage, "Nobody wears any of these suits: all of them are fixed in the room",
                     "Record at least one suit of a performer, or give its placement with --suit"};
    if (const std::string subjects = subjectsJson(request, rooms); !subjects.empty())
        prepared.plans.front().meta["subjects"] = subjects;
    return prepared;
}

Result<std::vector<std::string>> LiveGroup::begin(const GroupRequest& request) {
    require(request.suits.size() == size() && request.all.take && !request.all.keep_results,
            "a group's request names each suit and a take, and keeps no results");
    const auto voices = greetedVoices();
    if (!voices)
        return voices.error();
    const auto prepared = prepare(request, *voices);
    if (!prepared)
        return prepared.error();
    auto sinks = makeTakeFiles(prepared->plans);
    if (!sinks)
        return sinks.error();
    path_ = sinks->front()->path();
    for (size_t i = 0; i < size(); ++i)
        if (const Status begun = session(i).begin(prepared->requests[i], std::move(sinks->at(i))); !begun) {
            sinks->clear();
            finish();
            discard();
            return begun.error();
        }
    return voiceWarnings(*voices);
}

bool LiveGroup::allFlow() const {
    return std::ranges::all_of(members_,
                               [](const Member& member) { return member.session->reachedSample() > 0; });
}

std::optional<Error> LiveGroup::failedToStart() const {
    for (const Member& member : members_) {
        const auto now = member.session->status();
        if (!now->stream_is_open && member.session->reachedSample() == 0)
            return now->trouble.value_or(Error{ErrorKind::kDevice, member.address + ": sends nothing",
                                               "Switch the driver box off and on, and record again"});
    }
    return std::nullopt;
}

bool LiveGroup::isRecording() const {
    const auto ended = [](const Member& member) {
        const auto recording = member.session->recording();
        return !recording || recording->ended;
    };
    return std::ranges::none_of(members_, ended) && !hasStopped();
}

bool LiveGroup::hasStopped() const {
    return std::ranges::none_of(
        members_, [](const Member& member) { return member.session->status()->stream_is_open; });
}

double LiveGroup::reachedOf_s(size_t index) const {
    const auto hello = session(index).status()->hello;
    return hello ? static_cast<double>(session(index).reachedSample()) / hello->sample_rate_hz : 0;
}

std::optional<double> LiveGroup::reached_s() const {
    std::optional<double> least;
    for (size_t i = 0; i < size(); ++i)
        if (const LinkState link = session(i).status()->link;
            link == LinkState::kStreaming || link == LinkState::kStalled)
            least = std::min(least.value_or(reachedOf_s(i)), reachedOf_s(i));
    return least;
}

std::optional<double> LiveGroup::remaining_s() const {
    double per_s = 0;  // of the room that is left
    for (const Member& member : members_) {
        const auto recording = member.session->recording();
        if (!recording || !recording->remaining_s)
            return std::nullopt;
        if (*recording->remaining_s <= 0)
            return 0;
        per_s += 1 / *recording->remaining_s;
    }
    return 1 / per_s;
}

void LiveGroup::stop() {
    for (Member& member : members_) {
        const auto now = member.session->status();
        member.flowed_to_the_end = now->link == LinkState::kStreaming;
        if (now->stream_is_open)
            member.session->stop();
    }
}

void LiveGroup::markMissing() {
    const auto rateOf_hz = [&](size_t i) {
        const auto hello = session(i).status()->hello;
        return static_cast<double>(hello ? hello->sample_rate_hz : 1);
    };
    std::vector<MissingEnd> ends(size());
    double end_s = 0;
    for (size_t i = 0; i < size(); ++i) {
        const auto until = session(i).brokenOffUntil();
        ends[i].broke_off = until.has_value();
        ends[i].is_lost = until || !members_[i].flowed_to_the_end || session(i).status()->trouble;
        end_s = std::max({end_s, reachedOf_s(i), static_cast<double>(until.value_or(0)) / rateOf_hz(i)});
    }
    const bool one_went_on = !std::ranges::all_of(ends, &MissingEnd::is_lost);
    for (size_t i = 0; i < size(); ++i) {
        if (end_s - reachedOf_s(i) < LiveSession::kWorthMarking_s && !ends[i].broke_off)
            continue;
        ends[i].until = std::llround(end_s * rateOf_hz(i));
        ends[i].who = asSentence(nameOf(i));
        ends[i].others_went_on = one_went_on;
        session(i).markMissing(ends[i]);
    }
}

std::vector<StreamResult> LiveGroup::finish(std::optional<double> patience_s) {
    const int64_t begun_ns = steadyNow_ns();
    markMissing();
    std::vector<StreamResult> results;
    std::optional<double> left_s;
    for (size_t i = 0; i < size(); ++i) {
        if (patience_s)
            left_s = std::max(0.0, *patience_s - static_cast<double>(steadyNow_ns() - begun_ns) * 1e-9);
        results.push_back(session(i).finish(left_s));
    }
    return results;
}

}  // namespace noctule
