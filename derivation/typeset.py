"""From a model to the formulas that the page prints, as the text of one JSON file."""

import json
import re

import sympy as sp

from .body_page import BodyPage
from .latex import latex, typeset
from .model import Model
from .notation import Formula, Row, Term, mark, plus, scalar, total

# Entries of a large mass matrix are tried below the first count of operations, and printed below the second.
TRIED, PRINTED = 82, 60
# Entries of constraint rows longer than this are counted instead of printed.
ROW_PRINTED = 160


class Page(BodyPage):
    """The formulas of one model by section; `formulas` holds those that have a value to be checked."""

    # ── energies and equations

    def energies(self) -> dict:
        m = self.model
        if m.rate is not None:
            return {}
        bodies = [b for b in self.bodies if b.mass != 0 or not b.inertia.is_zero_matrix]
        parts = [self.kinetic(b) for b in bodies]
        total = Term(" + ".join(mark(f"T.{b.name}") for b in bodies), sum((p.value for p in parts), sp.Integer(0)), True)
        result = {"kinetic": self.formula("kinetic", "T", total, m.kinetic)}
        result["potential"] = self.formula("potential", "V", scalar(self.summed(m.potential)), m.potential)
        if self.small:
            potential = [scalar(-self.tidy(e)) for e in sp.Add.make_args(m.potential) if e != 0]
            result["lagrangian"] = self.formula("lagrangian", "L = T - V", plus(self.by_rates(m.kinetic), *potential), m.kinetic - m.potential)
        return result

    def summed(self, V):
        """A potential, term by term, each as short as it gets."""
        return sum((self.tidy(term) for term in sp.Add.make_args(sp.sympify(V))), sp.Integer(0))

    @property
    def small(self) -> bool:
        return not self.model.definitions

    def motion(self) -> list:
        """The equations: one line a coordinate where they are small, else in matrices."""
        m = self.model
        if m.rate is not None:
            return [self.formula(f"rate.{s.name}", latex(v), scalar(f), f) for s, v, f in zip(self.q, self.v, m.rate)]
        if not self.small:
            return []
        lines = []
        rows = self.rows_of(m.constraints[0]) if m.constraints else []
        multipliers = [sp.Symbol(f"lambda_{k + 1}", real=True) for k in range(len(rows))]
        for i, q in enumerate(self.q):
            inertia = total([(self.tidy(m.equations.M[i, j]), [a]) for j, a in enumerate(self.a)])
            left = plus(inertia, self.by_rates(-m.equations.h[i])) if m.equations.h[i] != 0 else inertia
            self.formulas.append(Formula(f"motion.{q.name}", "", left, (m.equations.M * self.a)[i] - m.equations.h[i]))
            right = Term(mark(f"Q.{q.name}"), sp.Integer(0))
            force = total([(self.tidy(row.row[i]), [s]) for row, s in zip(rows, multipliers)])
            if force.value != 0:
                self.formulas.append(Formula(f"force.{q.name}", "", force, (m.constraints[0].Omega.T * sp.Matrix(multipliers))[i]))
                right = plus(right, force)
            lines.append(f"{left.latex} = {right.latex}")
        return lines

    def structure(self) -> list:
        """What the matrices are made of; `test_typeset` computes M, h and gamma by these lines."""
        if self.model.rate is not None:
            return []
        constrained = bool(self.model.constraints)
        extra = (r" + Q^{\mathrm{loss}}" if self.note.losses is not None else "") + (r" + Q^{\mathrm{drag}}" if self.model.extra_forces else "")
        lines = [r"M(q)\, \ddot q = h(q, \dot q) + B\, u" + (r" + \Omega(q)^{\mathsf T} \lambda" if constrained else "")]
        if constrained:
            lines.append(r"\Omega(q)\, \dot q = 0, \qquad \Omega\, \ddot q + \gamma = 0, \qquad \gamma = \dot\Omega\, \dot q")
        lines += [
            r"J_b = \dfrac{\partial \dot{\mathbf r}_b}{\partial \dot q}, \qquad W_b = \dfrac{\partial \boldsymbol\omega_b}{\partial \dot q}",
            r"M = \sum_b \left( m_b\, J_b^{\mathsf T} J_b + W_b^{\mathsf T} I_b\, W_b \right)",
            r"h = - \dfrac{\partial V}{\partial q} - \sum_b \left[ m_b\, J_b^{\mathsf T} \dot J_b\, \dot q + W_b^{\mathsf T} "
            r"\left( I_b\, \dot W_b\, \dot q + \boldsymbol\omega_b \times I_b\, \boldsymbol\omega_b \right) \right]" + extra,
        ]
        if constrained:
            lines.append(r"\left( \Omega\, M^{-1} \Omega^{\mathsf T} \right) \lambda = - \gamma - \Omega\, M^{-1} (h + B\, u)")
        return lines

    def mass_matrix(self) -> dict:
        """Entries of M that can be read, upper triangle, and how large those are that cannot."""
        entries, left = [], []
        for i, j in ((i, j) for i in range(len(self.q)) for j in range(i, len(self.q))):
            e = self.entry(i, j)
            count = int(sp.count_ops(e))
            short = self.tidy(e) if count <= TRIED else e
            here = {"row": self.q[i].name, "column": self.q[j].name}
            if short == 0:
                continue
            if sp.count_ops(short) <= PRINTED:
                id = f"mass.{i}.{j}"
                entries.append({**here, "latex": self.formula(id, rf"M_{{{mark(self.q[i].name)},\, {mark(self.q[j].name)}}}", scalar(short), self.model.equations.M[i, j])})
            else:
                left.append({**here, "operations": min(count, int(sp.count_ops(short)))})
        return {"entries": entries, "left": left}

    def entry(self, i, j):
        """M[i, j] from the bodies' Jacobians; their common carriers are turned away where two relative velocities meet."""
        total = sp.Integer(0)
        for body in self.bodies:
            point = body.centre
            P, W_s, W = point.base.jacobian(self.q), self.relative(point), body.frame.W
            lever = (P[:, i], P[:, j], W_s[:, i], W_s[:, j])
            total += body.mass * (lever[0].dot(lever[1]) + lever[2].dot(lever[3]))
            for p, w in ((lever[0], lever[3]), (lever[1], lever[2])):
                if p != sp.zeros(3, 1) and w != sp.zeros(3, 1):
                    total += body.mass * p.dot(point.carrier.R * w)
            total += W[:, i].dot(body.inertia * W[:, j])
        return total

    def relative(self, point):
        kept = self.__dict__.setdefault("_relative", {})
        if id(point) not in kept:
            kept[id(point)] = point.relative_jacobian(self.q)
        return kept[id(point)]

    # ── constraints

    def rows_of(self, c) -> tuple:
        """The rows as they are printed: those of the notation, else Omega's own."""
        if c.id in self.note.rows:
            return self.note.rows[c.id]
        return tuple(Row(title, self.by_rates((row * self.v)[0]), row) for title, row in zip(self.note.titles[c.id], (c.Omega.row(k) for k in range(c.Omega.rows))))

    def constraints(self, c) -> dict:
        lines = []
        for k, row in enumerate(self.rows_of(c)):
            self.formulas.append(Formula(f"{c.id}.{k}", "", row.vanishes, (c.Omega * self.v)[k]))
            entries = []
            for j, q in enumerate(self.q):
                short = self.tidy(row.row[j])
                if sp.count_ops(short) > ROW_PRINTED:
                    entries.append({"column": q.name, "operations": int(sp.count_ops(short))})
                elif short != 0:
                    left = rf"\Omega_{{{k + 1},\, {mark(q.name)}}}"
                    entries.append({"column": q.name, "latex": self.formula(f"{c.id}.{k}.{j}", left, scalar(short), c.Omega[k, j])})
            lines.append({"title": row.title, "latex": f"{row.vanishes.latex} = 0", "entries": entries})
        heights = [self.formula(f"{c.id}.height.{i}", self.note.heights[i], scalar(self.tidy(h)), h) + " = 0" for i, h in enumerate(c.heights)]
        return {"id": c.id, "rows": lines, "heights": heights}

    # ── everything

    def symbols(self) -> dict:
        m, note = self.model, self.note
        names = note.symbols.split()
        known = [*self.q, *m.parameters]
        if len(names) != len(known):
            raise ValueError(f"{m.id}: {len(names)} letters for {len(known)} symbols")
        table = {s.name: typeset(short) for s, short in zip(known, names)}
        for s, short in zip(self.q, names):
            table[f"{s.name}_dot"] = typeset(short, r"\dot")
            table[f"{s.name}_ddot"] = typeset(short, r"\ddot")
            table[f"Q.{s.name}"] = f"Q_{{{typeset(short)}}}"
        table |= {symbol.name: typeset(short) for symbol, short, _ in self.names} | dict(note.marks)
        rows = max((c.Omega.rows for c in m.constraints), default=0)
        table |= {f"lambda_{k + 1}": rf"\lambda_{{{k + 1}}}" for k in range(rows)}
        for name, sub, _ in self.frames:
            table |= {f"R.{name}": f"R_{{{sub}}}", f"omega.{name}": rf"\boldsymbol{{\omega}}_{{{sub}}}"}
            table |= {f"r.{name}": rf"\mathbf r_{{{sub}}}", f"v.{name}": rf"\dot{{\mathbf r}}_{{{sub}}}"}
            table |= {f"T.{name}": f"T_{{{sub}}}", f"I.{name}": f"I_{{{sub}}}"}
        return table

    def document(self) -> dict:
        m = self.model
        document = {
            "system": m.id,
            "symbols": self.symbols(),
            "letters": [self.formula(f"letter.{s.name}", latex(s), scalar(meaning), meaning) for s, _, meaning in self.names],
            "contacts": [self.formula(*given) for given in self.note.contacts],
            "frames": [self.carrier(f"frame.{sub}", frame) for sub, frame in self.note.frames],
            "bodies": [] if m.rate is not None else [self.body(b) for b in self.bodies],
            "energies": self.energies(),
            "motion": self.motion(),
            "losses": [],
            "structure": self.structure(),
            "mass": None if self.small else self.mass_matrix(),
            "constraints": [self.constraints(c) for c in m.constraints],
        }
        if self.note.losses is not None:
            document["losses"] = [self.formula(f"loss.{i}", rf"Q^{{\mathrm{{loss}}}}_{{{mark(self.q[i].name)}}}", self.by_rates(e), e)
                                  for i, e in enumerate(self.note.losses) if e != 0]
        document["losses"] += [self.formula(id, left, right, truth) for id, left, right, truth in self.note.extra]
        used = set(marks_in(json.dumps({k: v for k, v in document.items() if k != "symbols"})))
        keep = {s.name for s in [*self.q, *m.parameters]} | {f"{s.name}_dot" for s in self.q} | {f"Q.{s.name}" for s in self.q} | used
        document["symbols"] = {name: text for name, text in document["symbols"].items() if name in keep}
        return document


def marks_in(text: str):
    return re.findall(r"\\\\s\{([^}]+)\}", text)


def page(model: Model) -> tuple:
    """(document, formulas)."""
    made = Page(model)
    return made.document(), made.formulas


def text(model: Model) -> str:
    return json.dumps(page(model)[0], indent=1) + "\n"
