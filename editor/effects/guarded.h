#pragma once
// Work of which nothing may escape but its answer.

#include <exception>
#include <functional>
#include <new>
#include <string>

namespace rinceau {

/// Runs the work; what it throws is told by `fail`. What is no std::exception, as JobCancelled, passes.
inline void guarded(const std::function<void()>& work, const std::function<void(std::string)>& fail) {
    try {
        work();
    } catch (const std::bad_alloc&) {
        fail("The memory does not suffice");
    } catch (const std::exception& error) {
        fail(error.what());
    }
}

}  // namespace rinceau
