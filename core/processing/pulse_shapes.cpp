// SPDX-License-Identifier: Apache-2.0
#include "core/processing/pulse_shapes.h"

#include <algorithm>

#include "core/acoustics/pulse_shape_learner.h"
#include "core/suit/calibration_entries.h"

namespace noctule {
namespace {

constexpr double kLearntFrom_s = 20;

Result<PulseShapes> learnShapes(const Take& take, const SoundLog& log, const Ingredients& in,
                                const JobContext& job) {
    const PulseTrain& train = in.decoder.train;
    if (const Status fits = checkTrain(train, Detector::kMatched); !fits)
        return fits.error();
    const auto learner = std::make_shared<PulseShapeLearner>(train, static_cast<int>(in.suit.sources.size()));
    auto receiver = PulseReceiver::create(learner, train, static_cast<int>(in.suit.boards.size()));
    if (!receiver)
        return receiver.error();
    for (const GapRow& gap : log.gaps)
        receiver->markMissing(gap.first_sample, gap.sample_count, gap.board);
    for (const Pulse& pulse : log.pulses)
        receiver->pushPulse(pulse);
    std::vector<PulseDetection> unused;
    const Status read = take.forEachBlock(kSuitInView, [&](const AdcBlock& block) {
        receiver->pushBlock(block.first_sample, block.values);
        receiver->advance(receiver->samplesEnd(), unused);
        unused.clear();
        job.progress(0, "Learning the sources' pulses");
        return !job.cancelled() &&
               static_cast<double>(receiver->samplesEnd()) < kLearntFrom_s * train.sample_rate_hz;
    });
    if (job.cancelled())
        return JobContext::cancelledError();
    if (!read)
        return read.error();
    return learner->learn();
}

void warnOf(const std::vector<std::string>& sources, const std::string& what,
            std::vector<std::string>& warnings) {
    std::string names;
    for (const std::string& source : sources)
        names += (names.empty() ? "" : ", ") + source;
    if (!names.empty())
        warnings.push_back(what + names +
                           ". `noctule --batch calibrate sources --detector matched` says better.");
}

}  // namespace

Status completeShapes(const Take& take, const SoundLog& log, Ingredients& in,
                      std::vector<std::string>& warnings, const JobContext& job) {
    const PulseShapes known = shapesOf(in.suit, in.calibration);
    if (in.decoder.detector != Detector::kMatched ||
        std::ranges::all_of(known, [](const auto& shape) { return shape.has_value(); }))
        return Done{};
    const auto learnt = learnShapes(take, log, in, job);
    if (!learnt)
        return learnt.error();
    std::vector<std::string> found, derived;
    for (size_t s = 0; s < known.size(); ++s) {
        if (known[s] || !(*learnt)[s])
            continue;
        SourceCalibration& source = entryOf(in.calibration, in.suit.sources[s]);
        source.resonance_hz = (*learnt)[s]->resonance_hz;
        source.q = (*learnt)[s]->q;
        found.push_back(source.id);
        if (!source.offsets_s.contains("matched") && !source.offsets_s.contains("start") &&
            !source.offsets_s.empty())
            derived.push_back(source.id);
    }
    warnOf(found, "The calibration lacks the shape of pulses; it was learnt from this take's sound for ",
           warnings);
    warnOf(derived, "Offsets for detector matched were derived from those for inflection for ", warnings);
    return Done{};
}

}  // namespace noctule
