"""Angular velocity from a rotation matrix: hat(omega) = R^T R_dot (report Eq. 13 and 14).

The frames of `rotations` build omega by composition; this module is the definition, and the
derivation's tests hold the two against each other.
"""

import sympy as sp


def hat(w: sp.Matrix) -> sp.Matrix:
    """The skew-symmetric matrix with hat(w) x = w cross x."""
    return sp.Matrix([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])


def vee(S: sp.Matrix) -> sp.Matrix:
    """Entries [3,2], [1,3], [2,1] of a skew-symmetric matrix (Eq. 14)."""
    return sp.Matrix([S[2, 1], S[0, 2], S[1, 0]])


def body_angular_velocity(R: sp.Matrix, q: sp.Matrix, v: sp.Matrix) -> sp.Matrix:
    """omega in body axes of a body with attitude R(q) at velocities v."""
    R_dot = sp.zeros(3, 3)
    for i, qi in enumerate(q):
        R_dot += R.diff(qi) * v[i]
    return vee(R.T * R_dot)
