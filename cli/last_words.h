#pragma once
// What is said when the memory ends where no exception can tell it.

namespace rinceau {

/// Libraries end the program when they get no memory: by abort(), or by going on without. From now on that is said as any
/// other lack of memory, with the exit status for it, if there really is none left when it happens. Any other crash stays
/// one. Processes that are started by fork() inherit this.
void tell_when_memory_ends();

}  // namespace rinceau
