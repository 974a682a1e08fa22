#pragma once

#include <string>

#include <patchproof/certificate/rocq_instances.hpp>

namespace patchproof {

/// The proof of a sign as data of the support library: Done, Step and Split.
std::string rocq_log(const SignProof& proof, Scalars& scalars, RocqTwin& twin,
                     RocqInstances& instances);

}  // namespace patchproof
