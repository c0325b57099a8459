#include "geometry/parallel.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace rinceau {

void for_each_index(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
    // Many small portions for each thread, so that all end at about the same time.
    constexpr std::size_t portions_each = 16;
    const std::size_t available = std::max(1U, std::thread::hardware_concurrency());
    const std::size_t together = std::min(count, threads > 0 ? static_cast<std::size_t>(threads) : available);
    if (together <= 1) {
        for (std::size_t k = 0; k < count; ++k) work(k);
        return;
    }
    const std::size_t portion = std::max<std::size_t>(1, count / (portions_each * together));
    std::atomic<std::size_t> next = 0;
    const auto work_on = [&] {
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
    for (std::size_t t = 1; t < together; ++t) others.push_back(std::async(std::launch::async, work_on));
    std::exception_ptr failed;
    const auto finish = [&](const auto& rest) {
        try {
            rest();
        } catch (...) {
            failed = std::current_exception();
        }
    };
    finish(work_on);
    for (auto& other : others) finish([&] { other.get(); });
    if (failed) std::rethrow_exception(failed);
}

}  // namespace rinceau
