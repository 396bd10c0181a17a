// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_suit/cast_box.h"

#include "app/batch/cast_request.h"
#include "app/virtual_suit/simulated_source.h"
#include "app/virtual_suit/start_instant.h"

namespace noctule::virtual_suit {
namespace {

std::string namesIn(const simulation::Cast& cast) {
    std::vector<std::string> names;
    for (const simulation::CastSuit& suit : cast.suits)
        names.push_back(suit.isRoom() ? "room" : suit.name);
    return batch::listed(names);
}

}  // namespace

Result<SoundOfSuit> openCastBox(const Options& options) {
    const auto start_ns = startInstant(options.arguments.text("start-at"));
    if (!start_ns)
        return start_ns.error();
    batch::Console console(false, false);
    auto request = batch::castRequest(options.arguments.text("cast"), options.arguments, console, 0);
    if (!request)
        return request.error();
    if (options.loop())
        request->comes_back_s = kLongestWait_s;
    auto cast = prepareCast(*request);
    if (!cast)
        return cast.error();
    const std::string name = options.arguments.text("subject");
    const int suit = cast->find(name);
    if (suit < 0)
        return Error{ErrorKind::kUsage,
                     options.arguments.text("cast") + ": nobody in the cast is called " + name,
                     "Give --subject " + namesIn(*cast)};
    return makeCastSource(std::move(*cast), static_cast<size_t>(suit), *start_ns);
}

}  // namespace noctule::virtual_suit
