"""Constrained accelerations as a straight line: `M a = h + Omega^T lambda`, `Omega a + gamma = 0`.

M = L D L^T without square roots (Golub and Van Loan, Matrix Computations, 4th ed., section 4.1.2), in the order of the
unknowns that is given: with those of one branch of a tree of bodies beside one another and what all branches share at the
end, nothing fills in between branches (Featherstone, Rigid Body Dynamics Algorithms, Springer 2008, section 8.3), and the
tape folds every product with a zero. Then S = Omega M^-1 Omega^T, of the order of the rows, in the same way (Benzi, Golub and
Liesen, Acta Numerica 14 (2005), section 5).
"""


class Factors:
    """A = L D L^T of a symmetric matrix given by rows; `pivots` are the entries of D."""

    def __init__(self, matrix):
        n = self.n = len(matrix)
        A = [list(row) for row in matrix]
        self.diagonal = [A[i][i] for i in range(n)]
        self.L = [[None] * n for _ in range(n)]
        self.pivots, self.inverse = [], []
        for j in range(n):
            self.pivots.append(A[j][j])
            self.inverse.append(1 / A[j][j])
            below = [A[i][j] for i in range(n)]
            for i in range(j + 1, n):
                self.L[i][j] = below[i] * self.inverse[j]
            for i in range(j + 1, n):
                for k in range(j + 1, i + 1):
                    A[i][k] = A[k][i] = A[i][k] - self.L[i][j] * below[k]

    def forward(self, b):
        """x of L x = b."""
        x = list(b)
        for i in range(self.n):
            for k in range(i):
                x[i] = x[i] - self.L[i][k] * x[k]
        return x

    def scaled(self, b):
        """D^-1 b."""
        return [x * inverse for x, inverse in zip(b, self.inverse)]

    def back(self, b):
        """x of L^T x = b."""
        x = list(b)
        for i in reversed(range(self.n)):
            for k in range(i + 1, self.n):
                x[i] = x[i] - self.L[k][i] * x[k]
        return x


class Saddle:
    """Both factorizations: of M, and of S = Omega M^-1 Omega^T."""

    def __init__(self, M, Omega):
        self.mass = Factors(M)
        self.rows = [self.mass.forward(row) for row in Omega]
        self.weighted = [self.mass.scaled(row) for row in self.rows]
        self.schur = Factors([[dot(a, b) for b in self.rows] for a in self.weighted])

    def solve(self, h, gamma):
        """(a, lambda)."""
        f = self.mass.forward(h)
        lam = self._multipliers([-g - dot(w, f) for g, w in zip(gamma, self.weighted)])
        return self.mass.back([x + y for x, y in zip(self.mass.scaled(f), self._spread(lam, f))]), lam

    def shift(self, change, zero):
        """The smallest x in the mass metric with Omega x = change."""
        return self.mass.back(self._spread(self._multipliers(change), [zero] * self.mass.n))

    def _multipliers(self, right):
        return self.schur.back(self.schur.scaled(self.schur.forward(right)))

    def _spread(self, lam, like):
        """D^-1 L^-1 Omega^T lambda."""
        return [dot([w[k] for w in self.weighted], lam) if lam else 0 * x for k, x in enumerate(like)]


def dot(a, b):
    total = a[0] * b[0]
    for x, y in zip(a[1:], b[1:]):
        total = total + x * y
    return total
