#pragma once

#include <recheck/node_reader.hpp>

namespace recheck {

/// What a certificate says is shown, and why. The tables of the certificate were read before.
Proof proof_of(const Place& place, const Certificate& certificate, const Limits& limits);

/// Values at which a statement is false.
Refutation refutation_of(const Place& place, const Certificate& certificate, const Limits& limits);

/// What is proved or refuted.
Sequent sequent_of(const Place& place, const Certificate& certificate);

/// The index of a node that is a value and contains no bound symbols.
NodeIndex term_at(const Place& place, const Certificate& certificate);
/// The same for a scalar.
NodeIndex scalar_at(const Place& place, const Certificate& certificate);

}  // namespace recheck
