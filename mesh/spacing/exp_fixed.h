/// exp and log by one fixed sequence of + - * /, the same bits on every machine.
///
/// libm's versions differ between machines (it picks variants by processor), and the spacing
/// decides coordinates. Source: range reduction by powers of 2 and the Taylor series of exp and
/// artanh.
#pragma once

namespace tetfarm {

/// e^x, relative error below 4e-16. 0 below -700, infinite above 700. Cost: some 20 flops.
double exp_fixed(double x);

/// Natural logarithm, absolute error below 4e-16 (1 + |log x|). @pre x is positive, finite and
/// normal. Cost: some 25 flops.
double log_fixed(double x);

}  // namespace tetfarm
