#include "geometry/parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <new>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace rinceau {

namespace {

using Work = std::function<void(std::size_t)>;

/// `own_work` is called on the calling thread, `other_work` on the others; `wait` may throw, which ends the work early.
void share_out(std::size_t count, int threads, const Work& own_work, const Work& other_work,
               const std::function<void(const std::future<void>&)>& wait) {
    // Many small portions for each thread, so that all end at about the same time.
    constexpr std::size_t portions_each = 16;
    const std::size_t available = std::max(1U, std::thread::hardware_concurrency());
    const std::size_t together = std::min(count, threads > 0 ? static_cast<std::size_t>(threads) : available);
    if (together <= 1) {
        for (std::size_t k = 0; k < count; ++k) own_work(k);
        return;
    }
    const std::size_t portion = std::max<std::size_t>(1, count / (portions_each * together));
    std::atomic<std::size_t> next = 0;
    const auto work_on = [&](const Work& work) {
        try {
            for (std::size_t begin = next.fetch_add(portion); begin < count; begin = next.fetch_add(portion)) {
                for (std::size_t k = begin; k < std::min(count, begin + portion); ++k) work(k);
            }
        } catch (...) {
            next = count;
            throw;
        }
    };
    std::vector<std::future<void>> others;
    try {
        for (std::size_t t = 1; t < together; ++t)
            others.push_back(std::async(std::launch::async, [&] { work_on(other_work); }));
    } catch (const std::system_error&) {
        // as many threads as the system gives
    } catch (const std::bad_alloc&) {
    }
    std::exception_ptr failed;
    const auto finish = [&](const auto& rest) {
        try {
            rest();
        } catch (...) {
            if (!failed) failed = std::current_exception();
            next = count;
        }
    };
    finish([&] { work_on(own_work); });
    for (auto& other : others) {
        finish([&] { wait(other); });
        finish([&] { other.get(); });
    }
    if (failed) std::rethrow_exception(failed);
}

/// Thrown on the other threads when the calling thread's progress has thrown.
struct EndedEarly {};

}  // namespace

void for_each_index(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
    share_out(count, threads, work, work, [](const std::future<void>& other) { other.wait(); });
}

void for_each_index(std::size_t count, int threads, std::string_view stage, const Progress& progress,
                    const std::function<void(std::size_t, const Progress&)>& work) {
    if (!progress) {
        for_each_index(count, threads, [&](std::size_t k) { work(k, progress); });
        return;
    }
    constexpr std::chrono::milliseconds between_looks{20};
    std::atomic<bool> ended = false;
    std::string last_stage(stage);
    double last_fraction = 0;
    const Progress told = [&](std::string_view now, double fraction) {
        last_stage = std::string(now);
        last_fraction = fraction;
        try {
            progress(last_stage, fraction);
        } catch (...) {
            ended = true;
            throw;
        }
    };
    const Progress looked = [&](std::string_view, double) {
        if (ended) throw EndedEarly{};
    };
    const auto tell_again = [&] { told(std::string(last_stage), last_fraction); };
    share_out(
        count, threads,
        [&](std::size_t k) {
            tell_again();
            work(k, told);
        },
        [&](std::size_t k) {
            looked({}, 0);
            work(k, looked);
        },
        [&](const std::future<void>& other) {
            while (!ended && other.wait_for(between_looks) != std::future_status::ready) tell_again();
        });
}

}  // namespace rinceau
