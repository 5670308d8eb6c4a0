#!/usr/bin/env python3
"""Our eigen solver beside others: same K and M, same number of modes, one thread, CPU seconds and memory.

    python3 bench/peers.py tet4 tet10 solid hollow [--repeat 3] [--release] [--keep DIR]

Runs `cargo xtask pencil` for the matrices and our own figures, then each peer in a process of its
own, so many times in turn. A peer that is not installed is named and left out:

  eigsh+CHOLMOD  pip install scipy scikit-sparse==0.4.16    (Debian: libsuitesparse-dev)
  SLEPc          apt install python3-slepc4py-real python3-scipy    (Debian's own Python)
  both           apt install libopenblas0    (with the reference BLAS that Debian installs by itself
                 they are slower; which one served is told below the table)

A peer starts from matrices in memory and factors K - sigma M, sigma = -(2 pi 200 Hz)^2, once, by
sparse Cholesky; its eigenvalues are converged to 1e-9. Rigid motions are asked for and left out.
Memory is what each process holds at most while it solves, the matrices, Python and libraries included.
"""

import argparse
import glob
import json
import os
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
RIGID = 6
SHIFT = -((2 * 3.141592653589793 * 200) ** 2)
TOLERANCE = 1e-9
ONE_THREAD = {f"{name}_NUM_THREADS": "1" for name in ("OMP", "OPENBLAS", "MKL", "BLIS")}


def told(command, **more):
    """The line of JSON that a command ends with."""
    done = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True, **more)
    return json.loads(done.stdout.splitlines()[-1])


def pencil(body, release):
    """The repository's own command."""
    cargo = ["cargo", "run", "--quiet", "-p", "xtask"] + (["--release"] if release else [])
    return cargo + ["--", "pencil", body]


def read(folder):
    import scipy.io
    import scipy.sparse

    return [scipy.sparse.csc_matrix(scipy.io.mmread(f"{folder}/{name}.mtx")) for name in "KM"]


def start_vector(n):
    import numpy

    return numpy.random.default_rng(0).standard_normal(n)


def cholmod(stiffness, mass, wanted):
    from scipy.sparse.linalg import LinearOperator, eigsh
    from sksparse.cholmod import cholesky

    factor = cholesky((stiffness - SHIFT * mass).tocsc(), mode="supernodal")
    inverse = LinearOperator(stiffness.shape, factor.solve_A, dtype=float)
    return eigsh(
        stiffness,
        k=wanted,
        M=mass,
        sigma=SHIFT,
        OPinv=inverse,
        v0=start_vector(stiffness.shape[0]),
        tol=TOLERANCE,
    )


def slepc(stiffness, mass, wanted):
    import numpy
    from petsc4py import PETSc
    from slepc4py import SLEPc

    def matrix(a):
        a = a.tocsr()
        m = PETSc.Mat().createAIJ(size=a.shape, csr=(a.indptr, a.indices, a.data))
        m.setOption(PETSc.Mat.Option.SYMMETRIC, True)
        m.assemble()
        return m

    k, m = matrix(stiffness), matrix(mass)
    eps = SLEPc.EPS().create()
    eps.setOperators(k, m)
    eps.setProblemType(SLEPc.EPS.ProblemType.GHEP)
    eps.setType(SLEPc.EPS.Type.KRYLOVSCHUR)
    eps.setDimensions(wanted)
    eps.setTolerances(TOLERANCE, 500)
    eps.setTarget(SHIFT)
    eps.setWhichEigenpairs(SLEPc.EPS.Which.TARGET_MAGNITUDE)
    transform = eps.getST()
    transform.setType(SLEPc.ST.Type.SINVERT)
    solver = transform.getKSP()
    solver.setType(PETSc.KSP.Type.PREONLY)
    solver.getPC().setType(PETSc.PC.Type.CHOLESKY)
    solver.getPC().setFactorSolverType("mumps")
    eps.solve()
    found = min(eps.getConverged(), wanted)
    values, vectors = numpy.empty(found), numpy.empty((stiffness.shape[0], found))
    vector, _ = k.getVecs()
    for i in range(found):
        values[i] = eps.getEigenpair(i, vector).real
        vectors[:, i] = vector.getArray()
    return values, vectors


def blas():
    """The libraries in this process that are a BLAS, where the system tells them."""
    try:
        with open("/proc/self/maps") as maps:
            files = {os.path.basename(line.split()[-1]) for line in maps if ".so" in line}
    except OSError:
        return "a BLAS that this system does not tell"
    kinds = ("libblas", "libopenblas", "libmkl", "libblis")
    return ", ".join(sorted(file for file in files if file.startswith(kinds)))


PEERS = {"eigsh+CHOLMOD": cholmod, "SLEPc": slepc}


def forget_peak():
    """Has the kernel measure the peak of this process's memory from here on."""
    with open("/proc/self/clear_refs", "w") as file:
        file.write("5")


