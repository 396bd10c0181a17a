// SPDX-License-Identifier: Apache-2.0
#include "core/vision/jig_photographs.h"

#include <algorithm>
#include <optional>

#include "core/recording/take.h"

namespace noctule {
namespace {

struct JigTakes {
    Suit suit;
    std::vector<std::string> labels;  ///< each once
};

Result<JigTakes> readJigTakes(const std::vector<std::string>& paths) {
    JigTakes takes;
    for (const std::string& path : paths) {
        const auto take = Take::open(path);
        if (!take)
            return take.error();
        const auto markers = take->markers();
        if (!markers)
            return markers.error();
        for (const MarkerRow& marker : *markers)
            if (marker.kind == "placement" && !marker.label.empty() &&
                !std::ranges::count(takes.labels, marker.label))
                takes.labels.push_back(marker.label);
        if (&path != &paths.front())
            continue;
        auto suit = take->suit();
        if (!suit)
            return suit.error();
        takes.suit = std::move(*suit);
    }
    return takes;
}

/// Without a distance the solver could only say that it has none.
Error nothingMeasured(const std::vector<Finding>& findings) {
    Error error{ErrorKind::kUnusable, "The photographs give no distance: ", ""};
    for (const Finding& finding : findings) {
        error.message += (error.remedy.empty() ? "" : "; ") + finding.what;
        error.remedy = finding.remedy;  // the last says what stands in the way of all
    }
    return error;
}

}  // namespace

Result<PhotographedDistances> measureJigPhotographs(const JigPhotographs& request, const JobContext& job) {
    require(!request.take_paths.empty(), "photographs of no take");
    const auto takes = readJigTakes(request.take_paths);
    if (!takes)
        return takes.error();
    // Names first: looking for markers takes long.
    std::vector<PlacedPhotograph> placed;
    for (const std::string& path : request.photograph_paths) {
        const auto placement = placementOf(path, takes->labels);
        if (!placement)
            return placement.error();
        placed.push_back({*placement, {}});
    }
    auto photographs = readPhotographs(request.photograph_paths, job);
    if (!photographs)
        return photographs.error();
    for (size_t i = 0; i < placed.size(); ++i)
        placed[i].photograph = std::move((*photographs)[i]);
    auto found = measurePhotographs(placed, takes->suit, request.settings, job);
    if (found && found->known.distances.empty())
        return nothingMeasured(found->known.findings);
    return found;
}

}  // namespace noctule
