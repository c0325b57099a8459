#include "files/output_error.h"

#include <cerrno>
#include <cstring>

namespace rinceau {
namespace {

const char* cure(int code) {
    switch (code) {
        case ENOSPC:
            return "; make room on the disk, or write to another one";
        case EDQUOT:
            return "; your share of the disk is used up: remove files, or write to another disk";
        case EFBIG:
            return "; files as large as this one are not allowed here (ulimit -f)";
        case EIO:
            return "; the disk does not work as it should: write to another one";
        case EROFS:
            return "; write to another disk, this one may only be read";
        case EACCES:
        case EPERM:
            return "; write under another name or in another folder, both the file and its folder must be writable";
        case ENOENT:
        case ENOTDIR:
            return "; make its folder first, or write in another folder";
        default:
            return "";
    }
}

}  // namespace

void fail_output(const std::string& name, int code) {
    throw OutputError(name + ": cannot be written: " + std::strerror(code) + cure(code), code);
}

}  // namespace rinceau
