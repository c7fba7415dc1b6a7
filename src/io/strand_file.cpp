// SPDX-License-Identifier: MIT
#include "io/strand_file.h"

#include "core/error.h"
#include "io/file_name.h"
#include "io/hair_file.h"
#include "io/tfx_file.h"
#include "io/usc_data_file.h"

namespace tress {

bool is_strand_file_name(const std::string& path) {
    const std::string ending = file_ending(path);
    return ending == ".hair" || ending == ".data" || ending == ".tfx";
}

StrandData read_strand_file(const std::string& path) {
    const std::string ending = file_ending(path);
    if (ending == ".data") return read_usc_data_file(path);
    if (ending == ".tfx") return read_tfx_file(path);
    if (ending == ".hair" || has_hair_magic(path)) return read_hair_file(path);
    throw InputError(path, "unknown kind of hair file, expected .hair, .data or .tfx");
}

}  // namespace tress
