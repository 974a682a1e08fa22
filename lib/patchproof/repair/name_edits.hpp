#pragma once

#include <string>
#include <vector>

#include <patchproof/repair/edit.hpp>
#include <patchproof/repair/line.hpp>
#include <patchproof/repair/names.hpp>

namespace patchproof {

/// Adds what a name may become: names of the same kind, and for derivatives like C1'' and r_uv
/// those in other parameters or of another order. `running` are the running indices known there.
void add_name_edits(const syntax::Expression& name, const Names& names,
                    const std::vector<std::string>& running, std::vector<Edit>& edits);

}  // namespace patchproof
