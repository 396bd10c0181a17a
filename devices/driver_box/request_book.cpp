// SPDX-License-Identifier: Apache-2.0
#include "devices/driver_box/request_book.h"

#include <algorithm>

namespace noctule::link {

void RequestBook::send(Type type, Bytes payload, int64_t now_ns, const Sender& sender) {
    const uint32_t sequence = sender(type, payload);
    requests_.push_back({type, std::move(payload), {sequence}, now_ns});
}

std::optional<Type> RequestBook::answered(uint32_t sequence) {
    const auto found = std::find_if(requests_.begin(), requests_.end(), [&](const Request& request) {
        return std::count(request.sequences.begin(), request.sequences.end(), sequence) > 0;
    });
    if (found == requests_.end())
        return std::nullopt;
    const Type type = found->type;
    requests_.erase(found);
    return type;
}

void RequestBook::forget(Type type) {
    std::erase_if(requests_, [&](const Request& request) { return request.type == type; });
}

std::vector<Type> RequestBook::expire(int64_t now_ns, int64_t last_sound_ns, const Sender& sender) {
    std::vector<Type> failed;
    for (Request& request : requests_) {
        int64_t due_ns = request.sent_ns + kAnswerTime_ns;
        if (request.type == Type::kStop)
            due_ns = std::clamp(last_sound_ns + kAnswerTime_ns, due_ns, request.sent_ns + kDrainTime_ns);
        if (now_ns < due_ns)
            continue;
        if (request.sequences.size() == kMostSends) {
            failed.push_back(request.type);
            request.sequences.clear();
            continue;
        }
        request.sequences.push_back(sender(request.type, request.payload));
        request.sent_ns = now_ns;
    }
    std::erase_if(requests_, [](const Request& request) { return request.sequences.empty(); });
    return failed;
}

std::vector<Type> RequestBook::giveUp() {
    std::vector<Type> types;
    for (const Request& request : requests_)
        types.push_back(request.type);
    requests_.clear();
    return types;
}

}  // namespace noctule::link
