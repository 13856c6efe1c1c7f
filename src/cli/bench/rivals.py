"""Other people's tools at the same sweep and the same bodies: SciPy with numba, CasADi's CVODES, diffrax, and MuJoCo's own loop.

The board's accelerations are those of accelerations.generated.json, operation by operation, written out for each tool. Projection,
events and rows are left out: none of the tools has them. Reads a request from standard input as JSON, prints one line of JSON: what
the rival named took, or why it was skipped. Processor time of the process, after a run that compiles everything.
"""

import json
import os
import statistics
import sys
import time

for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[name] = "1"
os.environ["XLA_FLAGS"] = "--xla_cpu_multi_thread_eigen=false intra_op_parallelism_threads=1"

BINARY = {"add": "+", "sub": "-", "mul": "*", "div": "/"}


def source(request, name, head, indent, module, last):
    """A function of y that returns [v, a], as text. @param last its last lines, of the names of a"""
    ops, constants = request["tape"]["ops"], dict(zip(request["tape"]["prepare"], request["constants"]))
    wanted = request["tape"]["sets"][request["set"]]["rate"]
    needed, waiting = set(), list(wanted)
    while waiting:
        i = waiting.pop()
        if i in needed:
            continue
        needed.add(i)
        if i not in constants and ops[i][0] not in ("input", "const"):
            waiting += ops[i][1:]
    n = len(wanted) // 2
    lines = [head.format(name=name)]
    for i in sorted(needed):
        kind, *of = ops[i]
        if i in constants:
            text = repr(constants[i])
        elif kind == "const":
            text = repr(of[0])
        elif kind == "input":
            text = "0.0" if of[0] == "f" else f"y[{of[1] + (n if of[0] == 'v' else 0)}]"
        elif kind in BINARY:
            text = f"x{of[0]} {BINARY[kind]} x{of[1]}"
        elif kind == "neg":
            text = f"-x{of[0]}"
        else:
            text = f"{module}.{kind}(x{of[0]})"
        lines.append(f"{indent}x{i} = {text}")
    return "\n".join([*lines, indent + last.format(", ".join(f"x{i}" for i in wanted))])


def made(text, name, **names):
    exec(text, names)
    return names[name]


def timed(work):
    """Milliseconds of processor time of the second call, and what it gave."""
    work()
    start = time.process_time()
    result = work()
    return 1000 * (time.process_time() - start), result


def scipy_numba(request):
    import math

    import numba
    import numpy as np
    import scipy
    from scipy.integrate import solve_ivp

    text = source(request, "f", "def {name}(t, y):", "    ", "math", "return np.array(({}))")
    f = numba.njit(made(text, "f", math=math, np=np))
    starts = [np.array(y) for y in request["starts"][: request["few"]]]
    solve = lambda y: solve_ivp(f, (0, request["until"]), y, "RK45", rtol=request["rtol"], atol=request["atol"]).y[:, -1]
    took, ends = timed(lambda: [solve(y) for y in starts])
    return f"SciPy {scipy.__version__} RK45, numba {numba.__version__}", took / len(starts), ends


def casadi_cvodes(request):
    import casadi

    y = casadi.SX.sym("y", len(request["starts"][0]))
    f = made(source(request, "f", "def {name}(y):", "    ", "casadi", "return casadi.vertcat({})"), "f", casadi=casadi)
    options = {"reltol": request["rtol"], "abstol": request["atol"], "max_num_steps": 1000000}
    solver = casadi.integrator("solver", "cvodes", {"x": y, "ode": f(y)}, 0, request["until"], options)
    starts = request["starts"][: request["few"]]
    took, ends = timed(lambda: [[float(x) for x in solver(x0=y)["xf"].full().ravel()] for y in starts])
    return f"CasADi {casadi.__version__} CVODES", took / len(starts), ends


def diffrax_vmap(request):
    import jax

    jax.config.update("jax_enable_x64", True)
    import diffrax
    import jax.numpy as jnp

    text = source(request, "f", "def {name}(t, y, args):", "    ", "jnp", "return jnp.stack([jnp.asarray(x) for x in ({})])")
    term = diffrax.ODETerm(made(text, "f", jnp=jnp))
    control = diffrax.PIDController(rtol=request["rtol"], atol=request["atol"])

    def end(y):
        return diffrax.diffeqsolve(
            term, diffrax.Dopri5(), 0.0, request["until"], None, y, stepsize_controller=control, max_steps=None
        ).ys[-1]

    every = jax.jit(jax.vmap(end))
    starts = jnp.array(request["starts"])
    took, ends = timed(lambda: every(starts).block_until_ready())
    return f"diffrax {diffrax.__version__} Dopri5, vmap", took / len(starts), ends.tolist()


def mujoco_rollout(request):
    import mujoco
    import numpy as np
    from mujoco import rollout

    best = float("inf")
    for xml in request["models"]:
        model = mujoco.MjModel.from_xml_string(xml)
        data = mujoco.MjData(model)
        model.opt.timestep = 1e-5
        state = np.empty(mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_FULLPHYSICS))
        mujoco.mj_getState(model, data, state, mujoco.mjtState.mjSTATE_FULLPHYSICS)
        steps = 20000
        took, _ = timed(lambda: rollout.rollout(model, data, state[None, :], nstep=steps))
        best = min(best, took / steps)
    return f"MuJoCo {mujoco.__version__} rollout, per step of its own", best, None


RIVALS = {"scipy": scipy_numba, "casadi": casadi_cvodes, "diffrax": diffrax_vmap, "mujoco": mujoco_rollout}


def main():
    request = json.load(sys.stdin)
    name = sys.argv[1]
    try:
        label, took, ends = RIVALS[name](request)
    except ImportError as error:
        print(json.dumps({"name": name, "skipped": str(error)}))
        return
    errors = [max(abs(a - b) for a, b in zip(truth, end)) for truth, end in zip(request["ends"], ends or [])]
    error = statistics.median(errors) if errors else None
    print(json.dumps({"name": name, "label": label, "milliseconds": took, "error": error}))


main()
