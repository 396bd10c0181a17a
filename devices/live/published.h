// SPDX-License-Identifier: Apache-2.0
// The newest state of something, for any number of readers. A slow reader misses states and delays nobody:
// the lock is held for the copy of a pointer.
#pragma once

#include <memory>
#include <mutex>
#include <utility>

namespace noctule {

template <class T>
class Published {
public:
    void set(T value) {
        auto next = std::make_shared<const T>(std::move(value));
        const std::lock_guard lock(mutex_);
        latest_.swap(next);
    }
    /// Never null.
    std::shared_ptr<const T> get() const {
        const std::lock_guard lock(mutex_);
        return latest_;
    }

private:
    mutable std::mutex mutex_;
    std::shared_ptr<const T> latest_ = std::make_shared<const T>();
};

}  // namespace noctule
