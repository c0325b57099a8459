#pragma once
// What the program's exit status says.

namespace rinceau {

namespace exit_status {
constexpr int done = 0;
constexpr int input_at_fault = 1;
constexpr int command_line_at_fault = 2;
constexpr int limit_reached = 3;
constexpr int output_not_written = 4;
constexpr int some_failed = 5;        ///< of many drawings; the report says which and why
constexpr int program_at_fault = 70;  ///< as sysexits.h has it
}  // namespace exit_status

}  // namespace rinceau
