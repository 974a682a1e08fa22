"""What is measured: for each workload its sizes and who takes part."""

from dataclasses import dataclass

POLYNOMIALS = ("SymPy expand", "SymPy ring", "Maxima rat", "GiNaC expand", "Singular", "PARI",
               "FLINT mpoly")


@dataclass(frozen=True)
class Workload:
    title: str
    sizes: tuple
    quick: tuple
    peers: tuple
    size: str = "n"
    # Whether a growth exponent is fitted.
    fit: bool = False


WORKLOADS = {
    "W1": Workload("Coons patch of degree-n Bézier edges = Bézier patch of the discrete Coons net",
                   (3, 5, 8, 12, 20, 40), (3, 8, 12), POLYNOMIALS, fit=True),
    "W2": Workload("∂⁴r/∂u²∂v² = 0 for the same patch",
                   (3, 5, 8, 12, 20, 40), (3, 8, 12), POLYNOMIALS, fit=True),
    "W3": Workload("permanence: the part over a symbolic rectangle is the Coons patch of its edges",
                   (3, 5, 8, 12, 20), (3, 5, 8), POLYNOMIALS, fit=True),
    "W4": Workload("clamped uniform bicubic net of n x n rational points: all Bézier segments join C²",
                   (5, 10, 20, 50, 200), (5, 10, 20),
                   ("SymPy numbers", "CLN (GiNaC's numbers)", "PARI", "FLINT fmpq"), fit=True),
    "W5": Workload("the Coons patch has the least twist energy among nets of n x n degrees",
                   (3, 5, 8, 12, 16), (3, 5),
                   ("SymPy matrix", "Maxima matrix", "GiNaC matrix", "Singular", "PARI", "FLINT matrix")),
    "W6": Workload("the Jacobian of a plane patch is positive on the unit square",
                   (3, 8, 12), (3, 8), ("SymPy (Python integers)", "PARI", "FLINT fmpz")),
    "W7": Workload("whole processes: so many small claims from text, start-up included",
                   (1, 1000), (1, 1000), (), size="claims"),
}
