// Sine and cosine for the generators: the same on every machine.
//
// Those of C libraries differ in the last bit, and one library's between processors with and without fused
// multiply-add; a case must be the same everywhere, or its result could not be compared.
#pragma once

namespace oblast::generators {

/// Rounded to nearest but for values within 2^-100 of the middle between two doubles.
/// REQUIRES: |angle| < 2^20.
double sine(double angle);
double cosine(double angle);

}  // namespace oblast::generators
