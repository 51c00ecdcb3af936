// Sine and cosine for the generators: the same on every machine.
//
// The functions of C libraries differ in the last bit, and those of one library differ between processors with and
// without fused multiply-add. A case must be the same everywhere; otherwise its result could not be compared.
#pragma once

namespace oblast::generators {

/// Rounded to nearest, except for values within 2^-100 of the midpoint between two doubles.
/// REQUIRES: |angle| < 2^20.
double sine(double angle);
double cosine(double angle);

}  // namespace oblast::generators
