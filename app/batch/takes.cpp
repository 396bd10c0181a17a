// SPDX-License-Identifier: Apache-2.0
#include "app/batch/takes.h"

#include <atomic>
#include <filesystem>
#include <numeric>
#include <set>
#include <thread>

namespace noctule::batch {
namespace {

/// Progress of several takes as one.
class SharedProgress {
public:
    SharedProgress(Console& console, size_t takes) : console_(console), fractions_(takes) {}

    void report(size_t take, double fraction, const std::string& stage) {
        const std::lock_guard lock(mutex_);
        fractions_[take] = fraction;
        const double all = std::accumulate(fractions_.begin(), fractions_.end(), 0.0);
        console_.progress(all / static_cast<double>(fractions_.size()), stage);
    }

private:
    Console& console_;
    std::mutex mutex_;
    std::vector<double> fractions_;
};

class TakeProgress : public ProgressSink {
public:
    TakeProgress(SharedProgress& shared, size_t take, std::string name)
        : shared_(shared), take_(take), name_(std::move(name)) {}
    void progress(double fraction, const std::string& stage) override {
        shared_.report(take_, fraction, name_ + ": " + stage);
    }

private:
    SharedProgress& shared_;
    size_t take_;
    std::string name_;
};

/// An exception must not cross a thread.
Result<Outcome> guarded(const TakeWork& work, const std::string& take, const JobContext& job) {
    try {
        return work(take, job);
    } catch (const std::exception& mistake) {
        return Error{ErrorKind::kInternal, take + ": internal error: " + mistake.what(),
                     "Please report it with the command line and the take"};
    }
}

std::vector<Result<Outcome>> workOnAll(const VerbContext& context, size_t jobs, const TakeWork& work) {
    const std::vector<std::string>& takes = context.arguments.operands();
    std::vector<Result<Outcome>> results(takes.size(), Result<Outcome>(JobContext::cancelledError()));
    SharedProgress shared(context.console, takes.size());
    std::atomic<size_t> next{0};
    const auto worker = [&] {
        for (size_t i = next++; i < takes.size() && !context.cancel.cancelled(); i = next++) {
            TakeProgress progress(shared, i, takes[i]);
            results[i] = guarded(work, takes[i], {&progress, &context.cancel});
        }
    };
    std::vector<std::thread> others;
    for (size_t n = 1; n < std::min(jobs, takes.size()); ++n)
        others.emplace_back(worker);
    worker();
    for (std::thread& other : others)
        other.join();
    return results;
}

}  // namespace

Result<Outcome> forEachTake(const VerbContext& context, size_t jobs, const TakeWork& work) {
    const std::vector<std::string>& takes = context.arguments.operands();
    const std::vector<Result<Outcome>> results = workOnAll(context, jobs, work);
    Outcome all{{{"takes", nlohmann::json::array()}}, "", std::nullopt};
    for (size_t i = 0; i < takes.size(); ++i) {
        if (results[i]) {
            all.json["takes"].push_back(results[i]->json);
            all.text += results[i]->text;
            continue;
        }
        const Error& error = results[i].error();
        if (takes.size() == 1 || error.kind == ErrorKind::kCancelled)
            return error;
        context.console.error(error);
        all.json["takes"].push_back({{"take", takes[i]}, {"error", errorJson(error)}});
        if (!all.failure)
            all.failure = error;
    }
    return all;
}

Status checkDistinct(const std::vector<std::string>& takes) {
    std::set<std::filesystem::path> seen;
    std::error_code ignored;
    for (const std::string& take : takes)
        if (!seen.insert(std::filesystem::weakly_canonical(std::filesystem::absolute(take), ignored)).second)
            return Error{ErrorKind::kUsage, take + " is named twice", "Name it once"};
    return Done{};
}

}  // namespace noctule::batch
