// Integer primitives of fixed point: products, sine-cosine pairs of binary angles, reciprocals. No branch, no overflow,
// the same bits on every processor and compiler.
#pragma once

#include <axial/scalar/integer_product.hpp>
#include <axial/scalar/integer_reciprocal.hpp>
#include <axial/scalar/integer_sincos.hpp>