def peak_mib():
    with open("/proc/self/status") as file:
        return next(int(line.split()[1]) for line in file if line.startswith("VmHWM:")) / 1024


def peer(name, folder, modes):
    """In a process of its own: one line of JSON, like ours."""
    import numpy

    stiffness, mass = read(folder)
    forget_peak()
    start = time.process_time()
    values, vectors = PEERS[name](stiffness, mass, modes + RIGID)
    spent, peak = time.process_time() - start, peak_mib()
    order = numpy.argsort(values)[RIGID:]
    values, vectors = values[order], vectors[:, order]
    forces = stiffness @ vectors
    errors = numpy.linalg.norm(forces - (mass @ vectors) * values, axis=0)
    hz = numpy.sqrt(values) / (2 * numpy.pi)
    report = {
        "modes": len(values),
        "cpu_s": spent,
        "peak_mib": peak,
        "first_hz": hz[0],
        "last_hz": hz[-1],
        "blas": blas(),
        "worst_residual": float((errors / numpy.linalg.norm(forces, axis=0)).max()),
    }
    print(json.dumps(report))


def python_for(name):
    """A Python that can run the peer, with what it needs around it; None if there is none."""
    surroundings = {**os.environ, **ONE_THREAD}
    needs = "import scipy, sksparse.cholmod"
    if name == "SLEPc":
        needs = "import scipy, petsc4py.PETSc, slepc4py.SLEPc"
        for variable, pattern in (
            ("PETSC_DIR", "/usr/lib/petscdir/petsc*/*-real"),
            ("SLEPC_DIR", "/usr/lib/slepcdir/slepc*/*-real"),
        ):
            for folder in glob.glob(pattern)[:1]:
                surroundings.setdefault(variable, folder)
    for python in (sys.executable, "/usr/bin/python3"):
        test = [python, "-c", needs]
        if os.path.exists(python) and not subprocess.run(
            test, env=surroundings, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        ).returncode:
            return python, surroundings
    return None


def solvers(body, release, folder):
    """Ours, which tells the number of modes, then whichever peers there are: names and functions."""
    own = pencil(body, release) + ["--solve", "--json"]
    yield "ours", lambda modes: told(own, cwd=ROOT)
    for name in PEERS:
        found = python_for(name)
        if found is None:
            print(f"{name}: not installed, left out; see {sys.argv[0]} --help", file=sys.stderr)
            continue
        python, around = found
        command = [python, os.path.abspath(__file__), "--peer", name, "--keep", folder, "--modes"]
        yield name, lambda modes, command=command, around=around: told(
            command + [str(modes)], env=around
        )


def compare(body, repeat, release, folder):
    """In turn, so that all meet the machine in the same moods; of each the run of least time."""
    written = pencil(body, release) + ["--output", folder]
    subprocess.run(written, cwd=ROOT, check=True, stdout=sys.stderr)
    least = {}
    running = dict(solvers(body, release, folder))
    for _ in range(repeat):
        for name, solve in list(running.items()):
            try:
                row = solve(least["ours"]["modes"] if least else None)
            except subprocess.CalledProcessError:
                if name == "ours":
                    raise
                print(f"{name}: failed", file=sys.stderr)
                del running[name]
                continue
            least[name] = min(least.get(name, row), row, key=lambda row: row["cpu_s"])
    own = least["ours"]
    print(f"\n{body}: {own['unknowns']} unknowns\n")
    print("| solver | modes | first Hz | last Hz | worst residual | CPU s | × ours | MiB | × ours |")
    print("|---|---|---|---|---|---|---|---|---|")
    for name, row in least.items():
        print(
            f"| {name} | {row['modes']} | {row['first_hz']:.3f} | {row['last_hz']:.3f} "
            f"| {row['worst_residual']:.1e} | {row['cpu_s']:.2f} "
            f"| {row['cpu_s'] / own['cpu_s']:.2f} | {row['peak_mib']:.0f} "
            f"| {row['peak_mib'] / own['peak_mib']:.2f} |"
        )
    for name, row in least.items():
        if name != "ours":
            print(f"{name} on {row['blas']}")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("bodies", nargs="*", default=["tet4", "tet10", "solid", "hollow"])
    parser.add_argument("--repeat", type=int, default=3, help="least time of so many runs")
    parser.add_argument("--release", action="store_true", help="our command built for release")
    parser.add_argument("--keep", metavar="DIR", help="keep the matrices there")
    parser.add_argument("--peer", choices=PEERS, help=argparse.SUPPRESS)
    parser.add_argument("--modes", type=int, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.peer:
        peer(arguments.peer, arguments.keep, arguments.modes)
        return
    for body in arguments.bodies:
        with tempfile.TemporaryDirectory() as temporary:
            folder = os.path.join(arguments.keep or temporary, body)
            compare(body, arguments.repeat, arguments.release, folder)


if __name__ == "__main__":
    main()
