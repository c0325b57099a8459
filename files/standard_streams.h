#pragma once
// Standard input, output and error of a program that was started without them.

namespace rinceau {

/// Opens those that are closed, such that reading finds nothing, writing to standard output fails, and messages go nowhere.
/// Otherwise the first file that the program opens would take their place, and messages would be written into it. To be
/// called first of all.
void open_standard_streams();

}  // namespace rinceau
