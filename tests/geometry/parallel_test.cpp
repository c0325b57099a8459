#include "geometry/parallel.h"

#include <catch2/catch.hpp>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace rinceau;

TEST_CASE("every index has its turn once, on any number of threads") {
    for (const int threads : {0, 1, 2, 5}) {
        for (const std::size_t count : {0U, 1U, 3U, 1000U}) {
            std::vector<int> turns(count, 0);
            for_each_index(count, threads, [&](std::size_t k) { ++turns[k]; });
            CHECK(turns == std::vector<int>(count, 1));
        }
    }
}

TEST_CASE("what one call throws comes out, on any number of threads") {
    for (const int threads : {1, 2, 5}) {
        const auto work = [](std::size_t k) {
            if (k == 700) throw std::runtime_error("seven hundred");
        };
        CHECK_THROWS_AS(for_each_index(1000, threads, work), std::runtime_error);
    }
}

TEST_CASE("work that tells of its progress has every index once, and only the calling thread is heard") {
    for (const int threads : {1, 2, 5}) {
        std::vector<int> turns(200, 0);
        const auto caller = std::this_thread::get_id();
        bool others_heard = false;
        const Progress progress = [&](std::string_view, double) {
            others_heard = others_heard || std::this_thread::get_id() != caller;
        };
        for_each_index(turns.size(), threads, "work", progress, [&](std::size_t k, const Progress& told) {
            ++turns[k];
            report(told, "turn", 0.5);
        });
        CHECK(turns == std::vector<int>(200, 1));
        CHECK_FALSE(others_heard);
    }
}

TEST_CASE("what the progress throws ends the work of all threads and comes out") {
    struct Enough {};
    for (const int threads : {1, 2, 5}) {
        int told = 0;
        const Progress progress = [&](std::string_view, double) {
            if (++told > 3) throw Enough{};
        };
        // No call comes to an end by itself.
        const auto work = [](std::size_t, const Progress& progress_of_thread) {
            while (true) report(progress_of_thread, "for ever", 0);
        };
        CHECK_THROWS_AS(for_each_index(8, threads, "work", progress, work), Enough);
    }
}
