#include "files/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>

namespace rinceau {

void open_standard_streams() {
    constexpr std::array flags{O_RDONLY, O_RDONLY, O_WRONLY};  // of input, output, error
    for (int stream = 0; stream < static_cast<int>(flags.size()); ++stream)
        if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", flags[static_cast<std::size_t>(stream)]);  // the lowest free
}

}  // namespace rinceau
